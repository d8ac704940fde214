"""The numbers of a map file: columns and formulas with units, fixed values, thruster commands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from cocorosim_ros.scenario.reading.entry import Entry, listed
from cocorosim_ros.scenario.reading.quantity import UNITS, read_quantity, si_unit
from cocorosim_ros.wire.conversion import formula
from cocorosim_ros.wire.conversion.conversion_map import (
    ColumnValue,
    CommandValue,
    FixedValue,
    MixedValue,
    TravelValue,
    UnknownValue,
    Value,
)
from cocorosim_ros.wire.conversion.run_wise import Number, read_number

COMMAND_DIMENSIONS = ("pure number", "time", "voltage", "force", "torque", "angle", "angular velocity")
_COLUMN_KEYS = ("column", "formula", "unit", "scale", "offset")
_LIMITS = ("stop", "forward", "reverse")
_MEASURED = "measured"
_HEADINGS: dict[str, Value] = {"travel": TravelValue(), "unknown": UnknownValue()}


@dataclass(frozen=True)
class ValueReader:
    """Reads the numbers of streams; in bags a number without a unit is in SI, as REP 103 asks.

    names: short names of columns for formulas; constants: numbers of the map for formulas, by their names.
    """

    from_bag: bool
    names: Mapping[str, Entry] = field(default_factory=dict)
    constants: Mapping[str, Number] = field(default_factory=dict)

    def value(self, entry: Entry, dimension: str) -> ColumnValue | FixedValue:
        """A column, a formula or a fixed number of that dimension."""
        section = entry.section((), (*_COLUMN_KEYS, "fixed"))
        if "fixed" in section:
            entry.section(("fixed",))
            return FixedValue(read_number(section["fixed"], lambda part: read_quantity(part, dimension)))
        return self.column(entry, (dimension,))

    def heading(self, entry: Entry) -> Value:
        """As `value`, {travel: true} for the direction of travel, or {unknown: true} where none was recorded."""
        for word, value in _HEADINGS.items():
            if word in entry.mapping():
                if not entry.section((word,))[word].flag():
                    raise entry.problem(f"has '{word}: false'; name a column, a fixed angle, or '{word}: true'.")
                return value
        return self.value(entry, "angle")

    def command(self, entry: Entry) -> CommandValue:
        """A thruster's column with the cells that stand for stop, full ahead and full astern."""
        section = entry.section((), (*_COLUMN_KEYS, *_LIMITS, _MEASURED))
        bare = {name: part for name, part in section.items() if name in _COLUMN_KEYS}
        column = self.column(replace(entry, value=bare), COMMAND_DIMENSIONS)
        dimension = self._dimension(section, COMMAND_DIMENSIONS)
        given = {name: section[name] for name in _LIMITS if name in section}
        if dimension != "pure number" and not {"stop", "forward"} <= given.keys():
            raise entry.problem("lacks 'stop' and 'forward'; say which cells are no thrust and full thrust ahead.")
        measured = _MEASURED in section and section[_MEASURED].flag()
        return replace(limited(column, given, dimension, entry), measured=measured)

    def column(self, entry: Entry, dimensions: tuple[str, ...]) -> ColumnValue:
        """A column or a formula whose unit has one of the dimensions."""
        section = entry.section((), _COLUMN_KEYS)
        if ("column" in section) == ("formula" in section):
            raise entry.problem("needs either 'column' or 'formula'; name a column, or write arithmetic of columns.")
        dimension = self._dimension(section, dimensions, entry)
        unit = section["unit"].text() if "unit" in section else si_unit(dimension)
        if "formula" in section:
            column: Entry | formula.Formula = formula.parse(section["formula"], self.names, self.constants)
        else:
            column = self._named(column_name(section["column"]))
        return ColumnValue(
            column,
            UNITS[dimension][unit],
            read_quantity(section["scale"], "pure number") if "scale" in section else 1.0,
            read_number(section["offset"], lambda part: read_quantity(part, dimension)) if "offset" in section else 0.0,
        )

    def _named(self, column: Entry) -> Entry:
        """The column itself, or the one that the short name stands for."""
        return self.names.get(column.value, column) if isinstance(column.value, str) else column

    def _dimension(self, section: dict[str, Entry], dimensions: tuple[str, ...], entry: Entry | None = None) -> str:
        """The dimension that the unit says; a formula has to say its own."""
        if "unit" in section:
            return unit_dimension(section["unit"], dimensions)
        if "formula" not in section and (self.from_bag or dimensions == ("pure number",)):
            return dimensions[0]
        place = entry or section.get("column") or section["formula"]
        raise place.problem(f"lacks 'unit'; add one of {listed(_units(dimensions))}.")


def limited(column: ColumnValue | MixedValue, given: Mapping[str, Entry], dimension: str, place: Entry) -> CommandValue:
    """The command whose stop, full ahead and full astern are given in that dimension; 0, 1 and -1 if none is."""
    if not given:
        return CommandValue(column, 0.0, 1.0, -1.0, place)
    limits = {name: read_quantity(part, dimension) for name, part in given.items()}
    stop, forward, reverse = limits.get("stop", 0.0), limits.get("forward", 1.0), limits.get("reverse")
    if forward == stop or (reverse is not None and (reverse - stop) * (forward - stop) >= 0):
        raise place.problem("needs 'stop' between 'reverse' and 'forward'; correct these three.")
    return CommandValue(column, stop, forward, reverse, place)


def column_name(entry: Entry) -> Entry:
    """The entry itself, if it is a header name or a column number counted from 1."""
    if isinstance(entry.value, int) and not isinstance(entry.value, bool):
        entry.whole_number(1, 100_000)
    else:
        entry.text()
    return entry


def unit_dimension(entry: Entry, dimensions: tuple[str, ...]) -> str:
    """Which of the dimensions the unit belongs to. Raises CocorosimError for another unit."""
    unit = entry.text()
    for dimension in dimensions:
        if unit in UNITS[dimension]:
            return dimension
    raise entry.problem(f"has {entry.found()}, which is no unit of this number; allowed: {listed(_units(dimensions))}.")


def _units(dimensions: tuple[str, ...]) -> list[str]:
    return [f"'{unit}'" for dimension in dimensions for unit in UNITS[dimension]]
