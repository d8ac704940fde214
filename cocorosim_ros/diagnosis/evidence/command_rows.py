"""ThrusterCommand messages as rows of the platform's actuators, by the thousand."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.stamped_numbers import FRAME_LENGTH, PADDING, Stamps, decode_layout, numbers_at

_ENCAPSULATION = 4


@dataclass(frozen=True)
class CommandRows:
    """n messages in their order: header stamps (n,) [ns], fractions (n, actuators), which could be read (n,)."""

    stamp_ns: Stamps
    values: Floats
    readable: Flags
    remarks: tuple[str, ...]


@dataclass(frozen=True)
class _Layout:
    """Messages that say the same but for stamp and numbers; `head` is what stands between these."""

    length: int
    order: str
    head: bytes
    names: tuple[str, ...]
    place: int  # of the first number

    def holds(self, data: bytes) -> bool:
        return len(data) == self.length and data[FRAME_LENGTH : FRAME_LENGTH + len(self.head)] == self.head


def read_command_rows(topic: str, messages: Sequence[bytes], actuators: tuple[str, ...]) -> CommandRows:
    """What each actuator was asked for, by the order of `actuators`.

    As in the simulator an actuator is off where it is not named or its command is no number, and a command beyond 1
    is cut to it; remarks say how often. Raises CocorosimError if the names are those of another platform.
    """
    stamps = np.zeros(len(messages), dtype=np.int64)
    values = np.full((len(messages), len(actuators)), np.nan)
    readable = np.zeros(len(messages), dtype=bool)
    groups = _by_layout(messages)
    for layout, rows in groups:
        chosen = [messages[row] for row in rows]
        stamps[rows], numbers = decode_layout(chosen, layout.place, len(layout.names), layout.order)
        readable[rows] = True
        for column, actuator in enumerate(actuators):
            if actuator in layout.names:
                values[rows, column] = numbers[:, layout.names.index(actuator)]
    remarks = _check_names(topic, [name for layout, _ in groups for name in layout.names], actuators)
    return CommandRows(stamps, _usable(topic, values, readable, remarks), readable, tuple(remarks))


def _check_names(topic: str, found: Sequence[str], actuators: tuple[str, ...]) -> list[str]:
    """Sentences on names that only one side has.

    Raises CocorosimError if they have none in common, or if each has names that the other lacks: what one of them
    commanded would be missing from the model, and physics would be blamed for it.
    """
    names = list(dict.fromkeys(found))
    strange = [name for name in names if name not in actuators]
    silent = [name for name in actuators if name not in names]
    if names and len(strange) == len(names):
        raise CocorosimError(
            f"{topic} commands the actuators {', '.join(names)}, and the platform has none of these but "
            f"{', '.join(actuators)}; give the platform of this robot, or rename its actuators."
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
    given = np.isfinite(values[readable]).any(axis=0)  # a column without any number was remarked on by its name
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


def _by_layout(messages: Sequence[bytes]) -> list[tuple[_Layout, list[int]]]:
    groups: list[tuple[_Layout, list[int]]] = []
    for row, data in enumerate(messages):
        rows = next((rows for layout, rows in groups if layout.holds(data)), None)
        if rows is None:
            layout = _layout_of(data)
            if layout is None:
                continue
            rows = []
            groups.append((layout, rows))
        rows.append(row)
    return groups


def _layout_of(data: bytes) -> _Layout | None:
    """How this message is laid out; None if it is not whole."""
    order = ">" if data[1:2] == b"\0" else "<"
    try:
        place = FRAME_LENGTH + 4 + _number(data, FRAME_LENGTH, order)
        place, count = _aligned(place) + 4, _number(data, _aligned(place), order)
        names = []
        for _ in range(min(count, len(data))):
            start = _aligned(place) + 4
            place = start + _number(data, start - 4, order)
            names.append(data[start:place].rstrip(b"\0").decode(errors="replace"))
        end = _aligned(place) + 4
        if _number(data, end - 4, order) != count:
            return None
    except struct.error:
        return None
    numbers = numbers_at(end) if count else end
    if not 0 <= len(data) - numbers - 8 * count <= PADDING:
        return None
    return _Layout(len(data), order, data[FRAME_LENGTH:end], tuple(names), numbers)


def _number(data: bytes, place: int, order: str) -> int:
    return int(struct.unpack_from(f"{order}I", data, place)[0])


def _aligned(place: int) -> int:
    return _ENCAPSULATION + (place - _ENCAPSULATION + 3) // 4 * 4
