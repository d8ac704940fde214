"""Groups of effects that look alike: where one of a group explains something, all others are tried as well."""

from __future__ import annotations

DRAG = "drag"
MOVING_WATER = "water that moves"
LATE = "late"
COURSE = "course beside heading"
TURN = "turns by itself"
WEIGHT = "weight"
MEASURE = "measure of lengths"
