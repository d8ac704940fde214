"""Colours of what viewers draw."""

from __future__ import annotations

from typing import NamedTuple


class Rgb(NamedTuple):
    """Red, green and blue, 0 to 1 each."""

    r: float
    g: float
    b: float


class Rgba(NamedTuple):
    """Red, green, blue and how opaque, 0 to 1 each."""

    r: float
    g: float
    b: float
    a: float
