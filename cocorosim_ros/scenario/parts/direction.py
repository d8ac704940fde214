"""Directions in the body, as files write them: any length but zero."""

from __future__ import annotations

import math

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import quantity_text, read_vector
from cocorosim_ros.scenario.reading.records import stored

Vector3 = tuple[float, float, float]
_UNIT_LENGTH_TOLERANCE = 1e-12


def _read_direction(entry: Entry) -> tuple[float, ...]:
    direction = read_vector(entry, ["pure number"] * 3)
    norm = math.hypot(*direction)
    if norm == 0:
        raise entry.problem(f"has {entry.found()}, which points nowhere; write e.g. [1, 0, 0] for forward.")
    # A vector that is already of unit length stays as it is, bit for bit.
    return direction if abs(norm - 1) < _UNIT_LENGTH_TOLERANCE else tuple(part / norm for part in direction)


def _direction_tree(direction: Vector3) -> list[str]:
    return [quantity_text(part, "pure number") for part in direction]


DIRECTION = stored(_read_direction, _direction_tree, form="list of 3: a direction in the body, not all zero")
