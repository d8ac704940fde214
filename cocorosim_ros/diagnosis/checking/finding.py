"""Findings of a check."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["file", "clock", "stamps", "rate", "frozen", "values", "frames", "covariance", "units"]


@dataclass(frozen=True)
class Oddity:
    """One thing that is wrong with a recording."""

    kind: Kind
    topic: str
    """'' where it is of the whole recording."""
    sentence: str
