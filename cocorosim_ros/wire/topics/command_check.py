"""What a controller may ask for, and what is done with what it may not."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.stick_mixing import StickMixing
from cocorosim_ros.scenario.reading.entry import quoted
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.swarm_messages import command_message, stick_message


class CommandReader:
    """Reads the commands of one robot."""

    def __init__(self, body: BodyDescription) -> None:
        """`body`: the robot's, with the sticks that it may be commanded by."""
        self._actuators = body.actuators
        self._message = command_message(body)
        self._by_sticks = None if body.mixing is None else _StickReader(body, body.mixing)

    def read(self, data: bytes) -> tuple[Floats, str]:
        """Fractions in -1..1 per actuator from the bytes of a ThrusterCommand, and a complaint ('' for none).

        Not a number or not named: that actuator is off. Beyond 1: cut to 1. Unreadable, or an actuator that the
        robot does not have: all actuators are off. A message names actuators, or sticks and what these do not drive.
        """
        try:
            wanted = self._message.decode(data)
        except CocorosimError as error:
            if self._by_sticks is not None:
                return self._by_sticks.read(data)
            return np.zeros(len(self._actuators)), _unused(error)
        return wanted, "; ".join(_brought_in(wanted, self._actuators))


class _StickReader:
    """Reads commands that name sticks."""

    def __init__(self, body: BodyDescription, mixing: StickMixing) -> None:
        self._message = stick_message(body, mixing)
        self._mixing = mixing
        self._actuators = body.actuators

    def read(self, data: bytes) -> tuple[Floats, str]:
        try:
            wanted = self._message.decode(data)
        except CocorosimError as error:
            driven = quoted(self._mixing.driven)
            told = f"{_unused(error)} A command names sticks, or in their place what they drive, {driven}."
            return np.zeros(len(self._actuators)), told
        complaints = _brought_in(wanted, self._mixing.names)
        asked = self._mixing.without_sticks(dict(zip(self._mixing.names, wanted.tolist(), strict=True)))
        return np.array([asked[name] for name in self._actuators]), "; ".join(complaints)


def _unused(error: CocorosimError) -> str:
    return f"its command is not used, all actuators are off: {error}"


def _brought_in(wanted: Floats, names: Sequence[str]) -> list[str]:
    """Bring commands (n,) into -1..1, in place; complaints say which were not there."""
    complaints = []
    for index, name in enumerate(names):
        value = float(wanted[index])
        if math.isnan(value):
            complaints.append(f"'{name}' is not a number or not given, so it is off")
            wanted[index] = 0.0
        elif abs(value) > 1.0:
            complaints.append(f"'{name}' is {value:g}, beyond -1..1, and is cut")
            wanted[index] = math.copysign(1.0, value)
    return complaints
