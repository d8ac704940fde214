"""Ranges and intervals beside the numbers of a platform: what is not known exactly, and between what it lies.

`mass: {value: 2, unit: kg, range: [1, 4], source: ..., confidence: estimate}` says that a fit of the mass starts from
2 kg and stays between 1 and 4 kg. `ci95: [1.9, 2.1]` says that 2 kg was measured, and is as sure as a 95 % interval
from 1.9 to 2.1 kg: it limits nothing, but another measurement within its doubt is no change. A simulation uses the
value alone. Beside a law in words they are of its number, in SI units, and stand under its key `coefficient`. Beside a
list below `six_degrees` they are two lists, `range: [[100, 150, 150], [200, 300, 300]]`, for its numbers one by one;
one that is the same in both has none.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.law_text import is_law, parsed_law
from cocorosim_ros.scenario.reading.quantity import Quantity, read_any_quantity


@dataclass(frozen=True)
class Range:
    """Where a number lies, in the SI unit `unit`."""

    low: float
    high: float
    unit: str


Ranges = Mapping[str, Range]


RANGE, INTERVAL = "range", "ci95"
OF_LISTS = "six_degrees."
"""How the keys of those lists begin whose numbers may have a range each."""


def collect_ranges(entry: Entry, kind: str = RANGE) -> dict[str, Range]:
    """The ranges of all numbers below, by dotted key; parts of a list go by name: actuators.left.maximum.

    kind: RANGE or INTERVAL, the key of the two numbers.
    Raises CocorosimError: not two numbers in growing order, the value outside them, a range beside a list.
    """
    return {key: _read(place, kind) for key, place in _ranged(entry, kind, "")}


def read_ranges(entry: Entry) -> dict[str, Range]:
    """The ranges as `ranges_tree` writes them."""
    return {key: _between(place, *(read_any_quantity(part) for part in place.items()))
            for key, place in entry.mapping().items()}  # fmt: skip


def ranges_tree(ranges: Ranges) -> dict[str, Any]:
    """The ranges as plain values: {mass: ["1.0 kg", "4.0 kg"]}."""
    return {key: [f"{part.low!r} {part.unit}", f"{part.high!r} {part.unit}"] for key, part in ranges.items()}


def _ranged(entry: Entry, kind: str, key: str) -> Iterator[tuple[str, Entry]]:
    """Key and entry of every number that has a range of that kind."""
    if isinstance(entry.value, dict):
        if kind in entry.value and "value" in entry.value:
            if key.startswith(OF_LISTS) and isinstance(entry.value["value"].value, list):
                yield from _one_by_one(entry, kind, key)
                return
            law = is_law(entry.value["value"].value)  # of which the range is one of its number
            yield f"{key.rpartition('.')[0]}.coefficient" if law else key, entry
            return
        for name, part in entry.value.items():
            yield from _ranged(part, kind, f"{key}.{name}" if key else name)
    elif isinstance(entry.value, list):
        for index, part in enumerate(entry.value):
            yield from _ranged(part, kind, f"{key}.{_name(part, index)}")


def _one_by_one(entry: Entry, kind: str, key: str) -> Iterator[tuple[str, Entry]]:
    """Key and entry of every number of a list whose range has two ends."""
    section = entry.mapping()
    values, ends = section["value"].items(), section[kind].items()
    if [len(end.value) if isinstance(end.value, list) else 0 for end in ends] != [len(values)] * 2:
        raise section[kind].problem(
            f"has {section[kind].found()} beside a list of {len(values)}; write the lowest and the highest of each, "
            f"[[...], [...]], of {len(values)} numbers each."
        )
    for index, (value, low, high) in enumerate(zip(values, *(end.items() for end in ends), strict=True)):
        if low.value != value.value or high.value != value.value:
            limits = replace(section[kind], value=[low, high])
            yield f"{key}.{index}", replace(entry, value={**section, "value": value, kind: limits})


def _name(entry: Entry, index: int) -> str:
    named = entry.value.get("name") if isinstance(entry.value, dict) else None
    return str(named.value) if named is not None else str(index)


def _read(entry: Entry, kind: str) -> Range:
    section = entry.mapping()
    limits = section[kind]
    if isinstance(section["value"].value, list):
        raise limits.problem(f"stands beside a list; give a {kind} to single numbers only.")
    numbers = [_quantity(section, part) for part in limits.items()]
    between = _between(limits, *numbers)
    value = _quantity(section, section["value"]).value
    if not between.low <= value <= between.high:
        raise limits.problem(f"has {limits.found()}, which leaves out the value {section['value'].found()}; widen it.")
    return between


def _quantity(section: Mapping[str, Entry], number: Entry) -> Quantity:
    """A number in the unit of its section; of a law in words its coefficient, in SI units."""
    law = parsed_law(section["value"].value)
    if law is None:
        return read_any_quantity(replace(number, value=f"{number.value} {section['unit'].value}"))
    value = law.coefficient if number is section["value"] else number.value
    return read_any_quantity(replace(number, value=f"{value} 1"))


def _between(entry: Entry, *numbers: Quantity) -> Range:
    if len(numbers) != 2 or not numbers[0].value < numbers[1].value:
        raise entry.problem(f"has {entry.found()}; write the lowest and the highest value: [low, high].")
    return Range(numbers[0].value, numbers[1].value, numbers[0].unit)
