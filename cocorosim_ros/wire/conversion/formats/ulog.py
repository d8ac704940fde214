"""ULog: the log of PX4, topics by name, `vehicle_attitude[1]` for the second instance."""

from __future__ import annotations

import contextlib
import io
from pathlib import Path

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.formats.column_rows import ColumnRows
from cocorosim_ros.wire.conversion.formats.format import LogFormat, check_file, missing_library, unreadable
from cocorosim_ros.wire.conversion.rows import no_messages

_SUMMARY = "a ULog"
_HEADER = 16  # bytes before the first message, which says its own length in two bytes and its kind in one


class ULogLog:
    """One .ulg file in memory."""

    def __init__(self, path: Path) -> None:
        """Raises CocorosimError if the file is no ULog, is damaged, or pyulog is missing."""
        check_file(path, path.name, _SUMMARY, ("ulog",))
        try:
            from pyulog import ULog  # noqa: PLC0415 - an optional library
        except ImportError as error:
            raise missing_library("pyulog", f"{path.name}, {_SUMMARY},") from error
        try:
            # It prints what it finds damaged.
            with contextlib.redirect_stdout(io.StringIO()), path.open("rb") as file:
                log = ULog(file)
        except Exception as error:  # a parser that meets damage may raise anything
            raise unreadable(path.name, _SUMMARY, error) from error
        self._name = path.name
        self._topics = {
            found.name + (f"[{found.multi_id}]" if found.multi_id else ""): found.data for found in log.data_list
        }
        damaged = log.file_corruption or _ends_early(path.read_bytes())
        self.damage = (f"{path.name} is damaged or ends early: what can be read of it was converted.",) * damaged

    @property
    def topics(self) -> tuple[str, ...]:
        """The names of all topics that have messages."""
        return tuple(self._topics)

    def rows(self, topic: str, place: Entry) -> ColumnRows:
        """The messages of a topic."""
        if topic not in self._topics:
            raise no_messages(topic, self._topics, place, self._name)
        return ColumnRows(f"{topic} of {self._name}", self._topics[topic])


def _ends_early(content: bytes) -> bool:
    """Tell whether the last message is not whole."""
    at = _HEADER
    while at + 3 <= len(content):
        at += 3 + int.from_bytes(content[at : at + 2], "little")
    return at != len(content)


ULOG = LogFormat(summary=_SUMMARY, kinds=("ulog",), open=ULogLog, clock=("timestamp", "us"))
