"""The clean streams of one robot: noise, outliers, turning, and use of the commands."""
