"""One tick of the world, in order: sense, decide, move."""
