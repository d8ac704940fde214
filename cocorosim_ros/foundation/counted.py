"""Counts of things in sentences: 1 row, 2 rows."""

from __future__ import annotations


def counted(number: int, thing: str) -> str:
    """A number and what there are so many of, named in the singular: "1 row", "2 rows"."""
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"


def either(number: int, one: str, several: str) -> str:
    """The word that goes with a number: `one` with 1, else `several`."""
    return one if number == 1 else several
