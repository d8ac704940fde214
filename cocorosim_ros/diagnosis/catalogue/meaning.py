"""The least and the most that numbers of effects can be by their meaning: no more than all of the thrust is lost."""

from __future__ import annotations

import math

from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS

Between = tuple[float, float]
_BETWEEN: dict[str, Between] = {
    f"{name}.{number.name}": number.between
    for name, described in (*EFFECTS.items(), *ERRORS.items())
    for number in described.numbers
}


def between(column: str) -> Between:
    """The least and the most of a number by its column, EFFECT.NUMBER; infinite where its meaning limits nothing."""
    return _BETWEEN.get(column, (-math.inf, math.inf))
