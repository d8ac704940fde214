"""EQUATIONS: what a law that no catalogue has can act on. The place in the table is the code that a law carries."""

from __future__ import annotations

EQUATIONS = ("surge", "sway", "heave", "yaw", "world_x", "world_y", "world_z")
