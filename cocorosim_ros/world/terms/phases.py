"""The phase of what swings in time, as a shape of an entry."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from cocorosim_ros.world.terms.search import Scene


def phases(scene: Scene) -> list[float]:
    """The grid of a phase [rad]; the other half of the circle is the other sign."""
    return [index * math.pi / 6.0 for index in range(6)]


def phased(column: str) -> Callable[[Mapping[str, float]], list[tuple[dict[str, float], float]]]:
    """A basis for any phase, which stands in `column`: sin(w t + phase) = cos(phase) sin(w t) + sin(phase) cos(w t)."""

    def basis(values: Mapping[str, float]) -> list[tuple[dict[str, float], float]]:
        parts = ((0.0, math.cos(values[column])), (0.5 * math.pi, math.sin(values[column])))
        return [({**values, column: at}, weight) for at, weight in parts]

    return basis
