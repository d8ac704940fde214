"""Platform and controller files say for each number where it comes from; this is the check."""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.law_text import is_law
from cocorosim_ros.scenario.reading.quantity import is_quantity


def require_sources(entry: Entry) -> None:
    """Nothing, if every number below stands as {value, unit, source}, else CocorosimError."""
    for leaf in _bare_leaves(entry):
        if is_quantity(leaf.value) or is_law(leaf.value):
            raise leaf.problem(f"has {leaf.found()} without a source; write {{value: ..., unit: ..., source: ...}}.")


def _bare_leaves(entry: Entry) -> Iterator[Entry]:
    """The values that do not stand inside a mapping with 'value'."""
    if isinstance(entry.value, dict):
        parts = [] if "value" in entry.value else list(entry.value.values())
    elif isinstance(entry.value, list):
        parts = entry.value
    else:
        yield entry
        return
    for part in parts:
        yield from _bare_leaves(part)
