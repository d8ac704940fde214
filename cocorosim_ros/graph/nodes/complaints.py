"""What has gone wrong with which robot: said once on `/diagnostics` and to whoever runs the node."""

from __future__ import annotations

import sys
from collections.abc import Callable

from cocorosim_ros.graph.nodes.wiring import Speaker
from cocorosim_ros.wire.cdr.status import robot_status

MOST_PER_ROBOT = 12
WARNING = "warning: "  # begins such a line, so that a supervisor finds it in a log


def tell_on_terminal(words: str) -> None:
    """Write a warning to standard error."""
    sys.stderr.write(f"{WARNING}{words}\n")
    sys.stderr.flush()


class Complaints:
    """Says every sentence once, and of one robot only so many."""

    def __init__(self, status: Speaker, tell: Callable[[str], None]) -> None:
        """`status` publishes on `/diagnostics`."""
        self._status = status
        self._tell = tell
        self._said: dict[str, set[str]] = {}

    def about(self, robot: str, words: str, stamp_ns: int) -> None:
        """Say what is wrong with a robot at `stamp_ns` of simulated time."""
        said = self._said.setdefault(robot, set())
        if words in said or len(said) > MOST_PER_ROBOT:
            return
        said.add(words)
        if len(said) > MOST_PER_ROBOT:
            words = "still more is wrong; nothing further is said about this robot"
        self._status.publish(robot_status(stamp_ns, robot, words))
        self._tell(f"{robot}: {words}")
