"""Numbers in a message by path: `pose.position.x`, `command[left]`, `readings[left].azimuth`, `payload[0]`.

A word in brackets names an element: of a list of messages the one whose first text field is that word; of a
plain list the one at the position that the word has in the list `name` beside it. Where there are no such
names, it is a position; `[#2]` is always a position.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

_STEP = re.compile(r"(\w+)(?:\[([^\]]*)\])?(?:\.|$)")


class Step(NamedTuple):
    """A field, and which element of it where it is a list."""

    field: str
    element: str | None


def steps(path: str) -> list[Step]:
    """The path, field by field. Raises ValueError if it is not a path."""
    matches = list(_STEP.finditer(path))
    if not matches or "".join(match[0] for match in matches) != path or path.endswith("."):
        raise ValueError(f"{path!r} is not a path of fields")
    return [Step(match[1], match[2]) for match in matches]


def element_names(owner: Any, field: str) -> list[str] | None:
    """The names of a list's elements, or None where they have none and count by position."""
    elements = getattr(owner, field)
    if isinstance(elements, list) and elements and hasattr(elements[0], "__msgtype__"):
        texts = [next((value for value in vars(entry).values() if isinstance(value, str)), None) for entry in elements]
        return [text for text in texts if text is not None] if None not in texts else None
    names = getattr(owner, "name", None)
    return names if isinstance(names, list) else None


def position(owner: Any, field: str, element: str) -> int | None:
    """The position of a named element in its list; None if the list does not have it."""
    names = None if element.startswith("#") else element_names(owner, field)
    if names is not None:
        index = names.index(element) if element in names else -1
    else:
        digits = element.removeprefix("#")
        index = int(digits) if digits.isdecimal() else -1
    return index if 0 <= index < len(getattr(owner, field)) else None


def read(message: Any, path: list[Step]) -> float:
    """The number at a path; NaN where the message does not hold that element."""
    for field, element in path:
        owner, message = message, getattr(message, field)
        if element is not None:
            index = position(owner, field, element)
            if index is None:
                return math.nan
            message = message[index]
    return float(message)


def write(message: Any, path: list[Step], value: Any) -> None:
    """Set what is at a path. Raises KeyError if the message does not hold that element."""
    *before, (field, element) = path
    for name, inner in before:
        message = _child(message, name, inner)
    if element is None:
        setattr(message, field, value)
    else:
        index = position(message, field, element)
        if index is None:
            raise KeyError(f"{field}[{element}]")
        getattr(message, field)[index] = value


def owner_of(message: Any, path: list[Step]) -> Any:
    """The message that a path leads to; every step of it must exist."""
    for field, element in path:
        message = _child(message, field, element)
    return message


def fields_within(message: Any, before: str = "") -> Iterator[tuple[str, Any]]:
    """Path and value of every field that is not a message itself; messages in lists are left out."""
    for field, value in vars(message).items():
        path = f"{before}.{field}" if before else field
        if hasattr(value, "__msgtype__"):
            yield from fields_within(value, path)
        else:
            yield path, value


def number_paths(message: Any) -> list[str]:
    """The paths of all single numbers in a message, but for those of times; lists are left out."""
    return [
        path
        for path, value in fields_within(message)
        if isinstance(value, (int, float, bool)) and path.rpartition(".")[2] not in ("sec", "nanosec")
    ]


def _child(message: Any, field: str, element: str | None) -> Any:
    child = getattr(message, field)
    if element is None:
        return child
    index = position(message, field, element)
    if index is None:
        raise KeyError(f"{field}[{element}]")
    return child[index]


def times_in(message: Any, before: str = "") -> list[str]:
    """The paths of all builtin_interfaces/Time inside a message, by position in lists."""
    found: list[str] = []
    for field, value in vars(message).items():
        path = f"{before}.{field}" if before else field
        if isinstance(value, list):
            nested = [(f"{path}[#{index}]", entry) for index, entry in enumerate(value)]
        else:
            nested = [(path, value)]
        for place, entry in nested:
            if getattr(entry, "__msgtype__", "") == "builtin_interfaces/msg/Time":
                found.append(place)
            elif hasattr(entry, "__msgtype__"):
                found.extend(times_in(entry, place))
    return found
