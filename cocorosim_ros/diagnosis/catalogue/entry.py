"""Entries of the catalogue: an effect by the contract's identifier, with amplitudes, shapes, priors and grids."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

from cocorosim_ros.diagnosis.catalogue.law_words import stream_words
from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.sensors.sensor_error import OfEveryStream, SensorError
from cocorosim_ros.world.terms.effect import Description, Number, joined_equation
from cocorosim_ros.world.terms.search import Basis, Given, Grid, Limits, Scene, Search, Spacing, Standing, Strength

SENSOR_CHANNELS = ("clock", *(topic for topic, sensor in SENSORS.items() if sensor.kinds))
"""Channels of entries that act on readings; all other channels are equations of motion."""


@dataclass(frozen=True)
class Amplitude(Limits):
    """A number in which an effect is linear near `neutral`, its value where the effect is absent.

    `large` is its size in a bad case. A fit counts it in q = (number - neutral) / large; its prior is a normal
    distribution around neutral with standard deviation `large`. A `factor` is looked for as a difference alone, of what
    the model has of the number: neutral is then 1, and q the logarithm over `large`. part: of the entry's equation.
    """

    column: str
    name: str
    unit: str
    large: float
    neutral: float = 0.0
    factor: bool = False
    part: str = ""


@dataclass(frozen=True)
class Shape(Spacing):
    """A number that changes the form of an effect: its place, moment, period, ...

    While the amplitudes are neutral it changes nothing, so that it has no slope there: it is first looked for on a
    grid. A fit counts it in q from a point of that grid, in spacings of the grid or as a logarithm.
    """

    column: str
    name: str
    unit: str
    grid: Callable[[Scene], list[float]]


@dataclass(frozen=True)
class Entry(Standing):
    """One effect, or a law outside the catalogue, with the columns of its numbers.

    fixed: numbers of the simulator's effect that are not fitted, by column, as functions of the scene.
    """

    id: str
    name: str
    equation: str  # in plain text, without the parts of amplitudes
    channel: str  # the contract's equation: surge, sway, heave, yaw, compass, pressure, imu, pose, clock
    amplitudes: tuple[Amplitude, ...]
    shapes: tuple[Shape, ...] = ()
    fixed: Mapping[str, Callable[[Scene], float]] = field(default_factory=dict)
    manoeuvre: str = ""  # a name in catalogue.manoeuvres
    needs_neighbours: bool = False
    needs: tuple[str, ...] = ()  # what a vehicle must have, names of fitting.vehicle_needs
    law: str | None = None  # for laws outside the catalogue: the simulator's effect that acts for the law
    opposite: str = ""  # its name where its first amplitude is negative, "" where the name holds for both signs
    form: Law | None = None  # for laws outside the catalogue: equation or reading, and product of regressors

    def name_with(self, values: Mapping[str, float]) -> str:
        """The name in words that suit the sign of the first amplitude; values: numbers that were found, by column."""
        return self.opposite if self.opposite and values.get(self.amplitudes[0].column, 0.0) < 0.0 else self.name

    @property
    def whole_equation(self) -> str:
        """The equation with the parts of all amplitudes."""
        return joined_equation(self.equation, [each.part for each in self.amplitudes])

    def shown_equation(self, estimates: Mapping[str, Estimate]) -> str:
        """The equation with the parts of those amplitudes that were shown to do something; of all told where none was.

        Whole where none of them is told.
        """
        doubts = self.doubts(estimates)
        shown = [each.part for each in self.amplitudes if doubts.get(each.name) is False]
        told = shown or [each.part for each in self.amplitudes if each.name in doubts]
        return joined_equation(self.equation, told) if told else self.whole_equation

    def doubts(self, estimates: Mapping[str, Estimate]) -> dict[str, bool]:
        """Tell of each amplitude that was estimated, by name, whether its 95 % interval holds the neutral value."""
        return {
            each.name: estimates[each.name].holds(each.neutral) for each in self.amplitudes if each.name in estimates
        }

    def may_be_nothing(self, estimates: Mapping[str, Estimate]) -> bool:
        """Tell whether the 95 % interval of each amplitude that was estimated holds its neutral value."""
        doubts = self.doubts(estimates).values()
        return bool(doubts) and all(doubts)


def entry_of(identifier: str, effect: Description, search: Search) -> Entry:
    """Make the entry of an effect from what its own file in `world` says; columns are IDENTIFIER.PARAMETER."""
    found = [(f"{identifier}.{number.name}", number, number.search) for number in effect.numbers]
    standing = _fields_of(Standing, search)
    if search.basis is not None:
        standing["basis"] = _by_column(identifier, search.basis)
    return Entry(
        identifier,
        effect.summary,
        effect.equation,
        search.channel,
        tuple(_amplitude(column, number, how) for column, number, how in found if isinstance(how, Strength)),
        tuple(_shape(column, number, how) for column, number, how in found if isinstance(how, Grid)),
        fixed={column: how.value for column, _, how in found if isinstance(how, Given)},
        manoeuvre=search.manoeuvre,
        needs_neighbours=effect.neighbours,
        needs=effect.needs,
        opposite=effect.opposite,
        **standing,
    )


def entries_of_error(identifier: str) -> list[Entry]:
    """Make the entries of an error of sensors: one, or one for each stream where each may have the error by itself."""
    error = ERRORS[identifier]
    if error.streams is not None:
        return [_of_stream(identifier, error, error.streams, number) for number in error.numbers]
    if error.search is None:
        return []
    entry = entry_of(identifier, error, error.search)
    beside = [each for name in error.beside for each in entry_of(name, ERRORS[name], error.search).amplitudes]
    return [replace(entry, amplitudes=(*entry.amplitudes, *beside))]


def _of_stream(identifier: str, error: SensorError, streams: OfEveryStream, number: Number) -> Entry:
    """Make the entry of an error that each stream may have by itself, such as a latency, for one stream.

    number: the error's number for that stream, which platform files call by the topic, such as `compass` [s].
    """
    words = streams.summary(stream_words(number.name))
    one = replace(error, summary=words, parameters=(number,))
    entry = entry_of(identifier, one, streams.search(number.name))
    return replace(entry, amplitudes=tuple(replace(each, name=streams.number) for each in entry.amplitudes))


def _amplitude(column: str, number: Number, how: Strength) -> Amplitude:
    """Make an amplitude of a number of an effect; how: its large value and limits."""
    limits = _fields_of(Limits, how)
    return Amplitude(column, number.name, number.unit, how.large, neutral=number.neutral, part=number.part, **limits)


def _shape(column: str, number: Number, how: Grid) -> Shape:
    """Make a shape of a number of an effect; how: its grid and spacing."""
    return Shape(column, number.name, number.unit, how.points, **_fields_of(Spacing, how))


def _fields_of(kind: type[Limits | Spacing | Standing], source: Limits | Spacing | Standing) -> dict[str, Any]:
    """Values in `source` of the fields that `kind` declares, by name."""
    return {each.name: getattr(source, each.name) for each in fields(kind)}


def _by_column(identifier: str, basis: Basis) -> Basis:
    """Make a basis that takes shapes by column from an effect's basis, which takes them by name.

    A basis writes the slope at some shapes as a weighted sum of slopes at other shapes.
    """

    def by_column(values: Mapping[str, float]) -> list[tuple[dict[str, float], float]]:
        named = basis({column.removeprefix(f"{identifier}."): value for column, value in values.items()})
        return [({f"{identifier}.{name}": value for name, value in at.items()}, weight) for at, weight in named]

    return by_column
