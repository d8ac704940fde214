"""Lock-step: which controllers have answered the present tick, and which are no longer waited for.

A plain class without ROS and without clocks, so that its rules can be tested as they are written here. A robot
that is declared silent is not waited for until its controller is heard again.
"""

from __future__ import annotations

from collections.abc import Sequence

REJOIN_LIMIT = 3
COMMAND, RADIO_MESSAGE = "command", "radio message"


class StepBarrier:
    """The answers of one tick after the other.

    Every robot owes a command; those in `speakers` owe a radio message too.
    """

    def __init__(self, robots: int, speakers: Sequence[int] = ()) -> None:
        spoken = set(speakers)
        self._owed = [{COMMAND, RADIO_MESSAGE} if robot in spoken else {COMMAND} for robot in range(robots)]
        self._missing = [set(owed) for owed in self._owed]
        self._silent: set[int] = set()
        self._rejoined = [0] * robots

    def begin_tick(self) -> None:
        """Everybody owes a new answer."""
        for missing, owed in zip(self._missing, self._owed, strict=True):
            missing.update(owed)

    def owes(self, robot: int, part: str) -> bool:
        """Whether that part belongs to every answer of `robot`."""
        return part in self._owed[robot]

    def answered(self, robot: int, part: str) -> bool:
        """Note one part of the answer of `robot` to the present tick; False if it was given already."""
        self._silent.discard(robot)
        if part not in self._missing[robot]:
            return False
        self._missing[robot].discard(part)
        return True

    def heard(self, robot: int, *, in_time: bool) -> None:
        """The controller of `robot` lives, though this was no answer to the present tick.

        It is waited for again if it follows the clock (`in_time`), but not for ever: one that is late again and
        again would make every tick as long as the patience with it.
        """
        if in_time and robot in self._silent and self._rejoined[robot] < REJOIN_LIMIT:
            self._rejoined[robot] += 1
            self._silent.discard(robot)

    def declare_silent(self, robot: int) -> None:
        """Do not wait for `robot` until it is heard again."""
        self._silent.add(robot)

    def waiting_for(self) -> list[int]:
        """The robots whose answer is awaited, in ascending order."""
        return [robot for robot, missing in enumerate(self._missing) if missing and robot not in self._silent]

    def unanswered(self) -> list[int]:
        """The robots without a full answer, waited for or not."""
        return [robot for robot, missing in enumerate(self._missing) if missing]

    @property
    def silent(self) -> list[int]:
        """The robots that are not waited for."""
        return sorted(self._silent)
