"""A speed log that is off the body's origin: shown = (u - left r, v + ahead r) of where its head is.

Assumes: a rigid hull that stays level.
Source: velocity of a point of a rigid body; of a Doppler log, Kinsey and Whitcomb, IEEE Journal of Oceanic Engineering
32 (2007) 286.
"""

from __future__ import annotations

from dataclasses import replace

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor import MostError
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.state.state import YAW_RATE
from cocorosim_ros.world.terms.blocks import HR
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import COURSE
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def shown_ahead(value: float, truth: float, stamp: float, row: Floats, left: float) -> float:
    """Speed ahead [m/s] in place of `value`."""
    speed: float = value - left * row[YAW_RATE]
    return speed


@kernel
def shown_aside(value: float, truth: float, stamp: float, row: Floats, ahead: float) -> float:
    """Speed to the left [m/s] in place of `value`."""
    speed: float = value + ahead * row[YAW_RATE]
    return speed


@kernel
def ahead_by_turn(after: float, row: Floats, slope: float, seen: Floats, left: float) -> None:
    """Add the derivative of the speed ahead by the yaw rate."""
    seen[HR] -= slope * left


@kernel
def aside_by_turn(after: float, row: Floats, slope: float, seen: Floats, ahead: float) -> None:
    """Add the derivative of the speed to the left by the yaw rate."""
    seen[HR] += slope * ahead


def log_off_the_origin(topic: str, summary: str) -> SensorError:
    """The error of the log that publishes `topic`."""
    return SensorError(
        summary=summary,
        equation="reading = (u, v)",
        parameters=(
            Number(
                "ahead",
                "m",
                "the log before the origin",
                gives="m/s",
                multiplies="rad/s",
                search=Strength(large=0.02),
                example=Example(0.05, "ruler"),
                part=" + ahead (0, r)",
            ),
            Number(
                "left",
                "m",
                "the log to the left of the origin",
                gives="m/s",
                multiplies="rad/s",
                search=Strength(large=0.02),
                example=Example(0.0, "ruler"),
                part=" + left (-r, 0)",
            ),
        ),
        sensor=topic,
        most_error=MostError(0.0, hulls=1.0),  # at an end of the hull, whatever the vehicle's way
        changes=(
            Change(f"{topic}_u", ("left",), shown_ahead, takes=("row",), aside=ahead_by_turn),
            Change(f"{topic}_v", ("ahead",), shown_aside, takes=("row",), aside=aside_by_turn),
        ),
        against="r",
        told_by=("r",),
        search=Search(channel=topic, group=COURSE, topic=topic, manoeuvre="slow_turns"),
        check="Where the log sits on the hull; turn the vehicle on the spot and watch the speed that it shows.",
    )


SPEED_LOG_LEVER = replace(log_off_the_origin("velocity", "speed log off the body's origin"), where_recorded=True)
