"""Maximum likelihood fits of tracks: unknowns, recalibration, screening of candidates."""
