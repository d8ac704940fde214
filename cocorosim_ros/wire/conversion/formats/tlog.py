"""tlog: messages of MAVLink as a ground station received them, each behind a time of eight bytes [us].

Every topic has the column `received` beside the message's own fields; `ATTITUDE[1]` is what system 1 sent.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from cocorosim_ros.foundation.counted import counted, either
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.formats.column_rows import ColumnRows
from cocorosim_ros.wire.conversion.formats.format import LogFormat, check_file, missing_library, unreadable
from cocorosim_ros.wire.conversion.formats.instances import rows_of, split, wanted_instance
from cocorosim_ros.wire.conversion.rows import no_messages

_SUMMARY = "a tlog"
_TIME = 8  # bytes of the time before every message
_VERSION_1, _VERSION_2 = 0xFE, 0xFD
_AROUND_1, _AROUND_2 = 8, 12  # bytes of a message beside its payload
_SIGNATURE, _SIGNED = 13, 1  # bytes of a signature, and the flag that says that there is one


class Tlog:
    """One .tlog file in memory."""

    def __init__(self, path: Path) -> None:
        """Raises CocorosimError if the file is no tlog, holds no message, or pymavlink is missing."""
        check_file(path, path.name, _SUMMARY, ("tlog",))
        try:
            from pymavlink.dialects.v20 import ardupilotmega  # noqa: PLC0415 - an optional library
        except ImportError as error:
            raise missing_library("pymavlink", f"{path.name}, {_SUMMARY},") from error
        self._name = path.name
        self._messages: dict[str, dict[int, list[dict[str, Any]]]] = {}
        content = path.read_bytes()
        decoder = ardupilotmega.MAVLink(None)
        end = broken = 0
        for start, end in _packets(content):
            try:
                message = decoder.decode(bytearray(content[start + _TIME : end]))
            except ardupilotmega.MAVError:
                broken += 1
                continue
            self._add(int.from_bytes(content[start : start + _TIME], "big"), message)
        if not self._messages:
            raise unreadable(path.name, _SUMMARY, "no message of it is whole")
        self.damage = tuple(self._damages(broken, len(content) - end))

    def rows(self, topic: str, place: Entry) -> ColumnRows:
        """The messages of a topic, of one system where several sent it."""
        name, wanted = split(topic)
        if name not in self._messages:
            raise no_messages(topic, list(self._messages), place, self._name)
        by_system = self._messages[name]
        system = wanted_instance(name, wanted, list(by_system), place, self._name)
        return rows_of(f"{topic} of {self._name}", list(by_system[system]))

    def _add(self, received: int, message: Any) -> None:
        name = message.get_type()
        if name.startswith("UNKNOWN"):
            return
        cells = {"received": received, **{field: getattr(message, field) for field in message.get_fieldnames()}}
        self._messages.setdefault(name, {}).setdefault(message.get_srcSystem(), []).append(cells)

    def _damages(self, broken: int, rest: int) -> Iterator[str]:
        if broken:
            lost = f"{counted(broken, 'message')} cannot be read and {either(broken, 'was', 'were')} left out"
            yield f"{self._name}: {lost}."
        if rest:
            yield f"{self._name} is damaged or ends early: its last {rest} bytes were left out."


def _packets(content: bytes) -> Iterator[tuple[int, int]]:
    """Begin and end of every whole message with the time before it, up to the first that is none."""
    start = 0
    while start + _TIME + 3 <= len(content):
        magic, payload, flags = content[start + _TIME : start + _TIME + 3]
        if magic == _VERSION_1:
            end = start + _TIME + payload + _AROUND_1
        elif magic == _VERSION_2:
            end = start + _TIME + payload + _AROUND_2 + (_SIGNATURE if flags & _SIGNED else 0)
        else:
            return
        if end > len(content):
            return
        yield start, end
        start = end


TLOG = LogFormat(summary=_SUMMARY, kinds=("tlog",), open=Tlog, clock=("received", "us"))
