"""A pose of another point than the body's origin: shown = place + R(yaw) (ahead, left), of a marker or an antenna.

It is of a recording, not of a simulation. Assumes: a rigid hull that stays level.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor import MostError
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.state.state import YAW, YAW_RATE
from cocorosim_ros.world.terms.blocks import HR, HYAW
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def shown_x(value: float, truth: float, stamp: float, heading: float, ahead: float, left: float) -> float:
    """Place along x [m; world] in place of `value`."""
    if ahead == 0.0 and left == 0.0:  # as nearly always
        return value
    sine, cosine = sine_cosine(heading)
    place: float = value + ahead * cosine - left * sine
    return place


@kernel
def shown_y(value: float, truth: float, stamp: float, heading: float, ahead: float, left: float) -> float:
    """Place along y [m; world] in place of `value`."""
    if ahead == 0.0 and left == 0.0:
        return value
    sine, cosine = sine_cosine(heading)
    place: float = value + ahead * sine + left * cosine
    return place


@kernel
def x_by_turn(after: float, row: Floats, slope: float, seen: Floats, ahead: float, left: float) -> None:
    """Add the derivative of x by yaw and yaw rate."""
    sine, cosine = sine_cosine(row[YAW] + after * row[YAW_RATE])
    by_yaw = -slope * (ahead * sine + left * cosine)
    seen[HYAW] += by_yaw
    seen[HR] += by_yaw * after


@kernel
def y_by_turn(after: float, row: Floats, slope: float, seen: Floats, ahead: float, left: float) -> None:
    """Add the derivative of y by yaw and yaw rate."""
    sine, cosine = sine_cosine(row[YAW] + after * row[YAW_RATE])
    by_yaw = slope * (ahead * cosine - left * sine)
    seen[HYAW] += by_yaw
    seen[HR] += by_yaw * after


POSE_LEVER = SensorError(
    summary="pose of a point off the body's origin",
    equation="reading = place",
    parameters=tuple(
        Number(name, "m", meaning, gives="m", search=Strength(large=0.02), example=Example(value, "ruler"), part=part)
        for name, meaning, value, part in (
            ("ahead", "the point before the origin", 0.03, " + ahead (cos(yaw), sin(yaw))"),
            ("left", "the point to the left of the origin", -0.01, " + left (-sin(yaw), cos(yaw))"),
        )
    ),
    sensor="pose",
    most_error=MostError(0.0, hulls=1.0),  # a mast or an antenna at an end of it, whatever the vehicle's way
    changes=(
        Change("pose_x", ("ahead", "left"), shown_x, takes=("heading",), aside=x_by_turn),
        Change("pose_y", ("ahead", "left"), shown_y, takes=("heading",), aside=y_by_turn),
    ),
    against="yaw",
    told_by=("yaw",),
    by_another=True,  # of what cameras alone show, the model alone tells it from the way in which a vehicle drifts
    search=Search(channel="pose", topic="pose", manoeuvre="slow_turns"),
    check="Where the marker or the antenna sits on the hull; turn the vehicle on the spot and watch the pose.",
)
