"""What must hold between the parts of a scenario, and the random numbers that follow from its seed."""
