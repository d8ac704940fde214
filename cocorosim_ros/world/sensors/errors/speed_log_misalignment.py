"""A speed log that is turned about the vertical: shown = (u cos + v sin, v cos - u sin) of its angle.

The log's own axes are turned by the angle against the body's, counter-clockwise positive.
Source: alignment of a Doppler log; Kinsey and Whitcomb, IEEE Journal of Oceanic Engineering 32 (2007) 286.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.terms.blocks import HU, HV
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import COURSE
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def shown_ahead(value: float, truth: float, stamp: float, velocity: Floats, angle: float) -> float:
    """Speed ahead [m/s] in place of `value`; velocity: that which the log measures, along the body's axes."""
    sine, cosine = sine_cosine(angle)
    speed: float = value + (cosine - 1.0) * truth + sine * velocity[1]
    return speed


@kernel
def shown_aside(value: float, truth: float, stamp: float, velocity: Floats, angle: float) -> float:
    """Speed to the left [m/s] in place of `value`, as `shown_ahead`."""
    sine, cosine = sine_cosine(angle)
    speed: float = value + (cosine - 1.0) * truth - sine * velocity[0]
    return speed


@kernel
def slope(row: Floats, angle: float) -> float:
    """Derivative of a speed that is shown by the true one along the same axis."""
    cosine: float = sine_cosine(angle)[1]
    return cosine


@kernel
def ahead_by_left(after: float, row: Floats, slope: float, seen: Floats, angle: float) -> None:
    """Add the derivative of the speed ahead by that to the left."""
    seen[HV] += slope * sine_cosine(angle)[0]


@kernel
def left_by_ahead(after: float, row: Floats, slope: float, seen: Floats, angle: float) -> None:
    """Add the derivative of the speed to the left by that ahead."""
    seen[HU] -= slope * sine_cosine(angle)[0]


def turned_log(topic: str, summary: str, measured: str) -> SensorError:
    """The error of the log that publishes `topic`; measured: the velocity that it takes, of sensor_error.TAKEN."""
    return SensorError(
        summary=summary,
        equation="reading = (u cos(angle) + v sin(angle), v cos(angle) - u sin(angle))",
        parameters=(
            Number(
                "angle",
                "rad",
                "of the log's axes against the body's, counter-clockwise positive",
                gives="rad",
                search=Strength(large=0.08),
                example=Example(0.03, "track against heading at slack water"),
            ),
        ),
        sensor=topic,
        changes=(
            Change(f"{topic}_u", ("angle",), shown_ahead, slope, takes=(measured,), aside=ahead_by_left),
            Change(f"{topic}_v", ("angle",), shown_aside, slope, takes=(measured,), aside=left_by_ahead),
        ),
        against="u",
        told_by=("u", "v"),
        search=Search(channel=topic, group=COURSE, topic=topic, manoeuvre="four_headings"),
        check="Compare the track over ground with what log and heading make of it, on a straight line there and back.",
    )


SPEED_LOG_MISALIGNMENT = turned_log("velocity", "speed log that is turned against the hull", "water")
