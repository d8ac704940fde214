"""REGRESSORS: what a law can be proportional to. The place in the table is the code that a law carries.

Velocities are those through the water; `thrust`, `yaw_command` and `pump` are what the actuators deliver. Each entry is
the only place that says how its regressor is computed: compiled for one state, and for all moments of a course at once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.course import (
    Course,
    clearance_along,
    motor_effort,
    neighbour_distance_along,
    pump_along,
)
from cocorosim_ros.world.terms.moment import neighbour_distance

AlongCourse = Callable[[Course, Floats], Floats]


class Extent(NamedTuple):
    """How far recordings reach: root mean squares of the state, duration, full forces."""

    rms: Floats  # (8,) of x y z yaw u v w r
    duration: float  # s
    force: Floats  # (4,) of all actuators at their limits [N, N, N, N m]
    enclosed: bool  # whether it is known where the water ends


@dataclass(frozen=True)
class Regressor:
    """What a law can be proportional to.

    value(row, relative, moment, swing) is its value, compiled: `row` a robot's state (state.state), `relative` (4,) its
    velocity through the water [m/s, rad/s; body], `moment` what else there is to know (terms.moment), `swing` [rad] the
    angle of sin_t and cos_t.
    along(course, swing) is the same at the points of a course, with `swing` (points,) [rad].
    typical(extent) is the size that it has in recordings of this extent, 0 where they do not show it.
    """

    name: str
    unit: str
    meaning: str
    value: Callable[..., Any]
    along: AlongCourse
    typical: Callable[[Extent], float]
    from_actuators: bool = False  # along a course it is a mean from each point to the next
    from_own_course: bool = True  # False where it takes neighbours or a rate of its own: no law of a reading has it
    effort: AlongCourse | None = None  # its amount in laws of readings, where that is not the amount of its values
    label: str = ""  # beside the axis of a picture, where the name says too little


def _at_least(size: float) -> float:
    """A size that can be divided by."""
    return float(max(size, 1e-6))


REGRESSORS: tuple[Regressor, ...] = (
    Regressor(
        "1", "1", "a constant",
        kernel(lambda row, relative, moment, swing: 1.0),
        lambda course, swing: np.ones(len(course.time)),
        lambda extent: 1.0,
    ),
    Regressor(
        "x", "m", "the place along x of the world",
        kernel(lambda row, relative, moment, swing: row[X]),
        lambda course, swing: course.state[:, X],
        lambda extent: _at_least(extent.rms[X]),
    ),
    Regressor(
        "y", "m", "the place along y of the world",
        kernel(lambda row, relative, moment, swing: row[Y]),
        lambda course, swing: course.state[:, Y],
        lambda extent: _at_least(extent.rms[Y]),
    ),
    Regressor(
        "z", "m", "the place upwards, negative below the surface",
        kernel(lambda row, relative, moment, swing: row[Z]),
        lambda course, swing: course.state[:, Z],
        lambda extent: _at_least(extent.rms[Z]),
        label="height z",
    ),
    Regressor(
        "t", "s", "the time",
        kernel(lambda row, relative, moment, swing: moment.time),
        lambda course, swing: course.time,
        lambda extent: extent.duration,
    ),
    Regressor(
        "u", "m/s", "the speed forwards",
        kernel(lambda row, relative, moment, swing: relative[0]),
        lambda course, swing: course.state[:, SURGE],
        lambda extent: _at_least(extent.rms[SURGE]),
    ),
    Regressor(
        "v", "m/s", "the speed to the left",
        kernel(lambda row, relative, moment, swing: relative[1]),
        lambda course, swing: course.state[:, SWAY],
        lambda extent: _at_least(extent.rms[SWAY]),
    ),
    Regressor(
        "w", "m/s", "the speed upwards",
        kernel(lambda row, relative, moment, swing: relative[2]),
        lambda course, swing: course.state[:, HEAVE],
        lambda extent: _at_least(extent.rms[HEAVE]),
    ),
    Regressor(
        "r", "rad/s", "the yaw rate",
        kernel(lambda row, relative, moment, swing: relative[3]),
        lambda course, swing: course.state[:, YAW_RATE],
        lambda extent: _at_least(extent.rms[YAW_RATE]),
    ),
    Regressor(
        "speed", "m/s", "the total speed",
        kernel(lambda row, relative, moment, swing: math.sqrt(relative[0] ** 2 + relative[1] ** 2 + relative[2] ** 2)),
        lambda course, swing: np.linalg.norm(course.state[:, SURGE : HEAVE + 1], axis=1),
        lambda extent: _at_least(np.hypot(extent.rms[SURGE], extent.rms[SWAY])),
    ),
    Regressor(
        "thrust", "N", "the forward force of the thrusters",
        kernel(lambda row, relative, moment, swing: moment.thrust[0]),
        lambda course, swing: course.thrust[:, 0],
        lambda extent: 0.5 * float(max(extent.force[0], extent.force[1])),
        from_actuators=True,
        effort=lambda course, swing: motor_effort(course),
        label="thrust command",
    ),
    Regressor(
        "yaw_command", "N m", "the yaw moment of the thrusters",
        kernel(lambda row, relative, moment, swing: moment.thrust[3]),
        lambda course, swing: course.thrust[:, 3],
        lambda extent: 0.3 * float(extent.force[3]),
        from_actuators=True,
        label="torque command",
    ),
    Regressor(
        "pump", "N", "the force of the pump",
        kernel(lambda row, relative, moment, swing: moment.pump),
        lambda course, swing: pump_along(course, course.force),
        lambda extent: 0.2 * float(extent.force[2]),
        from_actuators=True,
        label="pump command",
    ),
    Regressor(
        "pump_rate", "N/s", "the rate of change of the pump's force",
        kernel(lambda row, relative, moment, swing: moment.pump_rate),
        lambda course, swing: pump_along(course, course.rate),
        lambda extent: 0.2 * float(extent.force[2]),
        from_actuators=True,
    ),
    Regressor(
        "sin_yaw", "1", "the sine of the heading",
        kernel(lambda row, relative, moment, swing: sine_cosine(row[YAW])[0]),
        lambda course, swing: np.sin(course.state[:, YAW]),
        lambda extent: math.sqrt(0.5),
    ),
    Regressor(
        "cos_yaw", "1", "the cosine of the heading",
        kernel(lambda row, relative, moment, swing: sine_cosine(row[YAW])[1]),
        lambda course, swing: np.cos(course.state[:, YAW]),
        lambda extent: math.sqrt(0.5),
    ),
    Regressor(
        "sin_t", "1", "the sine of a fixed rate times the time",
        kernel(lambda row, relative, moment, swing: sine_cosine(swing)[0]),
        lambda course, swing: np.sin(swing),
        lambda extent: math.sqrt(0.5),
        from_own_course=False,
    ),
    Regressor(
        "cos_t", "1", "the cosine of a fixed rate times the time",
        kernel(lambda row, relative, moment, swing: sine_cosine(swing)[1]),
        lambda course, swing: np.cos(swing),
        lambda extent: math.sqrt(0.5),
        from_own_course=False,
    ),
    Regressor(
        "neighbour_distance", "m", "the distance to the nearest neighbour",
        kernel(lambda row, relative, moment, swing: neighbour_distance(row, moment.neighbours, moment.own)),
        lambda course, swing: neighbour_distance_along(course),
        lambda extent: 1.0,
        from_own_course=False,
    ),
    Regressor(
        "wall_distance", "m", "the distance to the nearest of walls, floor and surface",
        kernel(lambda row, relative, moment, swing: moment.clearance),
        lambda course, swing: clearance_along(course),
        lambda extent: 0.5 if extent.enclosed else 0.0,
    ),
)  # fmt: skip
REGRESSOR_CODE = {regressor.name: code for code, regressor in enumerate(REGRESSORS)}
REGRESSOR_COUNT = len(REGRESSORS)
HEADING = Regressor(
    "yaw", "rad", "the heading",
    kernel(lambda row, relative, moment, swing: row[YAW]),
    lambda course, swing: course.state[:, YAW],
    lambda extent: _at_least(extent.rms[YAW]),
    label="heading",
)  # fmt: skip
"""No law is in proportion to it, since it leaps after a full turn, but pictures are drawn over it."""
REGRESSOR: Mapping[str, Regressor] = {regressor.name: regressor for regressor in (*REGRESSORS, HEADING)}

# Writes the value of every entry of REGRESSORS into `values`, in their units; `swing` [rad] of sin_t, cos_t.
fill_regressors = compile_lines(
    "fill_regressors",
    "row, relative, moment, swing, values",
    [f"values[{code}] = value_{code}(row, relative, moment, swing)" for code in range(REGRESSOR_COUNT)],
    {f"value_{code}": regressor.value for code, regressor in enumerate(REGRESSORS)},
)


def values_along(course: Course, rate: float = 0.0, phase: float = 0.0) -> dict[str, Floats]:
    """(points,) values of all REGRESSORS and the HEADING [their units]; rate [rad/s] and phase [rad] of the swing."""
    angle = rate * course.time + phase
    return {name: np.asarray(regressor.along(course, angle)) for name, regressor in REGRESSOR.items()}
