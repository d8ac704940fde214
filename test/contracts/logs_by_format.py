"""A small log in every format of FORMATS, written without the reader: 90 velocities, x = 0.25 m/s times the row.

The rows are 0.5 s apart and begin at 1 s. DataFlash, ULog and tlog are written byte by byte from their descriptions.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

COUNT = 90
ROWS = [(1_000_000 + 500_000 * row, 0.25 * row) for row in range(COUNT)]
"""Time [us] and velocity [m/s] of every row."""


class Log(NamedTuple):
    """How a log of one format is written and mapped."""

    file: str
    write: Callable[[Path], None]
    table: str  # of the map, below `tables`


def _in_files(file: str) -> str:
    return (
        f"  - {{files: {file}, time: {{column: t, unit: us}}, robot: boat, "
        "streams: {velocity: {x: {column: u, unit: m/s}}}}\n"
    )


def _of_topic(topic: str, column: str) -> str:
    return f"  - {{topic: {topic}, robot: boat, streams: {{velocity: {{x: {{column: {column}, unit: m/s}}}}}}}}\n"


def _columns() -> dict[str, Any]:
    return {"t": np.array([time for time, _ in ROWS]), "u": np.array([speed for _, speed in ROWS])}


def _csv(path: Path) -> None:
    path.write_text("t,u\n" + "".join(f"{time},{speed}\n" for time, speed in ROWS), "utf-8")


def _parquet(path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    pyarrow.parquet.write_table(pyarrow.table(_columns()), path)


def _npz(path: Path) -> None:
    np.savez(path, **_columns())


def _mat(path: Path) -> None:
    from scipy.io import savemat

    savemat(path, _columns())


def _bag(path: Path) -> None:
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_JAZZY)
    types, kind = store.types, "geometry_msgs/msg/TwistStamped"
    folder = path.parent / "bag_of_rosbags"
    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connection = writer.add_connection("/velocity", kind, typestore=store)
        for time, speed in ROWS:
            stamp = types["builtin_interfaces/msg/Time"](time // 10**6, time % 10**6 * 1000)
            zero = types["geometry_msgs/msg/Vector3"](0.0, 0.0, 0.0)
            twist = types["geometry_msgs/msg/Twist"](types["geometry_msgs/msg/Vector3"](speed, 0.0, 0.0), zero)
            message = types[kind](types["std_msgs/msg/Header"](stamp, ""), twist)
            writer.write(connection, time * 1000, store.serialize_cdr(message, kind))
    (written,) = folder.glob("*.mcap")
    written.rename(path)


def ulog_message(kind: str, content: bytes) -> bytes:
    """A message of a ULog: length in two bytes, kind, content."""
    return struct.pack("<HB", len(content), ord(kind)) + content


def _ulog(path: Path) -> None:
    parts = [b"ULog\x01\x12\x35\x01" + struct.pack("<Q", 0), ulog_message("B", bytes(40))]
    parts += [ulog_message("F", b"velocity:uint64_t timestamp;float[2] v;")]
    parts += [ulog_message("A", struct.pack("<BH", 0, 7) + b"velocity")]
    parts += [ulog_message("D", struct.pack("<HQff", 7, time, 0.0, speed)) for time, speed in ROWS]
    path.write_bytes(b"".join(parts))


def dataflash_format(kind: int, name: str, letters: str, columns: str) -> bytes:
    """The FMT message that says what messages of a kind are."""
    sizes = {"Q": 8, "f": 4, "B": 1, "H": 2, "c": 2}
    length = 3 + sum(sizes[letter] for letter in letters)
    return b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", kind, length, *(t.encode() for t in (name, letters, columns)))


def _dataflash(path: Path) -> None:
    head = dataflash_format(0x80, "FMT", "", "")[:3] + struct.pack(
        "<BB4s16s64s", 0x80, 89, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns"
    )
    rows = [b"\xa3\x95\x01" + struct.pack("<Qf", time, speed) for time, speed in ROWS]
    path.write_bytes(head + dataflash_format(1, "VEL", "Qf", "TimeUS,U") + b"".join(rows))


def mavlink(number: int, payload: bytes, extra: int, system: int = 1) -> bytes:
    """A MAVLink 1 message; its checksum is CRC-16/MCRF4XX over all but the first byte, and `extra`."""
    body = struct.pack("<BBBBB", len(payload), 0, system, 1, number) + payload
    crc = 0xFFFF
    for byte in body + bytes([extra]):
        low = (byte ^ crc) & 0xFF
        low = (low ^ low << 4) & 0xFF
        crc = (crc >> 8 ^ low << 8 ^ low << 3 ^ low >> 4) & 0xFFFF
    return b"\xfe" + body + struct.pack("<H", crc)


def local_position(time_ms: int, *numbers: float, system: int = 1) -> bytes:
    """LOCAL_POSITION_NED of x, y, z [m] and vx, vy, vz [m/s]."""
    return mavlink(32, struct.pack("<I6f", time_ms, *numbers), 185, system)


def _tlog(path: Path) -> None:
    parts = [struct.pack(">Q", time) + local_position(time // 1000, 0, 0, 0, speed, 0, 0) for time, speed in ROWS]
    path.write_bytes(b"".join(parts))


LOGS: Mapping[str, Log] = {
    "csv": Log("log.csv", _csv, _in_files("log.csv")),
    "parquet": Log("log.parquet", _parquet, _in_files("log.parquet")),
    "npz": Log("log.npz", _npz, _in_files("log.npz")),
    "mat": Log("log.mat", _mat, _in_files("log.mat")),
    "bag": Log("log.mcap", _bag, _of_topic("/velocity", "twist.linear.x")),
    "ulog": Log("log.ulg", _ulog, _of_topic("velocity", '"v[1]"')),
    "dataflash": Log("log.bin", _dataflash, _of_topic("VEL", "U")),
    "tlog": Log("log.tlog", _tlog, _of_topic("LOCAL_POSITION_NED", "vx")),
}
