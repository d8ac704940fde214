"""ThrusterCommand messages as rows of the platform's actuators, thousands of messages at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.named_numbers import read_named_numbers
from cocorosim_ros.wire.cdr.stamped_numbers import Stamps


@dataclass(frozen=True)
class CommandRows:
    """Contents of n messages in their order: header stamps (n,) [ns], fractions (n, actuators), readable (n,)."""

    stamp_ns: Stamps
    values: Floats
    readable: Flags
    remarks: tuple[str, ...]


def read_command_rows(topic: str, messages: Sequence[bytes], actuators: tuple[str, ...]) -> CommandRows:
    """Read the commands of each actuator, in the order of `actuators`.

    As in the simulator, an actuator is off where a message does not name it or its command is no number, and a command
    beyond 1 is cut to 1; remarks count these. Raises CocorosimError if the names are those of another platform.
    """
    read = read_named_numbers(messages, actuators)
    remarks = _check_names(topic, read.names, actuators)
    values = _usable(topic, read.numbers, read.readable, remarks)
    return CommandRows(read.stamp_ns, values, read.readable, tuple(remarks))


def _check_names(topic: str, found: Sequence[str], actuators: tuple[str, ...]) -> list[str]:
    """Sentences about actuators that only the messages or only the platform names.

    Raises CocorosimError if no name is in both, or if each has a name that the other lacks: the model would then lack
    the forces of a commanded actuator, and the diagnosis would explain them by missing physics.
    """
    names = list(dict.fromkeys(found))
    strange = [name for name in names if name not in actuators]
    silent = [name for name in actuators if name not in names]
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
        remarks.append(f"{topic}: {lost} messages have a command that is no number; that actuator is taken to be off.")
    values = np.where(np.isfinite(values), values, 0.0)
    beyond = np.count_nonzero((np.abs(values) > 1.0).any(axis=1))
    if beyond:
        remarks.append(
            f"{topic}: {beyond} messages command more than the maximum (up to {np.abs(values).max():.3g} where 1 is "
            "all); they are cut to it. Check the unit of the commands."
        )
    return np.clip(values, -1.0, 1.0)
