"""What a map file says: which files or topics hold which numbers, in which units and axes, and when."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from cocorosim_ros.scenario.reading.entry import Entry


@dataclass(frozen=True)
class ColumnValue:
    """A number of every row: `scale` times the cell in its unit, plus `offset` [SI]."""

    column: Entry  # header name or number of a CSV column, or path of a field of a message
    unit_factor: str  # decimal text: the unit in SI
    scale: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True)
class FixedValue:
    """The same number [SI] in every row."""

    value: float


@dataclass(frozen=True)
class TravelValue:
    """A heading that is the direction of travel."""


@dataclass(frozen=True)
class CommandValue:
    """A thruster command: the fraction of the maximum that lies between `stop` and `forward` or `reverse` [SI].

    Without `reverse` the thruster does not turn backwards, and a cell on that side of `stop` is an error.
    """

    column: ColumnValue
    stop: float
    forward: float
    reverse: float | None
    place: Entry


Value = ColumnValue | FixedValue | TravelValue | CommandValue


@dataclass(frozen=True)
class StreamMap:
    """One topic of the contract: its numbers by name, and the axes that they are given in."""

    topic: str
    values: Mapping[str, Value]
    north_east_down: bool
    place: Entry


@dataclass(frozen=True)
class TimeMap:
    """When a row was measured: exactly one of the first three, plus `start_ns`."""

    columns: tuple[tuple[Entry, Fraction], ...] = ()  # with nanoseconds per unit; their sum is the time
    counter: Entry | None = None  # a column that counts steps, together with `step_ns`
    step_ns: Fraction | None = None  # without `counter`: the distance of rows
    stamp: Entry | None = None  # path of a Time in a message
    log_time: bool = False  # when the message was recorded
    start_ns: int = 0


@dataclass(frozen=True)
class RobotMap:
    """Whose rows these are: one name, or a prefix before what stands in a column or in the file's name."""

    name: str
    column: Entry | None = None
    digits: int = 0


@dataclass(frozen=True)
class CsvLayout:
    """How a CSV file is written."""

    separator: str = ","  # " " stands for any white space
    comment: str = ""
    header: bool = True
    decimal: str = "."
    skip: int = 0  # lines before the header
    missing: tuple[str, ...] = ("", "nan", "na", "null", "none", "-")


@dataclass(frozen=True)
class TableMap:
    """One kind of file, or one topic of a bag, and the streams that are made from it."""

    source: str  # pattern of file names, or a topic
    runs: str  # which runs it is for: a pattern with *
    layout: CsvLayout
    time: TimeMap
    robot: RobotMap
    sort: bool  # rows whose time runs backwards are sorted instead of refused
    streams: tuple[StreamMap, ...]
    place: Entry


@dataclass(frozen=True)
class ConversionMap:
    """A whole map file."""

    name: str
    from_bag: bool
    tables: tuple[TableMap, ...]
    text: str
    file: str
