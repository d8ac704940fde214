"""What recordings say of each robot: read, checked before any physics is blamed, cleaned, on one clock."""
