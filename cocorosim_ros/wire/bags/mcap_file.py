"""Reads one MCAP file, whole or cut off: what it holds, what is damaged, and its messages as raw bytes.

The file is walked record by record, not by its index, so that a recording that was never closed reads the
same way. Every chunk is unpacked and its checksum verified once when the file is opened. A chunk that is
damaged is left out and said; a record that the file is too short for ends it.
"""

from __future__ import annotations

import mmap
import struct
import sys
import zlib
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import BinaryIO

import lz4.frame  # type: ignore[import-untyped]
import zstandard

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags import mcap_format as mcap
from cocorosim_ros.wire.bags.file_kinds import kind_or_table_in, told
from cocorosim_ros.wire.bags.text_tables import TABLE_HEAD
from cocorosim_ros.wire.bags.writing_lock import is_held

_DAMAGE = (ValueError, RuntimeError, struct.error, zstandard.ZstdError, MemoryError)
RawMessage = tuple[int, int, int, bytes]  # channel, log time [ns], publish time [ns], CDR bytes
Watch = Callable[[int, int], None]  # told how many bytes of how many a pass through a file has behind it
_MOST_MAPPED = 1 << 22  # bytes of the file that a walk through it leaves in memory
_MAPPED_AROUND = 1 << 16  # bytes; where one is looked at, Linux maps what it knows of as many around it


@dataclass(frozen=True)
class McapChannel:
    """One topic of the file."""

    topic: str
    type_name: str
    encoding: str  # of the messages: cdr
    schema: str
    schema_encoding: str  # ros2msg | ros2idl
    metadata: dict[str, str]


@dataclass(frozen=True)
class _Block:
    """Messages that lie together: the inside of a chunk, or records that stand outside of chunks."""

    start: int
    end: int
    compression: str | None  # None outside of chunks
    plain_size: int
    checksum: int
    start_ns: int = 0  # first log time


@dataclass
class Contents:
    """What the walk through a file found."""

    channels: dict[int, McapChannel] = field(default_factory=dict)
    counts: dict[int, int] = field(default_factory=dict)
    metadata: dict[str, dict[str, str]] = field(default_factory=dict)
    start_ns: int = 2**64 - 1
    end_ns: int = 0
    closed: bool = False
    being_written: bool = False  # by a process that goes on
    damage: list[str] = field(default_factory=list)

    @property
    def message_count(self) -> int:
        """All whole messages."""
        return sum(self.counts.values())


class McapFile:
    """One open MCAP file. Raises CocorosimError if it is none.

    Args:
        path: named in sentences.
        file: the file itself, if it is not the one at that path.
        watch: told now and then how far the opening is, and each pass through all messages; None: nobody asks.
    """

    def __init__(self, path: Path, file: BinaryIO | None = None, watch: Watch | None = None) -> None:
        self.path = path
        self._watch = watch
        self.contents = Contents()
        self._schemas: dict[int, tuple[str, str, str]] = {}
        self._summary_channels: dict[int, McapChannel] = {}  # for messages whose own definition was lost
        self._blocks: list[_Block] = []
        self._data = _mapped(path, file)
        self._walk()
        self.contents.being_written = not self.contents.closed and is_held(path)
        self._blocks = [examined for block in self._watched() if (examined := self._examined(block))]

    def messages(self) -> Iterator[RawMessage]:
        """All whole messages, in the order of the file."""
        for block in self._watched():
            yield from self._messages_of(block)

    def timed_blocks(self) -> list[tuple[int, Iterator[RawMessage]]]:
        """First log time [ns] and messages of every block; a block is unpacked when it is begun."""
        return [(block.start_ns, self._messages_of(block)) for block in self._blocks]

    def _watched(self) -> Iterator[_Block]:
        """The blocks, one after the other, while it is told how far this is."""
        for block in self._blocks:
            yield block
            if self._watch is not None:
                self._watch(block.end, len(self._data))

    def _walk(self) -> None:
        """Find the blocks and the metadata, as far as the file goes."""
        place, loose, let_go = len(mcap.MAGIC), None, 0
        while place + mcap.RECORD_HEAD.size <= len(self._data):
            opcode, length = mcap.RECORD_HEAD.unpack_from(self._data, place)
            content = place + mcap.RECORD_HEAD.size
            end = content + length
            if opcode == 0 or end > len(self._data):
                break
            if opcode in (mcap.SCHEMA, mcap.CHANNEL, mcap.MESSAGE):
                loose = place if loose is None else loose
                self._keep_definition(opcode, content, end)
            elif loose is not None:
                self._add_loose(loose, place)
                loose = None
            if opcode == mcap.FOOTER:
                self.contents.closed = self._data[end : end + len(mcap.MAGIC)] == mcap.MAGIC
                return
            self._note(opcode, content, end)
            place = end
            if place - let_go > _MOST_MAPPED:
                let_go = self._let_go(let_go, place)
        if loose is not None:
            self._add_loose(loose, place)

    def _keep_definition(self, opcode: int, content: int, end: int) -> None:
        """Keep a definition that stands outside of chunks, as the summary repeats all of them."""
        if opcode != mcap.MESSAGE:
            with suppress(ValueError, struct.error):  # said when its block is examined
                self._define(opcode, mcap.Cursor(self._data[content:end]), self._summary_channels)

    def _note(self, opcode: int, content: int, end: int) -> None:
        """Take notice of a record that stands outside of chunks."""
        try:
            if opcode == mcap.CHUNK:
                self._blocks.append(_chunk(self._data, content, end))
            elif opcode == mcap.METADATA:
                cursor = mcap.Cursor(self._data[content:end])
                self.contents.metadata.setdefault(cursor.text(), {}).update(cursor.text_map())
        except (ValueError, OverflowError) as error:
            self.contents.damage.append(f"the record at byte {content} is damaged ({error}) and left out")

    def _add_loose(self, start: int, end: int) -> None:
        self._blocks.append(_Block(start, end, None, end - start, 0))

    def _examined(self, block: _Block) -> _Block | None:
        """The block with its first log time, its messages counted; None if it is damaged or empty."""
        contents = self.contents
        try:
            counts, start_ns, end_ns = self._count(self._plain(block))
        except _DAMAGE as error:
            contents.damage.append(f"the chunk at byte {block.start} is damaged ({error}) and left out")
            return None
        if not counts:
            return None
        for channel, count in counts.items():
            contents.counts[channel] = contents.counts.get(channel, 0) + count
        contents.start_ns, contents.end_ns = min(contents.start_ns, start_ns), max(contents.end_ns, end_ns)
        return replace(block, start_ns=start_ns)

    def _count(self, plain: bytes) -> tuple[dict[int, int], int, int]:
        """Messages per channel, first and last log time of a block; its schemas and channels are noted."""
        counts: dict[int, int] = {}
        times: list[int] = []
        place, total = 0, len(plain)
        while place < total:
            opcode, length = mcap.RECORD_HEAD.unpack_from(plain, place)
            end = place + mcap.RECORD_HEAD.size + length
            if end > total or (opcode == mcap.MESSAGE and length < mcap.MESSAGE_FIELDS):
                raise ValueError(f"the record at byte {place} inside is of length {length}")
            if opcode == mcap.MESSAGE:
                _, _, channel, _, log_time, _ = mcap.MESSAGE_HEAD.unpack_from(plain, place)
                counts[channel] = counts.get(channel, 0) + 1
                times.append(log_time)
            elif opcode in (mcap.SCHEMA, mcap.CHANNEL):
                self._define(opcode, mcap.Cursor(plain[place + mcap.RECORD_HEAD.size : end]), self.contents.channels)
            place = end
        for channel in counts.keys() & self._summary_channels.keys():
            self.contents.channels.setdefault(channel, self._summary_channels[channel])
        if not counts.keys() <= self.contents.channels.keys():
            raise ValueError("a message belongs to no channel")
        return counts, min(times, default=0), max(times, default=0)

    def _define(self, opcode: int, cursor: mcap.Cursor, channels: dict[int, McapChannel]) -> None:
        number = cursor.number(mcap.UINT16)
        if opcode == mcap.SCHEMA:
            self._schemas[number] = cursor.text(), cursor.text(), cursor.text()
        else:
            name, schema_encoding, schema = self._schemas.get(cursor.number(mcap.UINT16), ("", "", ""))
            channels[number] = McapChannel(
                cursor.text(), name, cursor.text(), schema, schema_encoding, cursor.text_map()
            )

    def _plain(self, block: _Block) -> bytes:
        """The unpacked bytes of a block. Raises ValueError, RuntimeError or ZstdError if they are damaged."""
        packed = self._data[block.start : block.end]
        self._let_go(block.start, block.end)
        if block.compression is None:
            return packed
        if block.compression not in _UNPACK:
            raise ValueError(f"its compression {block.compression!r} is unknown")
        if block.plain_size > sys.maxsize:
            raise ValueError(f"it says that it holds {block.plain_size} bytes, more than any machine")
        plain = _UNPACK[block.compression](packed, block.plain_size)
        if len(plain) != block.plain_size:
            raise ValueError(f"it holds {len(plain)} bytes instead of {block.plain_size}")
        if block.checksum and zlib.crc32(plain) != block.checksum:
            raise ValueError("its checksum is wrong")
        return plain

    def _let_go(self, start: int, end: int) -> int:
        """Take these bytes out of memory, if the system can; they are read again when looked at. Returns `end`."""
        if hasattr(mmap, "MADV_DONTNEED"):
            first = max(0, start - _MAPPED_AROUND)
            first -= first % mmap.PAGESIZE
            self._data.madvise(mmap.MADV_DONTNEED, first, end - first)
        return end

    def _messages_of(self, block: _Block) -> Iterator[RawMessage]:
        plain = self._plain(block)
        place, total = 0, len(plain)
        unpack, head, message = mcap.MESSAGE_HEAD.unpack_from, mcap.RECORD_HEAD.size, mcap.MESSAGE
        first_byte = head + mcap.MESSAGE_FIELDS
        while place < total:
            if plain[place] == message:
                _, length, channel, _, log_time, publish_time = unpack(plain, place)
                end = place + head + length
                yield channel, log_time, publish_time, plain[place + first_byte : end]
            else:
                end = place + head + mcap.RECORD_HEAD.unpack_from(plain, place)[1]
            place = end


def _unpack_zstd(packed: bytes, size: int) -> bytes:
    return zstandard.ZstdDecompressor().decompress(packed, max_output_size=size) if size else b""


def _unpack_lz4(packed: bytes, size: int) -> bytes:
    return bytes(lz4.frame.decompress(packed)) if size else b""


_UNPACK: dict[str, Callable[[bytes, int], bytes]] = {
    "zstd": _unpack_zstd,
    "lz4": _unpack_lz4,
    "": lambda packed, _: packed,
}


def _chunk(data: mmap.mmap, content: int, end: int) -> _Block:
    """The block inside a chunk record. Raises ValueError if the record does not hold together."""
    cursor = mcap.Cursor(data[content : min(end, content + 256)])
    cursor.take(16)
    plain_size, checksum = cursor.number(mcap.UINT64), cursor.number(mcap.UINT32)
    compression = cursor.text()
    packed_size = cursor.number(mcap.UINT64)
    start = content + cursor.place
    if start + packed_size > end:
        raise ValueError("its content is longer than its record")
    return _Block(start, start + packed_size, compression, plain_size, checksum)


def _mapped(path: Path, file: BinaryIO | None) -> mmap.mmap:
    """The file as bytes, read where they are needed."""
    try:
        with file or path.open("rb") as opened:
            opened.seek(0, 2)
            if opened.tell() == 0:
                raise CocorosimError(f"{path} is empty: nothing was recorded; record again or give another file.")
            data = mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ)
    except OSError as error:
        raise CocorosimError(
            f"{path} cannot be read: {error.strerror}; give a rosbag2 folder or .mcap file."
        ) from error
    if len(data) < len(mcap.MAGIC) and mcap.MAGIC.startswith(data[:]):
        raise CocorosimError(
            f"{path} ends after {len(data)} bytes: nothing of the recording is left; give another file."
        )
    if data[: len(mcap.MAGIC)] != mcap.MAGIC:
        kind = kind_or_table_in(data[:TABLE_HEAD])
        if kind is not None:
            raise CocorosimError(f"{path} is not an MCAP file: it {told(kind, path)}.")
        raise CocorosimError(
            f"{path} is not an MCAP file, and its kind is not known; give a rosbag2 folder or an .mcap file, or save "
            "it as CSV or Parquet, which `cocorosim convert` reads."
        )
    return data
