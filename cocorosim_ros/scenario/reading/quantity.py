"""Numbers with their units: text such as '0.5 s', or mappings {value, unit, source}, to SI and back.

The table of `foundation.units` is all there is: a unit that files may not have is refused. Each unit belongs to one
dimension.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from typing import Any, Literal

from cocorosim_ros.foundation.units.units import units_in_files
from cocorosim_ros.scenario.reading.entry import Entry, listed

Sign = Literal["any", "not negative", "positive"]

UNITS: dict[str, dict[str, str]] = units_in_files()
"""By dimension: factors to SI as decimal text; the first unit is SI."""
_LONGEST_NS = 2**63 - 1  # stamps are whole nanoseconds in 64 bits
_DIMENSION_OF = {unit: dimension for dimension, units in UNITS.items() for unit in units}
NUMBER = r"[-+]?(?:(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?|\.?(?:inf|nan|Inf|NaN))"
_TEXT = re.compile(rf"\s*({NUMBER})\s*(.*?)\s*")
CONFIDENCES = ("measured", "literature", "derived", "estimate", "fitted")
SOURCE_KEYS = ("source", "note", "confidence")


@dataclass(frozen=True)
class Quantity:
    """A number in SI units with the SI unit's name and its dimension."""

    value: float
    unit: str
    dimension: str


def si_unit(dimension: str) -> str:
    """The SI unit of a dimension."""
    return next(iter(UNITS[dimension]))


def dimension_of(unit: str) -> str:
    """The dimension that a unit of UNITS belongs to."""
    return _DIMENSION_OF[unit]


def has_dimension(unit: str) -> bool:
    """Whether files may have the unit."""
    return unit in _DIMENSION_OF


def read_quantity(entry: Entry, dimension: str, sign: Sign = "any") -> float:
    """The entry in SI units: text '6 m', {value: 6, unit: m, source: ...}, or a bare pure number."""
    value, unit = _value_and_unit(entry)
    return _checked_si(value, unit, entry, dimension, sign)


def read_any_quantity(entry: Entry) -> Quantity:
    """The entry in SI units, whatever its dimension; for tables whose dimensions are checked elsewhere."""
    value, unit = _value_and_unit(entry)
    dimension = _DIMENSION_OF.get(unit)
    if dimension is None:
        raise entry.problem(
            f"has {_shown(value, unit, entry)}, whose unit is unknown; allowed: {', '.join(_DIMENSION_OF)}."
        )
    return Quantity(_checked_si(value, unit, entry, dimension, "any"), si_unit(dimension), dimension)


def read_vector(entry: Entry, dimensions: Sequence[str], sign: Sign = "any") -> tuple[float, ...]:
    """One SI number per dimension, from [6 m, 6 m, 2 m] or {value: [6, 6, 2], unit: m, source: ...}."""
    parts = _parts(entry)
    if len(parts) != len(dimensions):
        form = ", ".join(f"... {si_unit(each)}" for each in dimensions)
        given = entry.value["value"] if isinstance(entry.value, dict) else entry
        raise entry.problem(f"has {given.found()}; write {len(dimensions)} values: [{form}].")
    return tuple(read_quantity(part, each, sign) for part, each in zip(parts, dimensions, strict=True))


def read_list(entry: Entry, dimension: str) -> tuple[float, ...]:
    """Any number of SI numbers of one dimension, in the forms of `read_vector`."""
    return tuple(read_quantity(part, dimension) for part in _parts(entry))


def read_nanoseconds(entry: Entry, sign: Sign = "positive") -> int:
    """A time, a positive one unless told otherwise, as a whole number of nanoseconds."""
    seconds = read_quantity(entry, "time", sign)
    value, unit = _value_and_unit(entry)
    exact = Decimal(repr(float(value))) * Decimal(UNITS["time"][unit]) * 1_000_000_000
    if exact != exact.to_integral_value():
        raise entry.problem(f"has {entry.found()}, which is not a whole number of nanoseconds; round {seconds!r} s.")
    if abs(exact) > _LONGEST_NS:
        raise entry.problem(f"has {entry.found()}, which is longer than 292 years; write a time of use.")
    return int(exact)


def quantity_text(value: float, dimension: str) -> str:
    """The SI number with its unit; `read_quantity` gives exactly the same number back."""
    return repr(value) if dimension == "pure number" else f"{value!r} {si_unit(dimension)}"


def nanoseconds_text(nanoseconds: int) -> str:
    """Whole nanoseconds as seconds in exact decimals."""
    whole, rest = divmod(nanoseconds, 1_000_000_000)
    decimals = f"{rest:09d}".rstrip("0")
    return f"{whole}.{decimals} s" if decimals else f"{whole} s"


def is_quantity(value: Any) -> bool:
    """Whether a value is a number, or text that is a number with a known unit or none."""
    match = _TEXT.fullmatch(value) if isinstance(value, str) else None
    return _is_number(value) or (match is not None and (not match[2] or match[2] in _DIMENSION_OF))


def _parts(entry: Entry) -> list[Entry]:
    """The numbers of a vector, each as an entry under the vector's own key, which the sentence names."""
    if not isinstance(entry.value, dict):
        return [replace(part, key=entry.key) for part in entry.items()]
    section = _sourced_section(entry)
    unit = section["unit"].value
    return [
        replace(part, key=entry.key, value=f"{part.value} {unit}" if _is_number(part.value) else part.value)
        for part in section["value"].items()
    ]


def _value_and_unit(entry: Entry) -> tuple[Any, str]:
    if isinstance(entry.value, dict):
        section = _sourced_section(entry)
        return section["value"].value, str(section["unit"].value)
    if isinstance(entry.value, str):
        match = _TEXT.fullmatch(entry.value)
        return (float(match[1].replace(".inf", "inf").replace(".nan", "nan")), match[2]) if match else (None, "")
    return entry.value, ""


def _sourced_section(entry: Entry) -> dict[str, Entry]:
    section = entry.section(("value", "unit", "source"), ("note", "confidence", "range", "ci95"))
    section["source"].text()
    if "confidence" in section:
        section["confidence"].choice(CONFIDENCES)
    return section


def _checked_si(value: Any, unit: str, entry: Entry, dimension: str, sign: Sign) -> float:
    units = UNITS[dimension]
    shown = _shown(value, unit, entry)
    form = f"write it in {listed(units)}, e.g. '6 {si_unit(dimension)}'"
    if not _is_number(value):
        raise entry.problem(f"has {shown}, which is not {_article(dimension)}; {form}.")
    if not unit and dimension == "pure number":
        unit = "1"
    if not unit:
        raise entry.problem(f"has {shown}, which has no unit; {form}.")
    if unit not in units:
        raise entry.problem(f"has {shown}, which is not {_article(dimension)}; {form}.")
    return _in_si(value, units[unit], entry, shown, sign)


def _in_si(value: float, factor: str, entry: Entry, shown: str, sign: Sign) -> float:
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise entry.problem(f"has {shown}, which is not a finite number; write a finite one.")
    if sign == "positive" and number <= 0:
        raise entry.problem(f"has {shown}; it must be greater than zero.")
    if sign == "not negative" and number < 0:
        raise entry.problem(f"has {shown}; it must not be negative.")
    if factor == "1":
        return number
    return float(Decimal(repr(number)) * Decimal(factor))


def _shown(value: Any, unit: str, entry: Entry) -> str:
    if _is_number(value) and not isinstance(entry.value, str):
        return f"'{value} {unit}'" if unit else f"'{value}'"
    return entry.found()


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _article(dimension: str) -> str:
    return f"{'an' if dimension[0] in 'aeiou' else 'a'} {dimension}"
