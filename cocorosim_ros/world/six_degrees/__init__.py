"""Motion in six degrees of freedom: vehicles that roll and pitch, beside those of `world.motion`, which never do."""
