"""Which effects are missing: contest, held-out test, pruning, what the recordings could show."""
