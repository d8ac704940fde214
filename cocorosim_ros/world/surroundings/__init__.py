"""What surrounds robots besides water: the tank, its lamps, and which robots are near each other."""
