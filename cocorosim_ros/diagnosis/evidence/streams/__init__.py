"""The clean streams of one robot, and what they say of its motion and noise."""
