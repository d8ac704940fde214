"""What a robot perceives: ideal measurements, one file per instrument."""
