"""DataFlash: the log that ArduPilot keeps on board, .bin files.

Every message begins with 0xA3 0x95 and its kind. Messages FMT say how long a kind is, what it is called and which
columns it has, by one letter each; messages FMTU say which column tells instances apart (unit '#').
Source: ArduPilot, libraries/AP_Logger/LogStructure.h.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.formats.column_rows import ColumnRows
from cocorosim_ros.wire.conversion.formats.format import LogFormat, check_file, unreadable
from cocorosim_ros.wire.conversion.formats.instances import split, wanted_instance
from cocorosim_ros.wire.conversion.rows import no_messages

_SUMMARY = "a DataFlash log"
_BEGIN = b"\xa3\x95"
_FORMAT = 0x80  # the kind of FMT, which every log begins with
_HEAD = 3  # bytes before the columns
_PAGE = 528  # bytes; what is left of the last page of the chip stands behind the last message
_LETTERS: Mapping[str, str] = {
    "b": "i1", "B": "u1", "M": "u1", "h": "<i2", "H": "<u2", "i": "<i4", "I": "<u4", "q": "<i8", "Q": "<u8",
    "f": "<f4", "d": "<f8", "g": "<f2", "n": "S4", "N": "S16", "Z": "S64", "a": "(32,)<i2",
    "c": "<i2", "C": "<u2", "e": "<i4", "E": "<u4", "L": "<i4",
}  # fmt: skip
_PARTS_OF_ONE: Mapping[str, float] = {"c": 100.0, "C": 100.0, "e": 100.0, "E": 100.0, "L": 1e7}
_OF_FORMATS = "BBnNZ"
_NAMES_OF_FORMATS = "Type,Length,Name,Format,Columns"


@dataclass(frozen=True)
class Kind:
    """One kind of messages."""

    name: str
    length: int  # bytes, head included
    letters: str
    columns: tuple[str, ...]

    @property
    def dtype(self) -> np.dtype[Any] | None:
        """The layout of its columns behind the head; None if they do not fill the message."""
        if len(self.letters) != len(self.columns) or len(set(self.columns)) < len(self.columns):
            return None
        if any(letter not in _LETTERS for letter in self.letters):
            return None
        fields = [(name, _LETTERS[letter]) for name, letter in zip(self.columns, self.letters, strict=True)]
        found = np.dtype(fields)
        return found if found.itemsize == self.length - _HEAD else None


class DataFlashLog:
    """One .bin file; numbers are in the units of ArduPilot's own list of messages (ATT in deg, XKF1 in m and deg)."""

    def __init__(self, path: Path) -> None:
        """Raises CocorosimError if the file is no DataFlash log, or holds no message."""
        check_file(path, path.name, _SUMMARY, ("dataflash",))
        self._name = path.name
        self._content = np.frombuffer(path.read_bytes(), dtype=np.uint8)
        self._kinds: dict[int, Kind] = {_FORMAT: Kind("FMT", 89, _OF_FORMATS, tuple(_NAMES_OF_FORMATS.split(",")))}
        self._starts: dict[int, list[int]] = {}
        lost = self._scan(self._content.tobytes())
        if not set(self._starts) - {_FORMAT}:
            raise unreadable(path.name, _SUMMARY, "no message of it is whole")
        self._instances = dict(self._instance_columns())
        self.damage = (f"{path.name} is damaged or ends early: {lost} bytes of it were left out.",) * bool(lost)

    def rows(self, topic: str, place: Entry) -> ColumnRows:
        """The messages of a topic, of one instance where a log has several."""
        name, wanted = split(topic)
        numbers = {kind.name: number for number, kind in self._kinds.items() if self._starts.get(number)}
        if name not in numbers or self._kinds[numbers[name]].dtype is None:
            raise no_messages(topic, list(numbers), place, self._name)
        messages = self._messages(numbers[name])
        column = self._instances.get(numbers[name])
        if column is not None:
            there = set(messages[column].tolist())
            chosen = wanted_instance(name, wanted, there, place, self._name)
            messages = messages[messages[column] == chosen]
        kind = self._kinds[numbers[name]]
        columns = {
            column: _scaled(messages[column], letter) for column, letter in zip(kind.columns, kind.letters, strict=True)
        }
        return ColumnRows(f"{topic} of {self._name}", columns)

    def _scan(self, content: bytes) -> int:
        """Find where every message starts; return how many bytes belong to none."""
        at = lost = 0
        while at < len(content):
            begins = content[at : at + 2] == _BEGIN and at + 2 < len(content)
            kind = self._kinds.get(content[at + 2]) if begins else None
            if kind is None or at + kind.length > len(content):
                found = content.find(_BEGIN, at + 1)
                following = found if found > 0 else len(content)
                lost += following - at
                at = following
                continue
            number = content[at + 2]
            self._starts.setdefault(number, []).append(at)
            if number == _FORMAT:
                self._learn(content[at + _HEAD : at + kind.length])
            at += kind.length
        padding = len(content) - len(content.rstrip(b"\xff"))
        return 0 if 0 < lost == padding < _PAGE else lost

    def _learn(self, content: bytes) -> None:
        """Remember a kind that a message FMT describes."""
        number, length = content[0], content[1]
        name, letters, columns = (_text(part) for part in (content[2:6], content[6:22], content[22:86]))
        if length > _HEAD and number != _FORMAT:
            self._kinds[number] = Kind(name, length, letters, tuple(columns.split(",")))

    def _messages(self, number: int) -> npt.NDArray[Any]:
        """(n,) the messages of a kind as records."""
        kind = self._kinds[number]
        starts = np.array(self._starts[number])[:, None] + np.arange(_HEAD, kind.length)
        records = self._content[starts].view(kind.dtype or np.uint8)
        return np.asarray(records[:, 0])

    def _instance_columns(self) -> Iterator[tuple[int, str]]:
        """Kinds with the column that tells instances apart."""
        for number, kind in self._kinds.items():
            if kind.name == "FMTU" and kind.dtype is not None and number in self._starts:
                for message in self._messages(number):
                    told, units = int(message["FmtType"]), _text(bytes(message["UnitIds"]))
                    if "#" in units and told in self._kinds and units.index("#") < len(self._kinds[told].columns):
                        yield told, self._kinds[told].columns[units.index("#")]


def _text(content: bytes) -> str:
    return content.partition(b"\0")[0].decode("ascii", "replace")


def _scaled(cells: npt.NDArray[Any], letter: str) -> npt.NDArray[Any]:
    """A column in the unit of its documentation; text as text."""
    if cells.dtype.kind == "S":
        return np.array([_text(cell) for cell in cells.tolist()], dtype=object)
    return cells / _PARTS_OF_ONE[letter] if letter in _PARTS_OF_ONE else cells


DATAFLASH = LogFormat(summary=_SUMMARY, kinds=("dataflash",), open=DataFlashLog, clock=("TimeUS", "us"))
