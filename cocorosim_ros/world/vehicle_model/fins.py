"""From the fins of a platform to the numbers of the effects that act for them in four degrees of freedom."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.effects import FINS


def fins_of(platform: Platform) -> Iterator[tuple[str, Fin]]:
    """Each fin, with the effect that acts for it; none with six degrees of freedom, whose motion has fins itself."""
    if platform.six_degrees is None:
        yield from zip(FINS, (part for part in platform.actuators if isinstance(part, Fin)), strict=False)


def fin_numbers(platform: Platform) -> dict[str, float]:
    """The numbers of all fins by column."""
    return {
        f"{effect}.{name}": value
        for effect, fin in fins_of(platform)
        for name, value in _numbers(platform, fin).items()
    }


def _numbers(platform: Platform, fin: Fin) -> dict[str, float]:
    forward, left, up = fin.direction
    return {
        "actuator": float(platform.actuator_names.index(fin.name)),
        "x": fin.position[0],
        "y": fin.position[1],
        "forward": forward,
        "left": left,
        "up": up,
        "area": fin.area,
        "slope": fin.lift_slope,
        "density": platform.water_density,
        "gain": 1.0 if fin.gain is None else fin.gain,
        "trim": 0.0 if fin.trim is None else fin.trim,
    }


def fin_normals(platform: Platform) -> Floats:
    """(actuators, 3) the normal of each fin [body], zeros for other actuators."""
    return _of_fins(platform, lambda fin: fin.direction)


def fin_places(platform: Platform) -> Floats:
    """(actuators, 3) the centre of pressure of each fin [m; body], zeros for other actuators."""
    return _of_fins(platform, lambda fin: fin.position)


def _of_fins(platform: Platform, vector: Callable[[Fin], Sequence[float]]) -> Floats:
    """(actuators, 3) a vector of each fin, zeros for other actuators."""
    found = np.zeros((len(platform.actuators), 3))
    for _, fin in fins_of(platform):
        found[platform.actuator_names.index(fin.name)] = vector(fin)
    return found


def fin_forces(platform: Platform, speed: float) -> Floats:
    """(4,) amounts of X, Y, Z and N of all fins at their largest angles, straight ahead at a speed [m/s]."""
    total = np.zeros(4)
    for _, fin in fins_of(platform):
        lift = 0.5 * platform.water_density * fin.area * fin.lift_slope * speed**2 * fin.largest_angle
        (x, y, _), (forward, left, _) = fin.position, fin.direction
        total += lift * np.abs([*fin.direction, x * left - y * forward])
    return total
