"""The velocity of the water: all currents of a scenario added up.

A flow is one row of numbers, because every array that a compiled function is given costs it time: how many currents
there are; for each its code and where its own numbers begin and end; then those numbers. Still water is an empty row.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.water.currents import CURRENTS

CURRENT_CODE = {name: code for code, name in enumerate(CURRENTS)}
_HEAD = 3


class CurrentAtWork(NamedTuple):
    """A current by its name in CURRENTS, with its numbers in that current's order."""

    name: str
    numbers: Floats


def make_flow(currents: Sequence[CurrentAtWork]) -> Floats:
    """The flow of currents."""
    if not currents:
        return np.zeros(0)
    begins = 1 + _HEAD * len(currents)
    row = [float(len(currents))]
    for name, numbers in currents:
        row += [float(CURRENT_CODE[name]), float(begins), float(begins + len(numbers))]
        begins += len(numbers)
    return np.concatenate([row, *(np.asarray(numbers, dtype=np.float64) for _, numbers in currents)])


add_water_velocity = compile_lines(
    "add_water_velocity",
    "place, time, flow, total",
    [
        "for index in range(int(flow[0]) if flow.shape[0] > 0 else 0):",
        f"    code, head = int(flow[1 + {_HEAD} * index]), 1 + {_HEAD} * index",
        "    numbers = flow[int(flow[head + 1]) : int(flow[head + 2])]",
        *(f"    if code == {code}: {name}(place, time, numbers, total)" for name, code in CURRENT_CODE.items()),
    ],
    {name: current.velocity for name, current in CURRENTS.items()},
)
"""`add_water_velocity(place, time, flow, total)` adds the water's velocity at a place (3,) [m; world] and time [s] to
`total` (3,) [m/s; world]."""
