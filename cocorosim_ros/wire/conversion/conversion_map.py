"""What a map file says: which files or topics hold which numbers, in which units and axes, and when."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.clock import Clock
from cocorosim_ros.wire.conversion.formula import Formula
from cocorosim_ros.wire.conversion.run_wise import Number, number_of


@dataclass(frozen=True)
class ColumnValue:
    """A number of every row: `scale` times the cell in its unit, plus `offset` [SI]."""

    column: Entry | Formula  # header name, number of a column, path of a field of a message, or arithmetic of them
    unit_factor: str  # decimal text: the unit in SI
    scale: float = 1.0
    offset: Number = 0.0

    def for_recording(self, recording: str) -> ColumnValue:
        """Settle what depends on the recording."""
        column = self.column.for_recording(recording) if isinstance(self.column, Formula) else self.column
        return replace(self, column=column, offset=number_of(self.offset, recording))


@dataclass(frozen=True)
class FixedValue:
    """The same number [SI] in every row."""

    value: Number

    def for_recording(self, recording: str) -> FixedValue:
        """The number of that recording."""
        return FixedValue(number_of(self.value, recording))


@dataclass(frozen=True)
class MixedValue:
    """The sum of numbers, each times a weight."""

    parts: tuple[tuple[float, ColumnValue | FixedValue], ...]

    def for_recording(self, recording: str) -> MixedValue:
        """Settle what depends on the recording."""
        return MixedValue(tuple((weight, part.for_recording(recording)) for weight, part in self.parts))


@dataclass(frozen=True)
class TravelValue:
    """A heading that is the direction of travel."""

    def for_recording(self, recording: str) -> TravelValue:
        """Settle what depends on the recording: nothing."""
        return self


@dataclass(frozen=True)
class UnknownValue:
    """A heading that was not recorded."""

    def for_recording(self, recording: str) -> UnknownValue:
        """Settle what depends on the recording: nothing."""
        return self


@dataclass(frozen=True)
class CommandValue:
    """A thruster command: the fraction of the maximum that lies between `stop` and `forward` or `reverse` [SI].

    Without `reverse` the thruster does not turn backwards, and a cell on that side of `stop` is an error.
    measured: the column holds what the actuator did, not what it was told.
    """

    column: ColumnValue | MixedValue
    stop: float
    forward: float
    reverse: float | None
    place: Entry
    measured: bool = False

    def for_recording(self, recording: str) -> CommandValue:
        """Settle what depends on the recording."""
        return replace(self, column=self.column.for_recording(recording))


Value = ColumnValue | FixedValue | MixedValue | TravelValue | UnknownValue | CommandValue


@dataclass(frozen=True)
class StreamMap:
    """One topic of the contract: its numbers by name, and the axes that they are given in."""

    topic: str
    values: Mapping[str, Value]
    north_east_down: bool
    place: Entry

    def for_recording(self, recording: str) -> StreamMap:
        """The stream with the numbers of that recording."""
        values = {name: value.for_recording(recording) for name, value in self.values.items()}
        return replace(self, values=values)


@dataclass(frozen=True)
class TimeMap:
    """When a row was measured: exactly one of the ways, plus `start_ns`."""

    columns: tuple[tuple[Entry, Fraction], ...] = ()  # with nanoseconds per unit; their sum is the time
    counter: Entry | None = None  # a column that counts steps, together with `step_ns`
    step_ns: Fraction | None = None  # without `counter`: the distance of rows
    stamp: Entry | None = None  # path of a Time in a message
    log_time: bool = False  # when the message was recorded
    clock: Clock | None = None  # a column of dates and times of day
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
    encoding: str = "utf-8"


@dataclass(frozen=True)
class BesideMap:
    """Another topic or file, whose message or row nearest in time stands beside each of a table's own."""

    source: str  # a topic, or a pattern of file names
    within_ns: int  # what is further away in time counts as missing
    time: TimeMap | None  # None: as the table's own
    place: Entry


@dataclass(frozen=True)
class TableMap:
    """One kind of file, or one topic of a log, and the streams that are made from it."""

    source: str  # pattern of file names, or a topic
    runs: str  # which runs it is for: a pattern with *
    layout: CsvLayout
    time: TimeMap
    robot: RobotMap
    sort: bool  # rows whose time runs backwards are sorted instead of refused
    streams: tuple[StreamMap, ...]
    place: Entry
    beside: Mapping[str, BesideMap] = field(default_factory=dict)  # by what their columns begin with
    optional: bool = False  # left out of a log that lacks the topic
    unless: frozenset[str] = frozenset()  # left out where a table before it gives one of these topics of the robot

    def for_recording(self, recording: str) -> TableMap:
        """The table with the numbers of that recording."""
        return replace(self, streams=tuple(stream.for_recording(recording) for stream in self.streams))


@dataclass(frozen=True)
class ConversionMap:
    """A whole map file."""

    name: str
    format: str  # a key of FORMATS
    tables: tuple[TableMap, ...]
    text: str
    file: str
