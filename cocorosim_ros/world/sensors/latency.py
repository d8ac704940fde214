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
from cocorosim_ros.world.state.past import Past


class LateReadings:
    """One field of the readings of one robot, in all runs, that comes `latency` [s] late."""

    def __init__(self, field: Field, robot: int, latency: float, tick: float) -> None:
        """`tick` [s] is the time between two readings."""
        self._field, self._robot = field, robot
        self._past = Past(latency, tick)

    def apply(self, readings: Readings) -> None:
        """Put what was measured `latency` ago in place of what was measured now; once at every tick, in order."""
        values: Floats = getattr(readings, self._field.name)
        newer, older = self._past.about(values[:, self._robot])
        change = older - newer
        if self._field.angle:
            change = math.pi - (math.pi - change) % (2.0 * math.pi)
        share = self._past.share
        shown = newer + share * change if share > 0.0 else newer
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
