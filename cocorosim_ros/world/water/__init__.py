"""The world around the robots: the tank and who is near whom."""
