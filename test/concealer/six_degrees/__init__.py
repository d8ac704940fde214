"""A second vehicle: an ROV with eight thrusters and six degrees of freedom, of which the tool has a platform file."""
