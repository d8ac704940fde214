"""Writes one MCAP file: zstd chunks with message indexes, and a summary at the end.

Every chunk reaches the operating system as soon as it is full, so a process that is killed loses at most
the last one.
"""

from __future__ import annotations

import os
import struct
import zlib
from collections.abc import Mapping
from contextlib import suppress
from io import FileIO
from pathlib import Path

import zstandard

from cocorosim_ros.wire.bags import mcap_format as mcap
from cocorosim_ros.wire.bags.writing_lock import hold

CHUNK_BYTES = 256 * 1024
COMPRESSION_LEVEL = 3
_NEVER = 2**64 - 1


class McapWriter:
    """One MCAP file in the making; the file must not exist. Any method may raise OSError.

    After an OSError the file ends with its last whole record, and nothing more can be written.
    """

    def __init__(self, path: Path, profile: str, library: str, *, chunk_bytes: int = CHUNK_BYTES) -> None:
        self.message_count = 0
        self.start_ns, self.end_ns = _NEVER, 0
        self.counts: dict[int, int] = {}
        self._chunk_bytes = chunk_bytes
        self._compressor = zstandard.ZstdCompressor(level=COMPRESSION_LEVEL)
        self._schemas: list[bytes] = []
        self._channels: list[bytes] = []
        self._chunk_indexes: list[bytes] = []
        self._metadata_indexes: list[bytes] = []
        self._begin_chunk()
        self._file = FileIO(path, "x")
        hold(self._file)
        self._end = 0
        self._append(mcap.MAGIC + mcap.record(mcap.HEADER, mcap.text(profile) + mcap.text(library)))

    def add_schema(self, name: str, encoding: str, data: str) -> int:
        """The number of a new schema."""
        number = len(self._schemas) + 1
        content = mcap.UINT16.pack(number) + mcap.text(name) + mcap.text(encoding) + mcap.text(data)
        self._schemas.append(mcap.record(mcap.SCHEMA, content))
        self._chunk += self._schemas[-1]
        return number

    def add_channel(self, topic: str, schema: int, metadata: Mapping[str, str]) -> int:
        """The number of a new channel of CDR messages."""
        number = len(self._channels) + 1
        content = mcap.UINT16.pack(number) + mcap.UINT16.pack(schema) + mcap.text(topic) + mcap.text("cdr")
        self._channels.append(mcap.record(mcap.CHANNEL, content + mcap.text_map(metadata)))
        self._chunk += self._channels[-1]
        self.counts[number] = 0
        return number

    def add_message(self, channel: int, log_time_ns: int, publish_time_ns: int, data: bytes) -> None:
        """Append a message to the chunk, and write the chunk when it is full."""
        chunk = self._chunk
        entry = (log_time_ns, len(chunk))
        size = mcap.MESSAGE_FIELDS + len(data)
        chunk += mcap.MESSAGE_HEAD.pack(mcap.MESSAGE, size, channel, 0, log_time_ns, publish_time_ns)
        chunk += data
        try:
            self._index[channel].append(entry)
        except KeyError:
            self._index[channel] = [entry]
        if len(chunk) >= self._chunk_bytes:
            self.flush()

    def add_metadata(self, name: str, values: Mapping[str, str]) -> None:
        """Write a metadata record, after what was recorded before it."""
        self.flush()
        data = mcap.record(mcap.METADATA, mcap.text(name) + mcap.text_map(values))
        place = mcap.UINT64.pack(self._end) + mcap.UINT64.pack(len(data))
        self._append(data)
        self._metadata_indexes.append(mcap.record(mcap.METADATA_INDEX, place + mcap.text(name)))

    def flush(self) -> None:
        """Hand the chunk so far to the operating system; does nothing if it holds no message."""
        if not self._index:
            return
        times = [time for entries in self._index.values() for time, _ in entries]
        start, end = min(times), max(times)
        plain = bytes(self._chunk)
        packed = self._compressor.compress(plain)
        head = mcap.CHUNK_HEAD.pack(start, end, len(plain), zlib.crc32(plain)) + mcap.text("zstd")
        chunk = mcap.record(mcap.CHUNK, head + mcap.UINT64.pack(len(packed)) + packed)
        place = self._end
        indexes, offsets = self._message_indexes(place + len(chunk))
        content = struct.pack("<QQQQ", start, end, place, len(chunk)) + mcap.UINT32.pack(len(offsets)) + offsets
        content += mcap.UINT64.pack(len(indexes)) + mcap.text("zstd") + struct.pack("<QQ", len(packed), len(plain))
        self._append(chunk + indexes)
        self._count_chunk(start, end)
        self._chunk_indexes.append(mcap.record(mcap.CHUNK_INDEX, content))
        self._begin_chunk()

    def finish(self) -> None:
        """Write what is left and the summary, and close the file; from now on it is complete."""
        self.flush()
        self._append(mcap.record(mcap.DATA_END, mcap.UINT32.pack(0)))
        start = self._end
        groups = [
            (mcap.SCHEMA, self._schemas),
            (mcap.CHANNEL, self._channels),
            (mcap.STATISTICS, [self._statistics()]),
            (mcap.CHUNK_INDEX, self._chunk_indexes),
            (mcap.METADATA_INDEX, self._metadata_indexes),
        ]
        summary, offsets = b"", b""
        for opcode, records in groups:
            data = b"".join(records)
            if data:
                place = struct.pack("<BQQ", opcode, start + len(summary), len(data))
                offsets += mcap.record(mcap.SUMMARY_OFFSET, place)
            summary += data
        footer = mcap.RECORD_HEAD.pack(mcap.FOOTER, 20) + struct.pack("<QQ", start, start + len(summary))
        tail = summary + offsets + footer
        self._append(tail + mcap.UINT32.pack(zlib.crc32(tail)) + mcap.MAGIC)
        os.fsync(self._file.fileno())
        self._file.close()

    def close(self) -> None:
        """Close the file as it is, without a summary."""
        self._file.close()

    def _begin_chunk(self) -> None:
        self._chunk = bytearray()
        self._index: dict[int, list[tuple[int, int]]] = {}

    def _count_chunk(self, start: int, end: int) -> None:
        for channel, entries in self._index.items():
            self.counts[channel] += len(entries)
            self.message_count += len(entries)
        self.start_ns, self.end_ns = min(start, self.start_ns), max(end, self.end_ns)

    def _message_indexes(self, place: int) -> tuple[bytes, bytes]:
        """The index records of the chunk, which begin at `place`, and where that of each channel is."""
        records, offsets = b"", b""
        for channel, entries in self._index.items():
            offsets += struct.pack("<HQ", channel, place + len(records))
            numbers = [number for entry in sorted(entries) for number in entry]
            content = struct.pack(f"<HI{len(numbers)}Q", channel, 8 * len(numbers), *numbers)
            records += mcap.record(mcap.MESSAGE_INDEX, content)
        return records, offsets

    def _statistics(self) -> bytes:
        start = self.start_ns if self.message_count else 0
        counts = b"".join(struct.pack("<HQ", channel, count) for channel, count in self.counts.items())
        tables = (
            len(self._schemas),
            len(self._channels),
            0,
            len(self._metadata_indexes),
            len(self._chunk_indexes),
        )
        content = struct.pack("<QHIIIIQQ", self.message_count, *tables, start, self.end_ns)
        return mcap.record(mcap.STATISTICS, content + mcap.UINT32.pack(len(counts)) + counts)

    def _append(self, data: bytes) -> None:
        """Write all the bytes, or none of them and raise OSError."""
        rest = memoryview(data)
        try:
            while rest:
                rest = rest[self._file.write(rest) or 0 :]
        except OSError:
            with suppress(OSError):
                self._file.truncate(self._end)
            self._file.close()
            raise
        self._end += len(data)
