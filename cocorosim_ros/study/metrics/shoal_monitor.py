"""The statistics of one swarm, tick by tick: the same numbers live, from a recording and in a batch."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.kept_rows import KeptRows
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.metrics.kernel import measure_tick
from cocorosim_ros.study.metrics.memory import Memory, new_memory
from cocorosim_ros.study.metrics.summary import Summary, summarise


class ShoalMonitor:
    """Measures a swarm whenever it is told where the robots are, and sums up the run at any time."""

    def __init__(self, robots: int) -> None:
        """Start a run of `robots` robots, whose order must stay the same."""
        self._robots = robots
        self.reset()

    def reset(self) -> None:
        """Forget everything: a new run starts."""
        self._memory: Memory = new_memory(1, self._robots)
        self._values = KeptRows((1, len(METRICS)), np.float64)
        self._stamps = KeptRows((1,), np.int64)
        self._ticks_with_absent = 0
        self._bad_poses = 0

    def update(self, stamp_ns: int, positions: ArrayLike, yaw: ArrayLike, present: ArrayLike | None = None) -> Floats:
        """Values (len(METRICS),) at this moment, NaN where a metric is undefined.

        stamp_ns: moment [ns], later than the previous one; positions: (n, 3) [m; world]; yaw: (n,) [rad];
        present: (n,) robots whose pose is known, all if left out. A pose that is not finite makes its robot
        absent. Raises CocorosimError if the stamp does not grow.
        """
        where = np.ascontiguousarray(positions, np.float64).reshape(1, self._robots, 3)
        heading = np.ascontiguousarray(yaw, np.float64).reshape(1, self._robots)
        said = np.ones(self._robots, np.bool_) if present is None else np.ascontiguousarray(present, np.bool_)
        elapsed = self._elapsed_ns(stamp_ns)
        row = self._values.next_row()
        measure_tick(where, heading, said.reshape(1, -1), np.array([elapsed]), self._memory, row)
        self._stamps.next_row()[0] = stamp_ns
        taking_part = int(self._memory.present.sum())
        self._ticks_with_absent += taking_part < self._robots
        self._bad_poses += int(said.sum()) - taking_part
        values: Floats = row[0].copy()
        return values

    @property
    def stamps_ns(self) -> Integers:
        """(ticks,) moments measured so far [ns]."""
        return self._stamps.copy()[:, 0]

    @property
    def series(self) -> Floats:
        """(ticks, len(METRICS)) values measured so far."""
        return self._values.copy()[:, 0]

    def final_series(self) -> Floats:
        """(ticks, len(METRICS)) values of a run that has ended; those of days stay in a file and out of memory."""
        return np.asarray(self._values.final()[:, 0])

    def summary(self) -> dict[str, Any]:
        """The run so far, ready for JSON: undefined numbers are None."""
        summary = summarise(self._values.rows())
        return {
            "ticks": self._stamps.count,
            "robots": self._robots,
            "ticks_with_absent_robots": self._ticks_with_absent,
            "poses_not_finite": self._bad_poses,
            "notes": self._notes(),
            "metrics": {name: _entry(name, summary, column) for column, name in enumerate(METRICS)},
        }

    def _elapsed_ns(self, stamp_ns: int) -> int:
        if self._stamps.count == 0:
            return 0
        before = int(self._stamps.last()[0])
        if stamp_ns <= before:
            raise CocorosimError(
                f"The shoal was measured at {before} ns and then at {stamp_ns} ns: stamps must grow; "
                "sort the poses, or reset the monitor when a recording starts again."
            )
        return stamp_ns - before

    def _notes(self) -> list[str]:
        notes = []
        if self._ticks_with_absent:
            notes.append(
                f"At {self._ticks_with_absent} of {self._stamps.count} ticks a robot was absent: it is left out "
                "of every metric, and it is nobody's neighbour, which can add to the lost count."
            )
        if self._bad_poses:
            notes.append(f"{self._bad_poses} poses held numbers that are not finite; their robots counted as absent.")
        return notes


def _entry(name: str, summary: Summary, column: int) -> dict[str, Any]:
    metric = METRICS[name]
    return {
        "unit": metric.unit,
        "value": _number(summary.value[0, column]),
        "summarised_by": metric.summary,
        "mean": _number(summary.mean[0, column]),
        "median": _number(summary.median[0, column]),
        "ticks": int(summary.defined[0, column]),
        "paper": metric.paper,
        "formula": metric.formula,
    }


def _number(value: np.float64) -> float | None:
    return None if math.isnan(value) else float(value)
