"""Comparison with recordings of the same vehicle when it was well: what is learned, what differs, how alike it was."""
