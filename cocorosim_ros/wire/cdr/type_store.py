"""Message types without ROS: the standard types of Jazzy and our own, read from their .msg texts.

The texts of our own types exist once, in the interface package. They are looked for where that package
installs them (share/cocorosim_msgs/msg under each prefix of AMENT_PREFIX_PATH, then under that of this package),
then among this package's own files (share/cocorosim_ros/msg, which pip installs) and last in the checkout.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.interfaces import Nodetype
from rosbags.serde import SerdeError
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.installation import PACKAGE, ament_prefixes, own_prefixes

OWN_PACKAGE = "cocorosim_msgs"
SECTION = "=" * 80 + "\n"


def definition_folders() -> list[Path]:
    """The folders that may hold our .msg files, in the order in which they are tried."""
    own = own_prefixes()
    installed = [prefix / "share" / OWN_PACKAGE / "msg" for prefix in (*ament_prefixes(), *own)]
    copied = [prefix / "share" / PACKAGE / "msg" for prefix in own]
    return [*installed, *copied, Path(__file__).resolve().parents[3] / "msg_defs" / "msg"]


@cache
def own_definitions() -> dict[str, str]:
    """The .msg text of each of our own types, by full type name (cocorosim_msgs/msg/Compass).

    Raises CocorosimError if no folder holds them.
    """
    for folder in definition_folders():
        files = sorted(folder.glob("*.msg"))
        if files:
            return {f"{OWN_PACKAGE}/msg/{file.stem}": file.read_text("utf-8") for file in files}
    tried = ", ".join(str(folder) for folder in definition_folders())
    raise CocorosimError(
        f"The message definitions of {OWN_PACKAGE} were not found in any of: {tried}; install {PACKAGE} again, "
        "or build the interface package with colcon and source its setup file."
    )


@cache
def type_store() -> Typestore:
    """The store of all known types: ROS 2 Jazzy's own and cocorosim_msgs."""
    store = get_typestore(Stores.ROS2_JAZZY)
    types: dict[str, Any] = {}
    for name, text in own_definitions().items():
        types.update(get_types_from_msg(text, name))
    store.register(types)
    return store


def is_known(type_name: str) -> bool:
    """Whether the store holds a type of this name (package/msg/Type)."""
    return type_name in type_store().fielddefs


@cache
def schema_text(type_name: str) -> str:
    """The complete `ros2msg` text of a type: its own fields, then every type it uses under a MSG: header.

    Our own types keep the comments of their .msg files. Raises CocorosimError for an unknown type.
    """
    _check_known(type_name)
    text, _ = type_store().generate_msgdef(type_name, ros_version=2)
    first, *rest = text.split(SECTION)
    sections = [own_definitions().get(type_name, first)]
    for section in rest:
        header, body = section.split("\n", 1)
        package, name = header.removeprefix("MSG: ").split("/")
        sections.append(f"{header}\n{own_definitions().get(f'{package}/msg/{name}', body)}")
    return SECTION.join(section if section.endswith("\n") else section + "\n" for section in sections)


@cache
def type_hash(type_name: str) -> str:
    """The RIHS01 hash of a type, as REP 2011 defines it and rosbag2 records it."""
    _check_known(type_name)
    return type_store().hash_rihs01(type_name)


def build(type_name: str, values: Mapping[str, Any] | None = None) -> Any:
    """A message of the store with the given fields; what is not given is zero, empty or, in a list, absent.

    Nested messages and lists of messages are given as mappings. Raises CocorosimError for unknown types and
    fields.
    """
    _check_known(type_name)
    given = dict(values or {})
    fields = type_store().fielddefs[type_name][1]
    arguments = {name: _value(description, given.pop(name, None)) for name, description in fields}
    if given:
        known = ", ".join(name for name, _ in fields)
        raise CocorosimError(f"{type_name} has no field {sorted(given)[0]!r}; its fields are: {known}.")
    return type_store().types[type_name](**arguments)


def serialize(message: Any) -> bytes:
    """The CDR bytes of a message of the store: little endian, 4 byte encapsulation header, padding zero."""
    return bytes(type_store().serialize_cdr(message, message.__msgtype__, little_endian=True))


def deserialize(type_name: str, data: bytes) -> Any:
    """The message in CDR bytes of either byte order. Raises CocorosimError if they hold none of that type."""
    _check_known(type_name)
    try:
        return type_store().deserialize_cdr(data, type_name)
    except (SerdeError, IndexError, OverflowError, MemoryError) as error:
        raise CocorosimError(f"{len(data)} bytes are not a message of type {type_name}: {error}.") from error


def _check_known(type_name: str) -> None:
    if not is_known(type_name):
        raise CocorosimError(
            f"The message type {type_name!r} is not known; give a type of ROS 2 Jazzy's common interfaces "
            f"or of "
            f"{OWN_PACKAGE}, written as package/msg/Type."
        )


def _value(description: Any, given: Any) -> Any:
    """The value of one field as the store wants it, from what the caller gave."""
    kind, detail = description
    if kind in (Nodetype.ARRAY, Nodetype.SEQUENCE):
        return _sequence(detail, given, fixed=kind == Nodetype.ARRAY)
    if kind == Nodetype.NAME:
        return given if hasattr(given, "__msgtype__") else build(detail, given)
    base, _ = detail
    if base == "string":
        return "" if given is None else str(given)
    return {"bool": bool, "float32": float, "float64": float}.get(base, int)(given or 0)


def _sequence(detail: Any, given: Any, *, fixed: bool) -> Any:
    element, count = detail
    kind, name = element
    missing = [None] * (count if fixed else 0)
    if kind == Nodetype.NAME or name[0] == "string":
        return [_value(element, entry) for entry in (missing if given is None else given)]
    numbers = {"byte": "uint8", "char": "uint8"}.get(name[0], name[0])
    return np.array([0] * len(missing) if given is None else given, dtype=np.dtype(numbers))
