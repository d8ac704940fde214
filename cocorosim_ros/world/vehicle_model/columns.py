"""Rows of numbers by name: what stands in which column is said once, by the order of the names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from cocorosim_ros.foundation.errors import CocorosimError


def numbered(names: Iterable[str]) -> dict[str, int]:
    """The column of every name, in their order. Raises CocorosimError for a name that stands there twice."""
    columns: dict[str, int] = {}
    for name in names:
        if name in columns:
            raise CocorosimError(f"A row of numbers has two columns '{name}'; give one of them another name.")
        columns[name] = len(columns)
    return columns


def stretch_of(columns: Mapping[str, int], names: Sequence[str]) -> slice:
    """The columns of names that stand behind each other in this order. Raises CocorosimError where they do not."""
    first = columns[names[0]]
    found = [columns[name] for name in names]
    if found != list(range(first, first + len(names))):
        raise CocorosimError(f"Columns {', '.join(names)} stand at {found}; they have to stand behind each other.")
    return slice(first, first + len(names))
