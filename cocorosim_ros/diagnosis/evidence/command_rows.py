"""ThrusterCommand messages as rows of the platform's actuators, thousands of messages at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.counted import counted, either
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.six_degrees import AXES
from cocorosim_ros.scenario.parts.stick_mixing import StickMixing
from cocorosim_ros.wire.cdr.named_numbers import read_named_numbers
from cocorosim_ros.wire.cdr.stamped_numbers import Stamps


@dataclass(frozen=True)
class CommandRows:
    """Contents of n messages in their order: header stamps (n,) [ns], fractions (n, actuators), readable (n,).

    commanded: actuators that the messages name, those that sticks drive among them, in the order of first appearance.
    """

    stamp_ns: Stamps
    values: Floats
    readable: Flags
    remarks: tuple[str, ...]
    commanded: tuple[str, ...]


def read_command_rows(topic: str, messages: Sequence[bytes], platform: Platform) -> CommandRows:
    """Read the commands of each actuator of a robot's platform, in the order of its actuators.

    As in the simulator, an actuator is off where a message does not name it or its command is no number, and a command
    beyond 1 is cut to 1; remarks count these. Sticks become commands by the platform's mixing. Raises CocorosimError if
    the names are those of another platform, or if a message commands sticks and what they drive.
    """
    actuators, mixing = platform.actuator_names, platform.stick_mixing()
    read = read_named_numbers(messages, (*actuators, *(mixing.sticks if mixing else ())))
    names, numbers = read.names, read.numbers[:, : len(actuators)]
    said: list[str] = []
    if mixing is not None and set(mixing.sticks) & set(names):
        sticks = _Sticks(topic, mixing, read.numbers[:, len(actuators) :])
        said = sticks.remarks(names)
        numbers = sticks.mixed_into(numbers, actuators, said)
        names = (*(name for name in names if name not in mixing.sticks), *mixing.driven)
    remarks = _check_names(topic, names, actuators)
    values = _usable(topic, numbers, read.readable, remarks)
    return CommandRows(read.stamp_ns, values, read.readable, (*said, *remarks), tuple(dict.fromkeys(names)))


@dataclass(frozen=True)
class _Sticks:
    """Commands of sticks in messages of one topic: (n, sticks) `given`, NaN where a message does not name one."""

    topic: str
    mixing: StickMixing
    given: Floats

    def remarks(self, names: Sequence[str]) -> list[str]:
        """A sentence about sticks that no message names."""
        silent = [name for name in self.mixing.sticks if name not in names]
        return [f"{self.topic}: the stick {', '.join(silent)} is never commanded and rests."] if silent else []

    def mixed_into(self, numbers: Floats, actuators: tuple[str, ...], remarks: list[str]) -> Floats:
        """(n, actuators) commands, those of sticks made into what they drive; remarks are added to."""
        rows = np.isfinite(self.given).any(axis=1)
        driven = [actuators.index(name) for name in self.mixing.driven]
        twice = np.count_nonzero(np.isfinite(numbers[rows][:, driven]).any(axis=1))
        if twice:
            raise CocorosimError(
                f"{self.topic} commands sticks ({', '.join(self.mixing.sticks)}) and what they drive "
                f"({', '.join(self.mixing.driven)}) in {twice} messages at once; leave one of them out of each."
            )
        sticks = _usable(self.topic, self.given[rows], np.ones(np.count_nonzero(rows), dtype=bool), remarks)
        mixed = numbers.copy()
        for column, commands in zip(driven, self.mixing.commands(sticks).T, strict=True):
            mixed[rows, column] = commands
        return mixed


def _check_names(topic: str, found: Sequence[str], actuators: tuple[str, ...]) -> list[str]:
    """Sentences about actuators that only the messages or only the platform names.

    Raises CocorosimError if no name is in both, or if each has a name that the other lacks: the model would then lack
    the forces of a commanded actuator, and the diagnosis would explain them by missing physics.
    """
    names = list(dict.fromkeys(found))
    strange = [name for name in names if name not in actuators]
    silent = [name for name in actuators if name not in names]
    if names and len(strange) == len(names) and set(names) <= set(AXES):
        raise CocorosimError(
            f"{topic} commands the sticks {', '.join(names)}, and the platform does not say what they do to "
            f"{', '.join(actuators)}; add 'mixing' to it."
        )
    if names and len(strange) == len(names):
        raise CocorosimError(
            f"{topic} commands the actuators {', '.join(names)}, and the platform has none of these but "
            f"{', '.join(actuators)}; give the platform of this robot (`cocorosim new platform NAME --for BAG` begins "
            "one), or rename its actuators."
        )
    if strange and silent:
        raise CocorosimError(
            f"{topic} commands {', '.join(strange)}, which the platform does not have, and never {', '.join(silent)}, "
            "which it has; rename what is the same, or give a platform without what this robot does not have."
        )
    if strange:
        return [f"{topic}: the platform has no actuator {', '.join(strange)}; these commands are not used."]
    return [f"{topic}: {', '.join(silent)} is never commanded and is taken to be off."] if names and silent else []


def _usable(topic: str, values: Floats, readable: Flags, remarks: list[str]) -> Floats:
    given = np.isfinite(values[readable]).any(axis=0)  # a column without any number already has a remark
    lost = np.count_nonzero(~np.isfinite(values[readable][:, given]).all(axis=1))
    if lost:
        have = f"{counted(lost, 'message')} {either(lost, 'has', 'have')}"
        remarks.append(f"{topic}: {have} a command that is no number; that actuator is taken to be off.")
    values = np.where(np.isfinite(values), values, 0.0)
    beyond = np.count_nonzero((np.abs(values) > 1.0).any(axis=1))
    if beyond:
        have, cut = either(beyond, "commands", "command"), either(beyond, "it is", "they are")
        most = f"up to {np.abs(values).max():.3g} where 1 is all"
        remarks.append(
            f"{topic}: {counted(beyond, 'message')} {have} more than the maximum ({most}); {cut} cut to it. Check the "
            "unit of the commands."
        )
    return np.clip(values, -1.0, 1.0)
