"""When a message was measured, read from its CDR bytes without decoding the rest.

A type has a stamp when its first field is a std_msgs/Header or a builtin_interfaces/Time, a message that
begins so, or a list of such messages (tf2_msgs/TFMessage); then the stamp stands at the very front of the
bytes.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from rosbags.interfaces import Nodetype

from cocorosim_ros.wire.cdr.alignment import BODY, LENGTH_BYTES, STAMP_BYTES
from cocorosim_ros.wire.cdr.primitives import BIG_STAMP, NANOSECONDS, STAMP
from cocorosim_ros.wire.cdr.type_store import is_known, type_store

_TIME = "builtin_interfaces/msg/Time"
_unpack_little, _unpack_big = STAMP.unpack_from, BIG_STAMP.unpack_from
_LEADING_STAMP = re.compile(r"(std_msgs/)?(msg/)?Header|builtin_interfaces/(msg/)?Time")


def stamp_ns(type_name: str, data: bytes, schema: str = "") -> int | None:
    """The stamp of a message [ns], from its CDR bytes; None where the type has none or the list is empty.

    Args:
        type_name: package/msg/Type.
        data: CDR bytes of either byte order, with their encapsulation header.
        schema: `ros2msg` text of the type; needed only for types that the type store does not know.
    """
    offset = stamp_offset(type_name, schema)
    if offset is None or len(data) < offset + STAMP_BYTES:
        return None
    if offset > BODY and not any(data[BODY:offset]):
        return None
    seconds, nanoseconds = (_unpack_little if data[1] & 1 else _unpack_big)(data, offset)
    return int(seconds * NANOSECONDS + nanoseconds)


@cache
def stamp_offset(type_name: str, schema: str = "") -> int | None:
    """Where the stamp begins in CDR bytes of this type, encapsulation header included; None without one."""
    if not is_known(type_name):
        return BODY if _begins_with_stamp(schema) else None
    offset = BODY
    detail: Any
    while type_name != _TIME:
        fields = type_store().fielddefs[type_name][1]
        if not fields:
            return None
        kind, detail = fields[0][1]
        if kind == Nodetype.SEQUENCE and detail[0][0] == Nodetype.NAME and offset == BODY:
            offset += LENGTH_BYTES
            type_name = detail[0][1]
        elif kind == Nodetype.NAME:
            type_name = detail
        else:
            return None
    return offset


def _begins_with_stamp(schema: str) -> bool:
    for line in schema.splitlines():
        words = line.partition("#")[0].split()
        if not words or "=" in line.partition("#")[0]:
            continue
        return _LEADING_STAMP.fullmatch(words[0]) is not None
    return False
