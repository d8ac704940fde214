"""Vehicles with six degrees of freedom, of which the tool has platform files: an ROV and a slender AUV."""
