"""Differences of recordings and simulation, the physics that was left out, and how the fit improves with it."""
