"""Whether what a plain Python controller answers can be carried out, and how it becomes a request and a message."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, SupportsFloat

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers.plain.answers import Command, Course
from cocorosim_ros.world.controllers.request import (
    DIRECT,
    DIVE,
    DIVE_AT_SPEED,
    DIVE_MODE,
    DIVE_TO_DEPTH,
    FRACTIONS,
    HEADING,
    SPEED,
    TURN_GAIN,
)
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, PAYLOAD_LIMIT

_LONGEST_SHOWN = 60
_MEANS = {"radio": "radio", "blue_light": "blue-light sensors", "acoustic": "acoustic modem"}
_ANSWERS = "return {actuator: fraction}, Command(...) or Course(...)"


class AnswerCheck:
    """Carries out the answers of one robot's controller; the end of a sentence, as ValueError, says what is wrong."""

    def __init__(self, robot: RobotDescription, medium: str) -> None:
        """`medium`: over which of MEDIA the controller speaks."""
        sensors = robot.platform.sensors
        self._actuators = robot.platform.actuator_names
        self._mixing = robot.platform.stick_mixing()
        self._platform = robot.platform.name
        self._steers = robot.platform.operating_system is not None
        self._medium = medium
        talks = {"radio": robot.radio_range > 0.0, "blue_light": bool(sensors.blss), "acoustic": robot.acoustic}
        self._talks = talks[medium]

    def carry_out(self, answer: Any, request: Floats, said: Floats) -> None:
        """Write the answer into `request` (controllers.request) and `said` (MESSAGE_SIZE,). Raises ValueError."""
        if isinstance(answer, Course):
            self._write_course(answer, request)
            self._write_message(answer.say, said)
        elif isinstance(answer, Command):
            self._write_command(answer.actuators, request)
            self._write_message(answer.say, said)
        elif isinstance(answer, Mapping):
            self._write_command(answer, request)
            said[:] = 0.0
        else:
            shown = "nothing" if answer is None else f"an object of type '{type(answer).__name__}'"
            raise ValueError(f"{shown}, which is no command; {_ANSWERS}")

    def _write_command(self, actuators: Mapping[str, SupportsFloat], request: Floats) -> None:
        if not isinstance(actuators, Mapping):
            raise ValueError(f"actuators of type '{type(actuators).__name__}'; {_ANSWERS}")
        known = (*self._actuators, *(self._mixing.sticks if self._mixing else ()))
        for name in actuators:
            if name not in known:
                names = ", ".join(known)
                raise ValueError(f"a command for {name!r}, an actuator that the robot does not have; it has {names}")
        asked = {name: _number(value, f"the command of '{name}'", -1.0, 1.0) for name, value in actuators.items()}
        asked = self._mixing.without_sticks(asked) if self._mixing else asked
        request[DIRECT] = 1.0
        for column, name in enumerate(self._actuators, start=FRACTIONS):
            request[column] = asked.get(name, 0.0)

    def _write_course(self, course: Course, request: Floats) -> None:
        if not self._steers:
            raise ValueError(
                f"a Course, but the platform '{self._platform}' has no operating system that could keep it; "
                "return {actuator: fraction} or Command(...)"
            )
        request[DIRECT] = 0.0
        if course.heading is not None:
            request[HEADING] = math.remainder(_number(course.heading, "the heading"), 2.0 * math.pi)
        request[SPEED] = _number(course.speed, "the speed", -1.0, 1.0)
        request[TURN_GAIN] = _number(course.turn_gain, "the turn_gain", 0.0)
        if course.depth is None:
            request[DIVE_MODE], request[DIVE] = DIVE_AT_SPEED, _number(course.climb, "the climb")
        else:
            request[DIVE_MODE], request[DIVE] = DIVE_TO_DEPTH, _number(course.depth, "the depth")

    def _write_message(self, say: Sequence[SupportsFloat], said: Floats) -> None:
        try:
            numbers = [_number(value, "a number to say") for value in say]
        except TypeError:
            raise ValueError(f"'say' of type '{type(say).__name__}'; give a list of numbers") from None
        if len(numbers) > PAYLOAD_LIMIT:
            raise ValueError(f"{len(numbers)} numbers to say; a message has {PAYLOAD_LIMIT} at most")
        if numbers and not self._talks:
            means = _MEANS[self._medium]
            raise ValueError(f"something to say, but the platform '{self._platform}' has no {means}; leave 'say' out")
        said[:] = 0.0
        said[MESSAGE_LENGTH] = len(numbers)
        said[1 : 1 + len(numbers)] = numbers


def _number(value: Any, what: str, least: float = -math.inf, most: float = math.inf) -> float:
    """The value as a float within these limits. Raises ValueError."""
    allowed = "a finite number" if least == -math.inf else f"a number from {least:g}"
    allowed += f" to {most:g}" if most < math.inf else " on" if least > -math.inf else ""
    try:
        number = math.nan if isinstance(value, str) else float(value)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not math.isfinite(number) or not least <= number <= most:
        shown = " ".join((repr(value) if isinstance(value, str) else str(value)).split())
        raise ValueError(f"{what} {shown[:_LONGEST_SHOWN]}; allowed is {allowed}")
    return number
