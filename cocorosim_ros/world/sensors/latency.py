"""Readings that come late: what is shown was measured so long ago, by a straight line between two ticks.

Before a reading is old enough the first one is shown: what a robot at rest would have measured before the start.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.errors.sensor_latency import LATE_TOPICS
from cocorosim_ros.world.sensors.readings import Readings
from cocorosim_ros.world.sensors.sensor import Field


class LateReadings:
    """One field of the readings of one robot, in all runs, that comes `latency` [s] late."""

    def __init__(self, field: Field, robot: int, latency: float, tick: float) -> None:
        """`tick` [s] is the time between two readings."""
        whole, self._share = divmod(latency / tick, 1.0)
        self._whole = int(whole)
        self._field, self._robot = field, robot
        self._past: list[Floats] = []  # the newest last

    def apply(self, readings: Readings) -> None:
        """Put what was measured `latency` ago in place of what was measured now; once at every tick, in order."""
        values: Floats = getattr(readings, self._field.name)
        self._past = [*self._past[-(self._whole + 1) :], values[:, self._robot].copy()]
        newer = self._past[max(0, len(self._past) - 1 - self._whole)]
        older = self._past[max(0, len(self._past) - 2 - self._whole)]
        change = older - newer
        if self._field.angle:
            change = math.pi - (math.pi - change) % (2.0 * math.pi)
        shown = newer + self._share * change if self._share > 0.0 else newer
        if self._field.angle:
            shown = math.pi - (math.pi - shown) % (2.0 * math.pi)
        values[:, self._robot] = shown


def late_readings(latency: Floats, tick: float) -> list[LateReadings]:
    """What comes late of `latency` (robots, LATE_TOPICS) [s], at ticks of so many seconds."""
    return [
        LateReadings(field, int(robot), float(latency[robot, column]), tick)
        for column, topic in enumerate(LATE_TOPICS)
        for robot in np.flatnonzero(latency[:, column])
        for field in SENSORS[topic].fields
    ]
