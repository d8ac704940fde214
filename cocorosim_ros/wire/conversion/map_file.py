"""Reads a map file; everything that is wrong with it is said in a sentence that names file, line and key."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import read_any_quantity, read_nanoseconds, read_quantity
from cocorosim_ros.scenario.reading.yaml_file import load_yaml
from cocorosim_ros.wire.bags.file_kinds import KINDS, told
from cocorosim_ros.wire.conversion.conversion_map import (
    BesideMap,
    ConversionMap,
    CsvLayout,
    RobotMap,
    TableMap,
    TimeMap,
)
from cocorosim_ros.wire.conversion.formats import FORMATS
from cocorosim_ros.wire.conversion.formats.format import Format, LogFormat
from cocorosim_ros.wire.conversion.formula import FUNCTIONS, NAMED
from cocorosim_ros.wire.conversion.run_wise import Number, read_number
from cocorosim_ros.wire.conversion.stream_entries import TOPICS, read_stream
from cocorosim_ros.wire.conversion.time_entries import nanoseconds_per, read_time
from cocorosim_ros.wire.conversion.value_entries import ValueReader, column_name

_OTHER_NAMES = {"xlsx": "excel", "xls": "excel", "ods": "spreadsheet", "h5": "hdf5", "hdf": "hdf5", "nc": "netcdf",
                "pkl": "pickle", "gz": "gzip", "bz2": "bzip2", "7z": "seven_zip", "feather": "arrow"}  # fmt: skip
"""What formats that are not read are called by others."""
_ROBOT_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


def load_map(path: Path) -> ConversionMap:
    """The map in a YAML file. Raises CocorosimError if it is unreadable, wrong, or converts nothing."""
    entry = load_yaml(path)
    section = entry.section(("name", "format", "tables"), ("description", "constants"))
    chosen = _format(section["format"])
    constants = _constants(section["constants"]) if "constants" in section else {}
    tables = section["tables"].items()
    if not tables:
        raise section["tables"].problem("is empty, so there is nothing to convert; add a table with its streams.")
    reader = _TableReader(FORMATS[chosen], constants)
    maps = tuple(reader.table(part) for part in tables)
    return ConversionMap(section["name"].text(), chosen, maps, path.read_text("utf-8"), entry.file)


def _format(entry: Entry) -> str:
    """The key of a format. Raises CocorosimError for another word, with the way out for files that are known."""
    word = str(entry.value).lower().lstrip(".")
    known = next((kind for kind in KINDS if kind.key == _OTHER_NAMES.get(word, word)), None)
    if known is None or known.key in FORMATS:
        return entry.choice(tuple(FORMATS))
    way_out = told(known, Path("FILE"))
    raise entry.problem(
        f"has {entry.found()}, which is not read: such a file {way_out}; allowed: {', '.join(FORMATS)}."
    )


class _TableReader:
    """Reads the tables of one map."""

    def __init__(self, chosen: Format, constants: Mapping[str, Number]) -> None:
        self._log = chosen if isinstance(chosen, LogFormat) else None
        self._ros = self._log is not None and self._log.ros
        self._constants = constants
        self._source = "topic" if self._log else "files"

    def table(self, entry: Entry) -> TableMap:
        """One entry of `tables`."""
        needed = (self._source, "robot", "streams") if self._log else (self._source, "time", "robot", "streams")
        free = ("time", "optional") if self._log else ("runs", "layout")
        section = entry.section(needed, (*free, "beside", "names", "backwards"))
        names = _names(section["names"]) if "names" in section else {}
        values = ValueReader(self._ros, names, self._constants)
        streams = section["streams"].mapping()
        if not streams:
            raise section["streams"].problem(
                f"is empty, so there is nothing to convert; add one of {', '.join(TOPICS)}."
            )
        source = section[self._source].text()
        optional, unless = _optional(section["optional"]) if "optional" in section else (False, frozenset())
        sort = self._log is not None
        if "backwards" in section:
            sort = section["backwards"].choice(("refuse", "sort")) == "sort"
        return TableMap(
            source,
            section["runs"].text() if "runs" in section else "*",
            _layout(section["layout"]) if "layout" in section else CsvLayout(),
            read_time(section["time"], ros=self._ros) if "time" in section else self._clock(entry),
            _robot(section["robot"], from_name="{robot}" in source),
            sort,
            tuple(read_stream(topic, part, values) for topic, part in streams.items()),
            entry,
            self._beside(section["beside"], source) if "beside" in section else {},
            optional,
            unless,
        )

    def _beside(self, entry: Entry, own: str) -> dict[str, BesideMap]:
        """Other topics or files than the table's own, by what their columns begin with."""
        found = {}
        for name, part in entry.mapping().items():
            section = part.section((self._source, "within"), ("time",))
            if not name.isidentifier():
                raise part.problem("is no name for what stands beside; use letters, digits and _.")
            source = section[self._source].text()
            lacking = [word for word in ("{run}", "{robot}") if word in source and word not in own]
            if lacking and self._log is None:
                raise section["files"].problem(
                    f"has {lacking[0]}, and the table's own 'files' ('{own}') has not, so it stands for nothing; write "
                    "it there too, or name one file here, which then stands beside all."
                )
            time = read_time(section["time"], ros=self._ros) if "time" in section else None
            found[name] = BesideMap(source, read_nanoseconds(section["within"]), time, part)
        return found

    def _clock(self, entry: Entry) -> TimeMap:
        """The time of a log's messages, if the map does not say it."""
        if self._log is None or self._log.clock is None:
            return TimeMap()
        column, unit = self._log.clock
        return TimeMap(columns=((replace(entry, key=f"{entry.key}.time", value=column), nanoseconds_per(unit)),))


def _constants(entry: Entry) -> dict[str, Number]:
    """Numbers of the map by name [SI]."""
    for name, part in entry.mapping().items():
        if not name.isidentifier() or name in FUNCTIONS or name in NAMED:
            raise part.problem("is no name of a constant; use letters, digits and _, and no name of a function.")
    return {name: read_number(part, _constant) for name, part in entry.mapping().items()}


def _constant(entry: Entry) -> float:
    bare = isinstance(entry.value, (int, float))
    return read_quantity(entry, "pure number") if bare else read_any_quantity(entry).value


def _names(entry: Entry) -> dict[str, Entry]:
    """Short names of columns."""
    for name, part in entry.mapping().items():
        if not name.isidentifier() or name in NAMED:
            raise part.problem("is no short name of a column; use letters, digits and _.")
    return {name: column_name(part) for name, part in entry.mapping().items()}


def _optional(entry: Entry) -> tuple[bool, frozenset[str]]:
    """Whether a log may lack the topic, and the topics of the contract in whose place alone the table stands."""
    if not isinstance(entry.value, dict):
        return entry.flag(), frozenset()
    given = entry.section(("unless",))["unless"]
    named = given.items() if isinstance(given.value, list) else [given]
    return True, frozenset(each.choice(TOPICS) for each in named)


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
    section = entry.section((), ("separator", "comment", "header", "decimal", "skip", "missing", "encoding"))
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
        section["encoding"].choice(("utf-8", "latin-1")) if "encoding" in section else plain.encoding,
    )


def _words(entry: Entry) -> Sequence[str]:
    return [str(part.value).lower() for part in entry.items()]
