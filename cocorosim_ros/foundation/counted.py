"""Counts of things in sentences: 1 row, 2 rows."""

from __future__ import annotations

from typing import SupportsInt


def counted(number: SupportsInt, thing: str) -> str:
    """A number and what there are so many of, named in the singular: "1 row", "2 rows"."""
    return f"{number} {either(number, thing, f'{thing}s')}"


def either(number: SupportsInt, one: str, several: str) -> str:
    """The word that goes with a number: `one` with 1, else `several`."""
    return one if int(number) == 1 else several
