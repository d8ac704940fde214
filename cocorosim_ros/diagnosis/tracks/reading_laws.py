"""Laws of readings that no catalogue has: what they add to each reading along the course that a robot has swum.

What a law depends on is known far better than what the law does, because the camera sees it: it is taken from the
smoothed course as given, so that the filter has nothing to know of such laws.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.filter.records import Readings
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL, READING_LAWS
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.world.sensors.law import LAW_OF_READING, READINGS_OF_LAWS, SENSOR_LAWS
from cocorosim_ros.world.terms.regressors import REGRESSORS

_PARTS = len(LAW_OF_READING)
_FIRST = tuple(COLUMN[f"{place}.coefficient"] for place in SENSOR_LAWS)
_KIND = np.array([KIND_NAMES.index(name) for name in READINGS_OF_LAWS])


class Course(NamedTuple):
    """What laws of readings depend on, at the grid points of a track."""

    time: Floats  # (points,) [s]
    state: Floats  # (points, 8 or more) x y z yaw u v w r
    thrust: Floats  # (points, 4) of the thrusters [N, N, N, N m; body]
    force: Floats  # (points, actuators) [N]
    rate: Floats  # (points, actuators) [N/s]
    is_pump: Flags  # (actuators,)
    water: tuple[Floats, Floats]  # lowest and highest corner [m; world]


def without_laws(row: Floats) -> Floats:
    """The numbers of a model that has no laws of readings."""
    plain = row.copy()
    chosen = [COLUMN[name] for name in READING_LAWS]
    plain[chosen] = NEUTRAL[chosen]
    return plain


def law_shift(row: Floats, readings: Readings, course: Callable[[], Course]) -> Floats | None:
    """(m,) what the laws in `row` add to the readings, in their order; None if it has none. `course` is asked once."""
    laws = [row[first : first + _PARTS] for first in _FIRST if row[first] != 0.0]
    if not laws:
        return None
    seen = course()
    point = np.repeat(np.arange(len(readings.first) - 1), np.diff(readings.first))
    moment = readings.begin + point * readings.step + readings.after
    shift = np.zeros(len(moment))
    for coefficient, kind, *factors in laws:
        chosen = readings.kind == _KIND[int(kind)]
        at = np.clip(moment[chosen], seen.time[0], seen.time[-1])
        law = coefficient * _powered(seen, at, *factors[:3]) * _powered(seen, at, *factors[3:])
        shift[chosen] += np.where(np.isfinite(law), law, 0.0)
    return shift


def _powered(seen: Course, at: Floats, code: float, power: float, signed: float) -> Floats:
    """One factor of a law at these moments [s], to its power."""
    name = REGRESSORS[int(code)].name
    if name == "t":
        values = at
    else:
        # What actuators deliver is a mean from each grid point to the next.
        late = 0.5 * (seen.time[1] - seen.time[0]) if name in _OF_ACTUATORS else 0.0
        values = np.interp(at, seen.time + late, _along(seen, name, signed != 0.0))
    size = np.abs(values) ** power
    return np.asarray(np.sign(values) * size if signed != 0.0 else size)


def _along(seen: Course, name: str, signed: bool) -> Floats:
    """A regressor at the grid points."""
    if name in _STATE:
        return seen.state[:, _STATE[name]]
    if name == "thrust" and not signed:
        return np.asarray(np.abs(seen.force[:, ~seen.is_pump]).sum(axis=1))
    return np.asarray(_OTHERS[name](seen))


def _clearance(seen: Course) -> Floats:
    """Distance to the nearest of walls, floor and surface [m]."""
    place = seen.state[:, :3]
    return np.asarray(np.minimum(place - seen.water[0], seen.water[1] - place).min(axis=1))


_STATE = {"x": 0, "y": 1, "z": 2, "u": 4, "v": 5, "w": 6, "r": 7}
_OF_ACTUATORS = ("thrust", "yaw_command", "pump", "pump_rate")
_OTHERS: dict[str, Callable[[Course], Floats]] = {
    "1": lambda seen: np.ones(len(seen.time)),
    "speed": lambda seen: np.linalg.norm(seen.state[:, 4:7], axis=1),
    "thrust": lambda seen: seen.thrust[:, 0],
    "yaw_command": lambda seen: seen.thrust[:, 3],
    "pump": lambda seen: seen.force[:, seen.is_pump].sum(axis=1),
    "pump_rate": lambda seen: seen.rate[:, seen.is_pump].sum(axis=1),
    "sin_yaw": lambda seen: np.sin(seen.state[:, 3]),
    "cos_yaw": lambda seen: np.cos(seen.state[:, 3]),
    "wall_distance": _clearance,
}
