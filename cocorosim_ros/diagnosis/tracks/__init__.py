"""Tracks: one robot in one recording each, with readings on a grid and the filter's pass over them."""
