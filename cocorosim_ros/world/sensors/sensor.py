"""What a sensor is: its topic, the numbers it shows, and small compiled functions of the true state."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor, Sensors

Hook = Callable[..., Any]
PER_CONE = -1
"""Width of a field that has one number for each blue-light sensor of a robot."""


@dataclass(frozen=True)
class Field:
    """One array of readings.Readings, with leading axes (runs, robots).

    width: numbers for each robot, on a last axis; None for a single number, without such an axis. channels: the names
    that scenarios corrupt it by, and the columns of each; None for all of a field without a last axis.
    """

    name: str
    unit: str
    width: int | None = None
    angle: bool = False  # in (-pi, pi]
    channels: Mapping[str, slice | None] = field(default_factory=dict)


class MostError(NamedTuple):
    """The most by which such an instrument can be wrong by a law, whatever the law; chosen, not measured.

    The greatest holds: `amount` [unit of the reading], `share` [1] of how far its readings spread, and `hulls` [lengths
    of the vehicle's hull].
    """

    amount: float
    share: float = 0.0
    hulls: float = 0.0


@dataclass(frozen=True)
class Kind:
    """One number of a reading, as a diagnosis predicts it and compares it with recordings.

    foresee(when, row, rates, water) returns what an ideal sensor shows; `when` and the others as in filter.reading.
    by_weight: whether it goes by the weight of the water above, so that foresee and sensitivity take the pressure per
    metre of depth [Pa/m] behind the others.
    sensitivity(after, row, slope, rates, seen) adds the derivative by the state to `seen`, which is zero: of a
    horizontal reading in the columns HX... of terms.blocks, of an upright one in VZ... `after` [s] is how long after
    `row` the reading is, `slope` the derivative of what is shown by the truth (1 without errors), `rates` the flat
    derivatives of the rates of the block by the block (terms.blocks), row by row.
    place: field of Readings and column there; None where a simulation shows the truth.
    error_follows: products of regressors to one of which an error outside ERRORS may be proportional, written as in
    laws.law. What an error of ERRORS or a late stream does already is left out: a late stream is off by its own rate.
    least_motion and large_error are chosen, not measured.
    """

    name: str
    column: str  # its name among the columns of the stream
    unit: str
    foresee: Hook
    sensitivity: Hook
    place: tuple[str, int | None] | None = None
    upright: bool = False
    angle: bool = False
    of_water: bool = False  # depends on the velocity through the water
    by_weight: bool = False
    noise: str = ""  # readings that are equally good share the number of their noise, under this name; '': alone
    noise_words: str = ""  # of that number, in the report
    words: str = field(kw_only=True)  # for the reading, as a mechanic says them
    least_noise: float = field(kw_only=True)  # [unit] what the filter's steps err by, however exact a reading is
    most_error: MostError = field(kw_only=True)  # beyond it a difference is no error of this instrument
    least_motion: float | None = None  # [unit] smaller motion is none, however exact; None: motion is not told by it
    shows: tuple[str, ...] = ()  # regressors that follow from this reading alone
    large_error: float = field(kw_only=True)  # [unit] in a bad case
    error_follows: tuple[str, ...] = ()


@dataclass(frozen=True)
class Recorded:
    """How a diagnosis reads the topic: so many numbers stand behind a message's header, `columns` picks its own.

    columns: from (n, numbers) to (n, kinds), NaN where the message says that nothing was measured.
    drawn: the kind that the report draws. late_with: the regressor in proportion to which a late stream is off.
    orientation: from (n, numbers) to (n, 4) quaternions x y z w of body axes in the world, NaN where not measured; None
    for a topic without any.
    """

    numbers: int
    columns: Callable[[Floats], Floats]
    drawn: str = ""
    late_with: str = "t"
    orientation: Callable[[Floats], Floats] | None = None


@dataclass(frozen=True)
class Layout:
    """Which fields of the message the numbers fill, in their order, and what else the message says."""

    places: tuple[str, ...]
    content: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Column:
    """One number of a message as tables of recordings show it."""

    name: str
    place: str  # field of the message, as in Layout
    unit: str  # SI, "1" for none


@dataclass(frozen=True)
class Elements:
    """How tables show a message that is a list of named elements.

    read(message) returns its numbers by column; unit: of all of them, "1" for none. units: of columns that end in a dot
    and this word, where they differ.
    """

    read: Callable[[Any], dict[str, float]]
    unit: str
    units: Mapping[str, str] = field(default_factory=dict)

    def unit_of(self, column: str) -> str:
        """The unit of a column."""
        return self.units.get(column.rpartition(".")[2], self.unit)


@dataclass(frozen=True)
class Sensor:
    """One sensor of a robot, which has a topic of its own.

    fields: of Readings, in the order in which their numbers fill the message. layout: of the message, from the robot's
    blue-light sensors. measure(sight, *fields): for one robot (sensors.sight); the result is the reading where there is
    one field without a last axis, else each field (numbers,) is an argument and is written into.
    columns, elements: what tables of recordings show of the message; without either, the places of the layout.
    kinds: what a diagnosis knows of it; recorded: how it reads it.
    """

    topic: str
    message: str  # its type
    meaning: str
    layout: Callable[[tuple[BlueLightSensor, ...]], Layout]
    fields: tuple[Field, ...] = ()
    measure: Hook | None = None
    publisher: str = "robot"
    optional: bool = True
    asked: bool = False  # a robot has it where its controller asks for it; else where its platform says so
    for_all: bool = False  # measured in robots, too, that do not publish it
    columns: tuple[Column, ...] = ()
    elements: Elements | None = None
    kinds: tuple[Kind, ...] = ()
    recorded: Recorded | None = None

    @property
    def shown(self) -> tuple[Column, ...] | Elements:
        """What tables of recordings show of its messages."""
        if self.elements is not None:
            return self.elements
        if self.columns or not self.fields:
            return self.columns
        units = [each.unit for each in self.fields for _ in range(each.width or 1)]
        places = zip(self.layout(()).places, units, strict=True)
        return tuple(Column(place, place, unit) for place, unit in places)

    def is_on(self, sensors: Sensors, needs: tuple[str, ...]) -> bool:
        """Whether a robot with these sensors and a controller that asks for `needs` publishes it."""
        return self.topic in needs if self.asked else sensors.has(self.topic)


def fixed(*places: str, **content: Any) -> Callable[[tuple[BlueLightSensor, ...]], Layout]:
    """The layout of a message that is the same in every robot."""
    layout = Layout(places, content)
    return lambda _: layout
