"""What supervisor, physics node and recorder tell each other beside ROS: a few numbers in shared memory.

The physics node tells how far it is, the recorder when the bag is closed; the supervisor, which sees processes die at
once, tells whose controller has died, so that nobody waits for it.
"""

from __future__ import annotations

import multiprocessing
import time


class SharedState:
    """Numbers that live in memory shared by forked processes."""

    def __init__(self, robots: int) -> None:
        context = multiprocessing.get_context("fork")
        self._progress = context.RawArray("q", 2)
        self._moments = context.RawArray("d", 2)
        self._dead = context.RawArray("b", robots)
        self._closed = context.RawValue("b", 0)

    def report(self, tick: int, missing_answers: int) -> None:
        """Physics node: how many ticks are done, how many answers were missing."""
        self._progress[0], self._progress[1] = tick, missing_answers
        self._moments[1] = time.monotonic()
        if tick == 1:
            self._moments[0] = self._moments[1]

    @property
    def ticks(self) -> int:
        """Ticks done."""
        return int(self._progress[0])

    @property
    def missing_answers(self) -> int:
        """Answers that were missing or late."""
        return int(self._progress[1])

    @property
    def seconds(self) -> float:
        """Wall-clock seconds from the end of the first tick to the end of the last."""
        return float(self._moments[1] - self._moments[0])

    def starting_after(self, start: float) -> float:
        """Wall-clock seconds from `start` (monotonic clock) to the end of the first tick."""
        return max(0.0, float(self._moments[0]) - start) if self._moments[0] else 0.0

    def mark_closed(self) -> None:
        """Recorder: the recording is complete."""
        self._closed.value = 1

    @property
    def closed(self) -> bool:
        """Whether the recording is complete."""
        return bool(self._closed.value)

    def mark_dead(self, robot: int) -> None:
        """Supervisor: the controller of this robot has died."""
        self._dead[robot] = 1

    def dead(self) -> list[int]:
        """Robots whose controller has died."""
        return [robot for robot, flag in enumerate(self._dead) if flag]
