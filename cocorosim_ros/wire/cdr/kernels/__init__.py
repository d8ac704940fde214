"""What is read from bytes by compiled functions."""
