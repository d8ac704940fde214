"""The numbers of a map file: columns with units, fixed values, thruster commands."""

from __future__ import annotations

from dataclasses import dataclass, replace

from cocorosim_ros.scenario.reading.entry import Entry, listed
from cocorosim_ros.scenario.reading.quantity import UNITS, read_quantity, si_unit
from cocorosim_ros.wire.conversion.conversion_map import ColumnValue, CommandValue, FixedValue, TravelValue, Value

_COMMAND_DIMENSIONS = ("pure number", "time", "voltage", "force")
_COLUMN_KEYS = ("unit", "scale", "offset")


@dataclass(frozen=True)
class ValueReader:
    """Reads the numbers of streams; in bags a number without a unit is in SI, as REP 103 asks."""

    from_bag: bool

    def value(self, entry: Entry, dimension: str) -> Value:
        """A column or a fixed number of that dimension."""
        section = entry.section((), ("column", "fixed", *_COLUMN_KEYS))
        if "fixed" in section:
            entry.section(("fixed",))
            return FixedValue(read_quantity(section["fixed"], dimension))
        return self.column(entry, (dimension,))

    def heading(self, entry: Entry) -> Value:
        """As `value`, or {travel: true}: the direction of travel."""
        if "travel" not in entry.mapping():
            return self.value(entry, "angle")
        if not entry.section(("travel",))["travel"].flag():
            raise entry.problem("has 'travel: false'; name a column, a fixed angle, or 'travel: true'.")
        return TravelValue()

    def command(self, entry: Entry) -> CommandValue:
        """A thruster's column with the cells that stand for stop, full ahead and full astern."""
        limits = ("stop", "forward", "reverse")
        section = entry.section(("column",), (*_COLUMN_KEYS, *limits))
        bare = {name: part for name, part in section.items() if name not in limits}
        column = self.column(replace(entry, value=bare), _COMMAND_DIMENSIONS)
        dimension = self._dimension(section, _COMMAND_DIMENSIONS)
        given = {name: read_quantity(section[name], dimension) for name in limits if name in section}
        if dimension != "pure number" and not {"stop", "forward"} <= given.keys():
            raise entry.problem("lacks 'stop' and 'forward'; say which cells are no thrust and full thrust ahead.")
        if not given:
            return CommandValue(column, 0.0, 1.0, -1.0, entry)
        stop, forward, reverse = given.get("stop", 0.0), given.get("forward", 1.0), given.get("reverse")
        if forward == stop or (reverse is not None and (reverse - stop) * (forward - stop) >= 0):
            raise entry.problem("needs 'stop' between 'reverse' and 'forward'; correct these three.")
        return CommandValue(column, stop, forward, reverse, entry)

    def column(self, entry: Entry, dimensions: tuple[str, ...]) -> ColumnValue:
        """A column whose unit has one of the dimensions."""
        section = entry.section(("column",), _COLUMN_KEYS)
        dimension = self._dimension(section, dimensions, entry)
        unit = section["unit"].text() if "unit" in section else si_unit(dimension)
        return ColumnValue(
            column_name(section["column"]),
            UNITS[dimension][unit],
            read_quantity(section["scale"], "pure number") if "scale" in section else 1.0,
            read_quantity(section["offset"], dimension) if "offset" in section else 0.0,
        )

    def _dimension(self, section: dict[str, Entry], dimensions: tuple[str, ...], entry: Entry | None = None) -> str:
        """The dimension that the unit says."""
        if "unit" in section:
            return unit_dimension(section["unit"], dimensions)
        if self.from_bag or dimensions == ("pure number",):
            return dimensions[0]
        raise (entry or section["column"]).problem(f"lacks 'unit'; add one of {listed(_units(dimensions))}.")


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
