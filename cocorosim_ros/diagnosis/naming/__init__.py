"""Naming of missing effects: contest, held-out test, pruning, and what the recordings could have shown."""
