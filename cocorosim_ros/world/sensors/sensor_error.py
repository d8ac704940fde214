"""What an error of a sensor is: its numbers, and how it changes what is shown."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor import MostError
from cocorosim_ros.world.terms.effect import Description
from cocorosim_ros.world.terms.search import Search

Hook = Callable[..., Any]
TAKEN = ("row", "heading", "water", "ground", "motors")
"""What an error may depend on beside its own reading: the state at the grid point or tick next to the reading, the
heading [rad] at the reading itself, the velocity through the water (4,) [m/s, rad/s; body] and that over ground (3,)
[m/s; body], and terms.motors.Motors."""


@dataclass(frozen=True)
class Change:
    """How an error changes one number of a reading; `numbers` are those of its parameters that it takes.

    shown(value, truth, stamp, *takes, *numbers) returns what is shown in place of `value`, which other errors may have
    changed, where an ideal sensor would show `truth` at `stamp` [s]. slope(row, *numbers) returns its derivative by the
    truth at the state `row`; None where that is 1. foreseen: `shown` in the filter, where it needs other functions.
    takes: what else `shown` is given, names of TAKEN. aside(after, row, slope, seen, *numbers) adds the derivative by
    other numbers of the state to `seen`, as `sensitivity` of sensors.sensor.Kind does; `slope` is that of the errors
    behind this one. None where there is none.
    """

    kind: str  # of sensors.KINDS
    numbers: tuple[str, ...]
    shown: Hook
    slope: Hook | None = None
    foreseen: Hook | None = None
    takes: tuple[str, ...] = ()
    aside: Hook | None = None


@dataclass(frozen=True)
class OfEveryStream:
    """How an error is told of which each stream has its own: there the parameters are called like the topics.

    number: what the parameter is called where the topic is known. summary, search: of the error of one topic.
    """

    number: str
    summary: Callable[[str], str]
    search: Callable[[str], Search]


@dataclass(frozen=True, kw_only=True)
class SensorError(Description):
    """One way in which instruments, cameras or clocks are wrong by a law; what is random is sensors.corruption.

    sensor: the topic that it is of; '' for all. beside: errors of the same sensor all numbers of which are fitted with
    it, because the one does not come without the other. against: the regressor, or |its amount|, along which the report
    draws it.
    told_by: states that other readings have to show for the error to be told (diagnosis.catalogue.shown_by), where its
    slopes do not say it. by_another: these have to be readings of another instrument. most_error: of this very error,
    where that is more than whatever law such an instrument may follow. where_recorded: of an instrument that few robots
    have, so that a recording without its topic is not said to leave the error unseen.
    """

    sensor: str = ""
    changes: tuple[Change, ...] = ()
    streams: OfEveryStream | None = None
    beside: tuple[str, ...] = ()
    against: str = "t"
    told_by: tuple[str, ...] = ()
    by_another: bool = False
    most_error: MostError | None = None
    where_recorded: bool = False


@kernel
def added(value: float, truth: float, stamp: float, amount: float) -> float:
    """Return what is shown with a constant amount on top."""
    return value + amount


@kernel
def multiplied(value: float, truth: float, stamp: float, factor: float) -> float:
    """Return what is shown times a factor."""
    return factor * value


@kernel
def multiplied_slope(row: Floats, factor: float) -> float:
    """Derivative of `multiplied` by the truth."""
    return factor
