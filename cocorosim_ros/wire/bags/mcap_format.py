"""The records of an MCAP file as bytes.

Source: MCAP version 0 specification, https://mcap.dev/spec. All numbers are little endian; texts and maps
are preceded by their length in bytes as uint32.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping

MAGIC = b"\x89MCAP0\r\n"
HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX = range(1, 9)
STATISTICS, METADATA, METADATA_INDEX, SUMMARY_OFFSET, DATA_END = 0x0B, 0x0C, 0x0D, 0x0E, 0x0F

RECORD_HEAD = struct.Struct("<BQ")  # opcode, length of what follows
MESSAGE_HEAD = struct.Struct("<BQHIQQ")  # opcode, length, channel, sequence, log time, publish time
MESSAGE_FIELDS = 22  # bytes between the record head and the data of a message
CHUNK_HEAD = struct.Struct("<QQQI")  # start time, end time, uncompressed size, CRC-32
UINT16, UINT32, UINT64 = struct.Struct("<H"), struct.Struct("<I"), struct.Struct("<Q")


def record(opcode: int, content: bytes) -> bytes:
    """One whole record."""
    return RECORD_HEAD.pack(opcode, len(content)) + content


def text(value: str) -> bytes:
    """A text with its length."""
    data = value.encode()
    return UINT32.pack(len(data)) + data


def text_map(values: Mapping[str, str]) -> bytes:
    """A map of texts with its length."""
    data = b"".join(text(key) + text(value) for key, value in values.items())
    return UINT32.pack(len(data)) + data


class Cursor:
    """Takes numbers and texts from bytes one after the other. Raises ValueError where the bytes end."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.place = 0

    def take(self, count: int) -> bytes:
        """The next bytes."""
        end = self.place + count
        if end > len(self.data):
            raise ValueError(f"{count} bytes wanted at {self.place}, {len(self.data)} there")
        part = self.data[self.place : end]
        self.place = end
        return part

    def number(self, form: struct.Struct) -> int:
        """The next number of this form."""
        return int(form.unpack(self.take(form.size))[0])

    def text(self) -> str:
        """The next text."""
        return self.take(self.number(UINT32)).decode()

    def text_map(self) -> dict[str, str]:
        """The next map of texts."""
        inner = Cursor(self.take(self.number(UINT32)))
        values: dict[str, str] = {}
        while inner.place < len(inner.data):
            key = inner.text()
            values[key] = inner.text()
        return values
