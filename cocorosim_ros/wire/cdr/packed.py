"""Fast CDR encoding and decoding of messages whose layout never changes, many robots at once.

One template message per robot fixes everything but the stamps and some float64 fields. Writing a distinct
value into each of them and serialising shows where it lies in the bytes; from then on encoding is a copy of
the template with those places overwritten, for all robots in a few NumPy assignments.

Assumes that all variable parts (texts, list lengths) are those of the template; decoding checks this and
otherwise decodes the message in the general way, with the same result.
"""

from __future__ import annotations

import copy
import struct
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr import field_paths
from cocorosim_ros.wire.cdr.primitives import STAMP, stamp_words
from cocorosim_ros.wire.cdr.type_store import deserialize, serialize


class PackedMessage:
    """Messages of one type for n robots: f numbers and the stamps vary, the rest is as in the templates.

    Args:
        templates: n messages of the type store (see `type_store.build`), one per robot.
        fields: f paths of float64 fields (see `field_paths`), in the order of the columns.
        stamps: paths of the builtin_interfaces/Time fields to fill; by default all that the first template
        has.
    """

    def __init__(self, templates: Sequence[Any], fields: Sequence[str], stamps: Sequence[str] | None = None) -> None:
        self.fields = tuple(fields)
        paths = list(field_paths.times_in(templates[0]) if stamps is None else stamps)
        self.stamps = tuple(paths)
        self._layouts = [_Layout(template, self.fields, self.stamps) for template in templates]
        by_shape: dict[Any, list[int]] = {}
        for row, layout in enumerate(self._layouts):
            by_shape.setdefault(layout.shape, []).append(row)
        self._groups = [_Group(rows, [self._layouts[row] for row in rows]) for rows in by_shape.values()]

    def encode(self, stamp_ns: int | ArrayLike, columns: ArrayLike = ()) -> list[bytes]:
        """The CDR bytes of the n messages.

        Args:
            stamp_ns: one stamp for all [ns], or (n,) one per robot, or (n, s) one per robot and stamp field.
            columns: (n, f) values of the fields, each in the field's own unit.
        """
        count = len(self._layouts)
        values = np.asarray(columns, dtype=np.float64).reshape(count, len(self.fields))
        stamps = _packed_stamps(stamp_ns, count, len(self.stamps))
        if len(self._groups) == 1:
            return self._groups[0].encode(stamps, values)
        encoded: list[bytes] = [b""] * count
        for group in self._groups:
            chosen = stamps if isinstance(stamps, int) else stamps[group.rows]
            for row, data in zip(group.rows, group.encode(chosen, values[group.rows]), strict=True):
                encoded[row] = data
        return encoded

    def decode(self, data: bytes, row: int = 0) -> Floats:
        """(f,) the fields of a message, in the order of `fields`; NaN for a named element that it lacks.

        Raises CocorosimError if the bytes are no such message, or name an element that the template of this
        row does not have.
        """
        layout = self._layouts[row]
        if len(data) == layout.length and int.from_bytes(data, "little") & layout.constant_mask == layout.constant:
            values = np.array(layout.unpack(data), np.float64)
            return values if layout.column_order is None else values[layout.column_order]
        return layout.decode_generally(data)


class _Layout:
    """Where the stamps and fields of one template lie in its bytes."""

    def __init__(self, template: Any, fields: Sequence[str], stamps: Sequence[str]) -> None:
        self.template = template
        self.type_name: str = template.__msgtype__
        self.paths = [field_paths.steps(path) for path in fields]
        self.offsets, self.stamp_offsets = _offsets(template, fields, stamps)
        self.bytes = serialize(template)
        self.length = len(self.bytes)
        self.shape = (self.length, tuple(self.offsets), tuple(self.stamp_offsets))
        mask = bytearray(b"\xff" * self.length)
        for offset in [*self.offsets, *self.stamp_offsets]:
            mask[offset : offset + 8] = bytes(8)
        self.constant_mask = int.from_bytes(mask, "little")
        self.constant = int.from_bytes(self.bytes, "little") & self.constant_mask
        self.unpack = _unpacker(self.offsets, self.length)
        ascending = self.offsets == sorted(self.offsets)
        self.column_order = None if ascending else np.argsort(np.argsort(self.offsets))

    def decode_generally(self, data: bytes) -> Floats:
        message = deserialize(self.type_name, data)
        self._refuse_unknown_elements(message)
        try:
            return np.array([field_paths.read(message, path) for path in self.paths], dtype=np.float64)
        except (IndexError, AttributeError) as error:
            raise CocorosimError(f"A message of type {self.type_name} is not whole: {error}.") from error

    def _refuse_unknown_elements(self, message: Any) -> None:
        lists = {(tuple(path[:at]), path[at][0]) for path in self.paths for at in range(len(path)) if path[at][1]}
        for before, field in lists:
            if any(element for _, element in before):
                continue
            known = _named_elements(self.template, list(before), field)
            found = _named_elements(message, list(before), field)
            _compare_elements(self.type_name, field, known, found)


class _Group:
    """Robots whose messages share one shape, so that one array holds them all."""

    def __init__(self, rows: list[int], layouts: list[_Layout]) -> None:
        self.rows = rows
        self._length = layouts[0].length
        self._bytes = np.frombuffer(b"".join(layout.bytes for layout in layouts), np.uint8).copy()
        self._stamps = [self._view("<i8", offset, 1)[:, 0] for offset in layouts[0].stamp_offsets]
        self._runs = [
            (slice(first, last), self._view("<f8", layouts[0].offsets[first], last - first))
            for first, last in _contiguous_runs(layouts[0].offsets)
        ]

    def encode(self, stamps: int | Integers, values: Floats) -> list[bytes]:
        for index, places in enumerate(self._stamps):
            places[...] = stamps if isinstance(stamps, int) else stamps[:, index]
        for columns, places in self._runs:
            places[...] = values[:, columns]
        data, length = self._bytes.tobytes(), self._length
        return [data[start : start + length] for start in range(0, len(data), length)]

    def _view(self, kind: str, offset: int, width: int) -> NDArray[Any]:
        shape, strides = (len(self.rows), width), (self._length, 8)
        return np.ndarray(shape, kind, buffer=self._bytes.data, offset=offset, strides=strides)


def _offsets(template: Any, fields: Sequence[str], stamps: Sequence[str]) -> tuple[list[int], list[int]]:
    """Byte offsets of the fields and of the stamps, found by serialising the template with distinct marks."""
    marked = copy.deepcopy(template)
    marks = [struct.pack("<H6s", index, b"\x5a\xc3\x96\x3c\x5a\x43") for index in range(len(fields) + len(stamps))]
    for path, mark in zip(fields, marks, strict=False):
        field_paths.write(marked, field_paths.steps(path), struct.unpack("<d", mark)[0])
    for path, mark in zip(stamps, marks[len(fields) :], strict=True):
        time = field_paths.owner_of(marked, field_paths.steps(path))
        time.sec, time.nanosec = STAMP.unpack(mark)
    data = serialize(marked)
    for path, mark in zip([*fields, *stamps], marks, strict=True):
        if data.count(mark) != 1:
            raise ValueError(f"{path!r} of {template.__msgtype__} is not one float64 or Time field")
    places = [data.index(mark) for mark in marks]
    return places[: len(fields)], places[len(fields) :]


def _packed_stamps(stamp_ns: int | ArrayLike, count: int, fields: int) -> int | Integers:
    """The stamps as words (see `primitives.stamp_words`): one for all, or one per robot and stamp field."""
    if isinstance(stamp_ns, int):
        return stamp_words(stamp_ns)
    stamps = np.asarray(stamp_ns, dtype=np.int64)
    return stamp_words(np.broadcast_to(stamps[:, None] if stamps.ndim == 1 else stamps, (count, fields)))


def _contiguous_runs(offsets: Sequence[int]) -> list[tuple[int, int]]:
    """Half-open ranges of columns that lie side by side in the bytes."""
    breaks = [index for index in range(1, len(offsets)) if offsets[index] != offsets[index - 1] + 8]
    return list(zip([0, *breaks], [*breaks, len(offsets)], strict=True)) if offsets else []


def _unpacker(offsets: Sequence[int], length: int) -> Any:
    """A function from bytes to the float64 values at the offsets, in ascending order of offset."""
    pattern, reached = "<", 0
    for offset in sorted(offsets):
        pattern += f"{offset - reached}xd"
        reached = offset + 8
    return struct.Struct(f"{pattern}{length - reached}x").unpack


def _named_elements(message: Any, before: list[field_paths.Step], field: str) -> list[str]:
    owner = field_paths.owner_of(message, before)
    names = field_paths.element_names(owner, field)
    elements = getattr(owner, field)
    if names is not None and len(names) != len(elements):
        raise CocorosimError(
            f"A message of type {message.__msgtype__} has {len(names)} names for {len(elements)} entries of "
            f"{field!r}; "
            "give one name per entry."
        )
    return names if names is not None else [str(index) for index in range(len(elements))]


def _compare_elements(type_name: str, field: str, known: list[str], found: list[str]) -> None:
    for name in found:
        if name not in known:
            raise CocorosimError(
                f"A message of type {type_name} has an entry {name!r} in {field!r} that this robot does not "
                f"have; "
                f"its entries are: {', '.join(known)}."
            )
        if found.count(name) > 1:
            raise CocorosimError(
                f"A message of type {type_name} has two entries {name!r} in {field!r}; give one of each."
            )
