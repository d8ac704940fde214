"""The constants of a pressure reading by the contract, and of the weight at rest that an accelerometer shows."""

from __future__ import annotations

SURFACE_PRESSURE = 101325.0  # Pa, standard atmosphere
GRAVITY = 9.81  # m/s^2
PASCAL_PER_METRE = 1000.0 * GRAVITY  # of depth, in fresh water
