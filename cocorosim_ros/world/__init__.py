"""The model: what the robots are, how they move, sense, talk and decide, in what water. One text for all users."""
