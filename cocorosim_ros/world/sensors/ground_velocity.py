"""Ground velocity: the robot's motion over ground, as a Doppler log with bottom track, a satellite receiver or motion
capture shows it.

In a current V it differs from the velocity through the water by what the current is along the body's axes:
u_ground = u_water + V_x cos(yaw) + V_y sin(yaw), v_ground = v_water - V_x sin(yaw) + V_y cos(yaw).
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.pose import Rates, When
from cocorosim_ros.world.sensors.rates_of_state import by_level_rate, rate_after
from cocorosim_ros.world.sensors.sensor import Column, Field, Kind, MostError, Recorded, Sensor, fixed
from cocorosim_ros.world.sensors.sight import Sight
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY
from cocorosim_ros.world.terms.blocks import HU, HV, VERTICAL, VW

# mypy: disable-error-code="no-any-return"


@kernel
def measure(sight: Sight, ground_velocity: Floats) -> None:
    """Write u, v, w [m/s; body] over ground."""
    for axis in range(3):
        ground_velocity[axis] = sight.row[SURGE + axis]


@kernel
def _ahead(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return rate_after(SURGE, when, row, rates)


@kernel
def _left(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return rate_after(SWAY, when, row, rates)


@kernel
def _up(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return rate_after(HEAVE, when, row, rates)


@kernel
def _by_ahead(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    by_level_rate(HU, after, slope, rates, seen)


@kernel
def _by_left(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    by_level_rate(HV, after, slope, rates, seen)


@kernel
def _by_up(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    for column in range(VERTICAL):
        seen[column] = slope * (after * rates[VW * VERTICAL + column])
    seen[VW] += slope


_MOST = MostError(0.05, 0.2)  # a log that takes another speed of sound or another mounting, as one through the water

GROUND_VELOCITY = Sensor(
    topic="ground_velocity",
    message="geometry_msgs/msg/TwistStamped",
    meaning="the robot's velocity over ground (bottom track, satellites, motion capture), in `base_link`",
    layout=fixed(*(f"twist.linear.{axis}" for axis in "xyz"), twist={"angular": dict.fromkeys("xyz", math.nan)}),
    fields=(Field("ground_velocity", "m/s", 3, channels={"ground_velocity": slice(0, 3)}),),
    measure=measure,
    columns=(
        *(Column(name, f"twist.linear.{axis}", "m/s") for name, axis in zip("uvw", "xyz", strict=True)),
        *(Column(name, f"twist.angular.{axis}", "rad/s") for name, axis in zip("pqr", "xyz", strict=True)),
    ),
    kinds=(
        Kind("ground_velocity_u", "u", "m/s", _ahead, _by_ahead, ("ground_velocity", 0), noise="ground_velocity",
             noise_words="a reading of the velocity over ground",
             words="the speed over ground ahead",
             least_noise=1e-4, least_motion=0.002,
             large_error=0.005, error_follows=("t", "|thrust|", "|r|*r", "|u|*u"), most_error=_MOST, shows=("u",)),
        Kind("ground_velocity_v", "v", "m/s", _left, _by_left, ("ground_velocity", 1), noise="ground_velocity",
             words="the speed over ground to the left",
             least_noise=1e-4, least_motion=0.002, large_error=0.005, error_follows=("r", "t"), most_error=_MOST,
             shows=("v",)),
        Kind("ground_velocity_w", "w", "m/s", _up, _by_up, ("ground_velocity", 2), upright=True,
             noise="ground_velocity",
             words="the speed over ground upwards",
             least_noise=1e-4, least_motion=0.002, large_error=0.005, error_follows=("t",),
             most_error=_MOST, shows=("z", "w")),
    ),
    recorded=Recorded(6, lambda numbers: numbers[:, :3]),
)  # fmt: skip
