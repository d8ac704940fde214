"""The time of rows, as a map file says it."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import UNITS, read_nanoseconds, read_quantity
from cocorosim_ros.wire.conversion.clock import FIELDS, Clock, comes_back, fields_of
from cocorosim_ros.wire.conversion.conversion_map import TimeMap
from cocorosim_ros.wire.conversion.value_entries import column_name, unit_dimension

_ZONE = "; write the cells' own characters in its place, and say with 'ahead' how far the clock is ahead of UTC"
_NOT_READ = {
    "%f": "; leave it out with the point before it: what stands behind the point is read without it",
    "%z": _ZONE,
    "%Z": _ZONE,
    **dict.fromkeys(("%c", "%x", "%X"), ", which is written otherwise on other machines; write its fields one by one"),
}
"""Fields that `strptime` knows, and why a map may not have them."""


def read_time(entry: Entry, *, ros: bool) -> TimeMap:
    """The `time` of a table; messages of ROS have stamps and are recorded, other rows have columns or a rate."""
    ways = ("stamp", "log_time") if ros else ("column", "columns", "row_rate", "counter", "clock")
    extra = () if ros else ("unit", "rate", "form", "fraction", "ahead")
    section = entry.section((), (*ways, *extra, "start"))
    chosen = [way for way in ways if way in section]
    if len(chosen) != 1:
        raise entry.problem(f"must say when in exactly one way; allowed: {', '.join(ways)}.")
    start = read_nanoseconds(section["start"]) if "start" in section else 0
    return replace(_when(chosen[0], entry, section), start_ns=start)


def nanoseconds_per(unit: str) -> Fraction:
    """The nanoseconds of one unit of time."""
    return Fraction(UNITS["time"][unit]) * 1_000_000_000


def _when(way: str, entry: Entry, section: dict[str, Entry]) -> TimeMap:
    if way in ("column", "columns"):
        entry.section((way,), ("start",) if way == "columns" else ("unit", "start"))
        parts = [entry] if way == "column" else section["columns"].items()
        return TimeMap(columns=tuple(_time_column(part) for part in parts))
    if way == "row_rate":
        entry.section(("row_rate",), ("start",))
        return TimeMap(step_ns=_step(section["row_rate"]))
    if way == "counter":
        entry.section(("counter", "rate"), ("start",))
        return TimeMap(counter=column_name(section["counter"]), step_ns=_step(section["rate"]))
    if way == "clock":
        return TimeMap(clock=_clock(entry))
    if way == "stamp":
        section["stamp"].text()
        return TimeMap(stamp=section["stamp"])
    if not section["log_time"].flag():
        raise section["log_time"].problem("is false; leave 'time' out to use the headers' stamps.")
    return TimeMap(log_time=True)


def _time_column(entry: Entry) -> tuple[Entry, Fraction]:
    section = entry.section(("column", "unit"), ("start",))
    unit_dimension(section["unit"], ("time",))
    return column_name(section["column"]), nanoseconds_per(section["unit"].value)


def _clock(entry: Entry) -> Clock:
    section = entry.section(("clock", "form"), ("fraction", "ahead", "start"))
    counts = "fraction" in section and section["fraction"].choice(("decimal", "ns")) == "ns"
    ahead = read_nanoseconds(section["ahead"], "any") if "ahead" in section else 0
    return Clock(column_name(section["clock"]), _form(section["form"]), counts, ahead)


def _form(entry: Entry) -> str:
    """A form that tells a date, and nothing that would be read and lost."""
    form = entry.text()
    for field in fields_of(form):
        if field in _NOT_READ:
            raise entry.problem(f"has '{field}'{_NOT_READ[field]}.")
        if field[1:] not in FIELDS:
            allowed = ", ".join(f"%{letter}" for letter in sorted(FIELDS, key=str.lower))
            raise entry.problem(f"has '{field}', no field of a date or time of day; allowed: {allowed}.")
    if not comes_back(form):
        raise entry.problem(
            f"has {entry.found()}, from which year, month, day and time of day cannot be read again; write each field "
            "once as the cells have it, as in '%Y-%m-%d %H:%M:%S' (with %I also %p)."
        )
    return form


def _step(entry: Entry) -> Fraction:
    return 1_000_000_000 / Fraction(repr(read_quantity(entry, "frequency", "positive")))
