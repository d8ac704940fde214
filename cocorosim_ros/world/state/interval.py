"""A stretch of time, as compiled functions are given one."""

from __future__ import annotations

from typing import NamedTuple


class Interval(NamedTuple):
    """When something begins, and how long it takes [s]; of length zero it is a moment."""

    begin: float
    length: float
