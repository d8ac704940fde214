"""The numbers of one vehicle: from a platform to the row that compiled loops read."""
