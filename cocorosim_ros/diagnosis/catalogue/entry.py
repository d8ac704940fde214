"""An entry of the catalogue: an effect by the contract's identifier, and how it is looked for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.sensors.sensor_error import OfEveryStream, SensorError
from cocorosim_ros.world.terms.effect import Description, Number
from cocorosim_ros.world.terms.search import Basis, Given, Grid, Limits, Scene, Search, Spacing, Standing, Strength

__all__ = ["SENSOR_CHANNELS", "Amplitude", "Entry", "Scene", "Shape", "entries_of_error", "entry_of"]

SENSOR_CHANNELS = ("clock", *(topic for topic, sensor in SENSORS.items() if sensor.kinds))
"""Channels of entries that act on what is read; all others act on the motion."""


@dataclass(frozen=True)
class Amplitude(Limits):
    """A number that is neutral where the effect is absent; `large` is its size in a bad case, the unit of its q.

    Its prior is a normal distribution with standard deviation `large` around neutral.
    """

    column: str
    name: str
    unit: str
    large: float
    neutral: float = 0.0


@dataclass(frozen=True)
class Shape(Spacing):
    """A number that says where, when or how; it has no meaning while the amplitudes are neutral.

    Looked for on a grid first; `spacing` is the unit of its q, between two points of the grid.
    """

    column: str
    name: str
    unit: str
    grid: Callable[[Scene], list[float]]


@dataclass(frozen=True)
class Entry(Standing):
    """One effect, or a law outside the catalogue, with the columns of its numbers.

    fixed: numbers of the simulator's effect that are given, by column, from the scene.
    """

    id: str
    name: str
    equation: str  # in plain text
    channel: str  # the contract's equation: surge, sway, heave, yaw, compass, pressure, imu, pose, clock
    amplitudes: tuple[Amplitude, ...]
    shapes: tuple[Shape, ...] = ()
    fixed: Mapping[str, Callable[[Scene], float]] = field(default_factory=dict)
    manoeuvre: str = ""  # a name in catalogue.manoeuvres
    needs_neighbours: bool = False
    prior_nats: float = 0.0  # against it from the outset, for entries of which there are many
    law: str | None = None  # the place of the simulator that it takes, for laws outside the catalogue
    form: Law | None = None  # what such a law says


def entry_of(identifier: str, effect: Description, search: Search) -> Entry:
    """The entry of an effect of the world, as the effect's own file tells it; columns are IDENTIFIER.PARAMETER."""
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
        **standing,
    )


def entries_of_error(identifier: str) -> list[Entry]:
    """The entries of an error of sensors: one, or one for each stream where each may have it by itself."""
    error = ERRORS[identifier]
    if error.streams is not None:
        return [_of_stream(identifier, error, error.streams, number) for number in error.numbers]
    if error.search is None:
        return []
    entry = entry_of(identifier, error, error.search)
    beside = [part for name in error.beside for part in entry_of(name, ERRORS[name], error.search).amplitudes]
    return [replace(entry, amplitudes=(*entry.amplitudes, *beside))]


def _of_stream(identifier: str, error: SensorError, streams: OfEveryStream, number: Number) -> Entry:
    """The entry of the error of one stream, whose topic the number is called by."""
    one = replace(error, summary=streams.summary(number.name), parameters=(number,))
    entry = entry_of(identifier, one, streams.search(number.name))
    return replace(entry, amplitudes=tuple(replace(part, name=streams.number) for part in entry.amplitudes))


def _amplitude(column: str, number: Number, how: Strength) -> Amplitude:
    limits = _fields_of(Limits, how)
    return Amplitude(column, number.name, number.unit, how.large, neutral=number.neutral, **limits)


def _shape(column: str, number: Number, how: Grid) -> Shape:
    return Shape(column, number.name, number.unit, how.points, **_fields_of(Spacing, how))


def _fields_of(kind: type[Limits | Spacing | Standing], source: Limits | Spacing | Standing) -> dict[str, Any]:
    """The fields that `kind` declares, by name."""
    return {each.name: getattr(source, each.name) for each in fields(kind)}


def _by_column(identifier: str, basis: Basis) -> Basis:
    """The basis of an effect, which knows its shapes by name, for shapes by column."""

    def by_column(values: Mapping[str, float]) -> list[tuple[dict[str, float], float]]:
        named = basis({column.removeprefix(f"{identifier}."): value for column, value in values.items()})
        return [({f"{identifier}.{name}": value for name, value in at.items()}, weight) for at, weight in named]

    return by_column
