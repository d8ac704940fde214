"""Paths, names, whole numbers, times and functions that users give as arguments, or a sentence that says why not.

Each check is told the name of its argument, and raises ArgumentError, which says it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from numbers import Real
from os import PathLike, fspath
from typing import Any

import numpy as np

from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.scenario.reading.entry import Entry, argument_entry
from cocorosim_ros.scenario.reading.quantity import read_nanoseconds

LARGEST = 2**63 - 1
_LONGEST_SHOWN = 60  # characters of a value

Place = str | PathLike[str]
"""A path, or a name where names are allowed."""
Time = str | float
"""A length of time: text with a unit, such as '60 s', or a number [s]."""
Seed = int | np.integer[Any]
"""A whole number from 0 to 2**63 - 1."""


def place_text(place: object, name: str) -> str:
    """A path or a name as text."""
    if isinstance(place, str | PathLike) and isinstance(text := fspath(place), str):
        return text
    raise refused(place, name, "which is no path; give text or a path")


def whole_number(number: object, name: str, least: int = 1, most: int = LARGEST) -> int:
    """A whole number from `least` to `most`."""
    if isinstance(number, int | np.integer) and not isinstance(number, bool) and least <= number <= most:
        return int(number)
    reach = f"from {least} on" if most == LARGEST else f"from {least} to {most}"
    raise ArgumentError(f"The argument '{name}' has {_shown(number)}; give a whole number {reach}.", name)


def time_text(time: object, name: str) -> str:
    """A time as text with a unit."""
    if isinstance(time, str):
        return time
    is_truth = isinstance(time, bool | np.bool_)
    if isinstance(time, Real) and not is_truth:
        try:
            return f"{float(time)!r} s"
        except OverflowError:
            return f"{math.inf} s"
    raise refused(time, name, "which is no time; give text such as '60 s', or a number [s]")


def time_entry(time: object, name: str) -> Entry:
    """A time as an entry, as files have it."""
    return argument_entry(time_text(time, name), name)


def nanoseconds(time: object, name: str) -> int:
    """A positive time as whole nanoseconds."""
    return read_nanoseconds(time_entry(time, name))


def names(given: object, name: str) -> list[str]:
    """Names in a list, from several of them or from one alone."""
    if isinstance(given, str):
        return [given]
    several = list(given) if isinstance(given, Iterable) and not isinstance(given, Mapping) else [None]
    for each in several:
        if not isinstance(each, str):
            raise refused(given, name, "which are no names; give a list of texts")
    return [str(each) for each in several]


def function(given: object, name: str) -> None:
    """Nothing, if it can be called."""
    if not callable(given):
        raise refused(given, name, "which cannot be called; give a function")


def one_of(given: object, name: str, kind: type) -> None:
    """Nothing, if it is a record of this kind."""
    if not isinstance(given, kind):
        raise refused(given, name, f"which is no {kind.__name__}; give one")


def refused(value: object, name: str, why: str) -> ArgumentError:
    """The error for a value that cannot be used."""
    return ArgumentError(f"The argument '{name}' has {_shown(value)}, {why}.", name)


def _shown(value: object) -> str:
    """The value in one line that is not too long."""
    words = " ".join(repr(value).split())
    return words if len(words) <= _LONGEST_SHOWN else f"{words[:_LONGEST_SHOWN]}..."
