"""Lateness that all readings of a robot share: against nothing but the commands can it be seen.

Whether all readings are stamped late, or commands act late by as much, the course between them is the same. So the
filter leaves the readings where they are and moves the commands. Moved readings would cross its grid points, which
makes the likelihood rough, and the first of them would fall before its begin.
"""

from __future__ import annotations

from collections.abc import Iterable

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Floats


def clocks_of(log: RobotLog) -> tuple[str, ...]:
    """Names of the streams of a robot that have readings, and with them stamps."""
    return tuple(name for name, stream in log.streams.items() if len(stream.time))


def common_lateness(row: Floats, clocks: Iterable[str]) -> float:
    """Time [s] by which a row (columns,) has all of these streams late; negative where all are early.

    It is the latency that is nearest to zero, and zero where some are late and others early.
    """
    latencies = [float(row[COLUMN[f"sensor_latency.{name}"]]) for name in clocks]
    if not latencies:
        return 0.0
    return max(min(latencies), 0.0) + min(max(latencies), 0.0)
