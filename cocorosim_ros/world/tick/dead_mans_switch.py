"""Free-running: when a controller that is no longer heard loses its robot's actuators.

A plain class without ROS and without a clock, as StepBarrier is for lock-step. Silence counts from the first tick after
the last word, not from that word: at a slow rate a controller has nothing to answer for a long time.
"""

from __future__ import annotations

from collections.abc import Iterable


class DeadMansSwitch:
    """Since when each controller owes an answer. Moments are seconds of any clock that does not go backwards."""

    def __init__(self, robots: int, patience: float) -> None:
        """`patience`: s that an answer may be owed."""
        self._patience = patience
        self._owing: list[float | None] = [None] * robots
        self._off = [False] * robots
        self._mourned: set[int] = set()

    def begin_tick(self, moment: float) -> None:
        """Every controller has readings to answer from now on; an answer that is owed already is owed for longer."""
        self._owing = [moment if since is None else since for since in self._owing]

    def excuse(self, seconds: float) -> None:
        """Let so long count for nothing, in which no controller had anything to answer."""
        self._owing = [None if since is None else since + seconds for since in self._owing]

    def heard(self, robot: int) -> bool:
        """Note a command of `robot`; True if its switch was off, so that the command turns its actuators on again."""
        was_off, self._off[robot] = self._off[robot], False
        self._owing[robot] = None
        return was_off

    def off(self, robot: int) -> None:
        """Turn the switch of `robot` off, for a reason outside this class."""
        self._off[robot] = True

    def newly_dead(self, dead: Iterable[int]) -> list[int]:
        """Turn off, and return in ascending order, the robots whose controller has died since the last call.

        A death counts once: another controller may take the robot over.
        """
        died = sorted(set(dead) - self._mourned)
        self._mourned.update(died)
        return [robot for robot in died if self._turned_off(robot)]

    def newly_silent(self, moment: float) -> list[int]:
        """Turn off, and return in ascending order, the robots that have owed an answer for longer than the patience."""
        late = (robot for robot, since in enumerate(self._owing) if since is not None and self._is_long(moment - since))
        return [robot for robot in late if self._turned_off(robot)]

    def _is_long(self, seconds: float) -> bool:
        return seconds > self._patience

    def _turned_off(self, robot: int) -> bool:
        """Turn the switch off; False if it was off already."""
        was_off, self._off[robot] = self._off[robot], True
        return not was_off
