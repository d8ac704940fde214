"""Reads a map file; everything that is wrong with it is said in a sentence that names file, line and key."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import UNITS, read_nanoseconds, read_quantity
from cocorosim_ros.scenario.reading.yaml_file import load_yaml
from cocorosim_ros.wire.conversion.conversion_map import (
    ConversionMap,
    CsvLayout,
    RobotMap,
    StreamMap,
    TableMap,
    TimeMap,
)
from cocorosim_ros.wire.conversion.streams import NUMBERS, check_stream
from cocorosim_ros.wire.conversion.value_entries import ValueReader, column_name, unit_dimension

AXES = ("enu_flu", "ned_frd")
COMMAND = "thruster_command"
_ROBOT_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_ACTUATOR_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def load_map(path: Path) -> ConversionMap:
    """The map in a YAML file. Raises CocorosimError if it is unreadable, wrong, or converts nothing."""
    entry = load_yaml(path)
    section = entry.section(("name", "format", "tables"), ("description",))
    from_bag = section["format"].choice(("csv", "bag")) == "bag"
    tables = section["tables"].items()
    if not tables:
        raise section["tables"].problem("is empty, so there is nothing to convert; add a table with its streams.")
    reader = _TableReader(from_bag)
    maps = tuple(reader.table(part) for part in tables)
    return ConversionMap(section["name"].text(), from_bag, maps, path.read_text("utf-8"), entry.file)


class _TableReader:
    """Reads the tables of one map."""

    def __init__(self, from_bag: bool) -> None:
        self._from_bag = from_bag
        self._values = ValueReader(from_bag)
        self._source = "topic" if from_bag else "files"

    def table(self, entry: Entry) -> TableMap:
        """One entry of `tables`."""
        needed = (self._source, "robot", "streams") if self._from_bag else (self._source, "time", "robot", "streams")
        free = ("time", "backwards") if self._from_bag else ("runs", "layout", "backwards")
        section = entry.section(needed, free)
        streams = section["streams"].mapping()
        if not streams:
            raise section["streams"].problem(f"is empty, so there is nothing to convert; add one of {_topics()}.")
        source = section[self._source].text()
        return TableMap(
            source,
            section["runs"].text() if "runs" in section else "*",
            _layout(section["layout"]) if "layout" in section else CsvLayout(),
            self._time(section["time"]) if "time" in section else TimeMap(),
            _robot(section["robot"], from_name="{robot}" in source),
            section["backwards"].choice(("refuse", "sort")) == "sort" if "backwards" in section else self._from_bag,
            tuple(self._stream(topic, part) for topic, part in streams.items()),
            entry,
        )

    def _stream(self, topic: str, entry: Entry) -> StreamMap:
        if topic not in NUMBERS and topic != COMMAND:
            raise entry.problem(f"is no topic that can be converted; allowed: {_topics()}.")
        given = dict(entry.mapping())
        axes = given.pop("axes", None)
        down = axes is not None and axes.choice(AXES) == "ned_frd"
        inner = replace(entry, value=given)
        if topic == COMMAND:
            _check_actuators(inner)
            return StreamMap(topic, {name: self._values.command(part) for name, part in given.items()}, down, entry)
        section = inner.section((), NUMBERS[topic])
        values = {
            name: self._values.heading(part) if name == "yaw" else self._values.value(part, NUMBERS[topic][name])
            for name, part in section.items()
        }
        check_stream(topic, values, entry)
        return StreamMap(topic, values, down, entry)

    def _time(self, entry: Entry) -> TimeMap:
        ways = ("stamp", "log_time") if self._from_bag else ("column", "columns", "row_rate", "counter")
        extra = () if self._from_bag else ("unit", "rate")
        section = entry.section((), (*ways, *extra, "start"))
        chosen = [way for way in ways if way in section]
        if len(chosen) != 1:
            raise entry.problem(f"must say when in exactly one way; allowed: {', '.join(ways)}.")
        start = read_nanoseconds(section["start"]) if "start" in section else 0
        return replace(_when(chosen[0], entry, section), start_ns=start)


def _when(way: str, entry: Entry, section: dict[str, Entry]) -> TimeMap:
    if way == "column":
        entry.section(("column", "unit"), ("start",))
        return TimeMap(columns=(_time_column(entry),))
    if way == "columns":
        entry.section(("columns",), ("start",))
        return TimeMap(columns=tuple(_time_column(part) for part in section["columns"].items()))
    if way == "row_rate":
        entry.section(("row_rate",), ("start",))
        return TimeMap(step_ns=_step(section["row_rate"]))
    if way == "counter":
        entry.section(("counter", "rate"), ("start",))
        return TimeMap(counter=column_name(section["counter"]), step_ns=_step(section["rate"]))
    if way == "stamp":
        section["stamp"].text()
        return TimeMap(stamp=section["stamp"])
    if not section["log_time"].flag():
        raise section["log_time"].problem("is false; leave 'time' out to use the headers' stamps.")
    return TimeMap(log_time=True)


def _time_column(entry: Entry) -> tuple[Entry, Fraction]:
    section = entry.section(("column", "unit"), ("start",))
    unit_dimension(section["unit"], ("time",))
    return column_name(section["column"]), Fraction(UNITS["time"][section["unit"].value]) * 1_000_000_000


def _step(entry: Entry) -> Fraction:
    return 1_000_000_000 / Fraction(repr(read_quantity(entry, "frequency", "positive")))


def _robot(entry: Entry, *, from_name: bool) -> RobotMap:
    if isinstance(entry.value, dict):
        section = entry.section(("prefix",), ("column", "digits"))
        name = section["prefix"].text()
        column = column_name(section["column"]) if "column" in section else None
        robot = RobotMap(name, column, section["digits"].whole_number(1, 9) if "digits" in section else 0)
        if column is None and not from_name:
            raise entry.problem("has a prefix but no 'column' after it; add one, or write {robot} into 'files'.")
    else:
        robot = RobotMap(entry.text())
    if not _ROBOT_NAME.fullmatch(robot.name):
        raise entry.problem(f"has '{robot.name}', no name for ROS; use letters, digits and _, a letter first.")
    return robot


def _layout(entry: Entry) -> CsvLayout:
    section = entry.section((), ("separator", "comment", "header", "decimal", "skip", "missing"))
    plain = CsvLayout()
    separator = str(section["separator"].value) if "separator" in section else plain.separator
    if separator not in (",", ";", "\t", "|", "space"):
        raise section["separator"].problem('must be ",", ";", "|", "\\t" or space.')
    return CsvLayout(
        " " if separator == "space" else separator,
        section["comment"].text() if "comment" in section else plain.comment,
        section["header"].flag() if "header" in section else plain.header,
        section["decimal"].choice((".", ",")) if "decimal" in section else plain.decimal,
        section["skip"].whole_number(0, 10_000) if "skip" in section else plain.skip,
        (*plain.missing, *_words(section["missing"])) if "missing" in section else plain.missing,
    )


def _words(entry: Entry) -> Sequence[str]:
    return [str(part.value).lower() for part in entry.items()]


def _check_actuators(entry: Entry) -> None:
    if not entry.mapping():
        raise entry.problem("names no actuator; write 'left: {column: ..., unit: ...}' lines under it.")
    for name, part in entry.mapping().items():
        if not _ACTUATOR_NAME.fullmatch(name):
            raise part.problem("is no name of an actuator; use letters, digits and _.")


def _topics() -> str:
    return ", ".join((*NUMBERS, COMMAND))
