"""What the robots' instruments show at one tick, in the units of the topics."""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.sensor import PER_CONE, Field

FIELDS: dict[str, Field] = {field.name: field for sensor in SENSORS.values() for field in sensor.fields}
# A named tuple, because compiled loops take it as it is; made from the table, so that a sensor is one file.
_made: Callable[..., Any] = namedtuple
_Fields: Any = _made("_Fields", list(FIELDS))


class Readings(_Fields):  # type: ignore[misc]
    """One tick of all sensors of all robots: an array for each of FIELDS, with leading axes (runs, robots).

    NaN where nobody measures, +inf in ranges where nothing is seen.
    """

    __slots__ = ()

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Floats: ...


def blank_readings(runs: int, robots: int, cones: int) -> Readings:
    """Readings of the given sizes, `cones` blue-light sensors for each robot; NaN everywhere until measured."""
    return Readings(*(np.full((runs, robots, *_axis(field, cones)), np.nan) for field in FIELDS.values()))


def _axis(field: Field, cones: int) -> tuple[int, ...]:
    if field.width is None:
        return ()
    return (cones if field.width == PER_CONE else field.width,)
