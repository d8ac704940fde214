"""The constant that a pressure reading is counted from."""

from __future__ import annotations

SURFACE_PRESSURE = 101325.0  # Pa, standard atmosphere
