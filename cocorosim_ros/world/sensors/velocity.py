"""Velocity: the robot's motion through the water, as a flow sensor or the operating system's model estimates it."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.pose import Rates, When
from cocorosim_ros.world.sensors.sensor import Column, Field, Kind, MostError, Recorded, Sensor, fixed
from cocorosim_ros.world.sensors.sight import Sight
from cocorosim_ros.world.terms.blocks import HU, HV, VW

# mypy: disable-error-code="no-any-return"


@kernel
def measure(sight: Sight, velocity: Floats) -> None:
    """Write u, v, w [m/s; body] and r [rad/s] through the water."""
    for axis in range(4):
        velocity[axis] = sight.relative[axis]


@kernel
def _ahead(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return water[0]


@kernel
def _left(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return water[1]


@kernel
def _up(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return water[2]


@kernel
def _by_ahead(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    seen[HU] = slope


@kernel
def _by_left(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    seen[HV] = slope


@kernel
def _by_up(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    seen[VW] = slope


_MOST = MostError(0.05, 0.2)  # dead reckoning; a log that takes another speed of sound or another mounting

VELOCITY = Sensor(
    topic="velocity",
    message="geometry_msgs/msg/TwistStamped",
    meaning="the robot's own estimate of its motion through the water, in `base_link`",
    layout=fixed(*(f"twist.linear.{axis}" for axis in "xyz"), "twist.angular.z"),
    fields=(
        Field("velocity", "m/s", 4, channels={"velocity": slice(0, 3), "yaw_rate_estimate": slice(3, 4)}),
    ),
    measure=measure,
    columns=(
        *(Column(name, f"twist.linear.{axis}", "m/s") for name, axis in zip("uvw", "xyz", strict=True)),
        *(Column(name, f"twist.angular.{axis}", "rad/s") for name, axis in zip("pqr", "xyz", strict=True)),
    ),
    kinds=(
        Kind("velocity_u", "u", "m/s", _ahead, _by_ahead, ("velocity", 0), of_water=True, noise="velocity",
             noise_words="a reading of the velocity",
             words="the speed log ahead",
             least_noise=1e-4, least_motion=0.002, large_error=0.005,
             error_follows=("t", "|thrust|", "|r|*r", "|u|*u"), most_error=_MOST,
             shows=("u",)),
        Kind("velocity_v", "v", "m/s", _left, _by_left, ("velocity", 1), of_water=True, noise="velocity",
             words="the speed log to the left",
             least_noise=1e-4, least_motion=0.002, large_error=0.005, error_follows=("r", "t"), most_error=_MOST,
             shows=("v",)),
        Kind("velocity_w", "w", "m/s", _up, _by_up, ("velocity", 2), upright=True, of_water=True, noise="velocity",
             words="the speed log upwards",
             least_noise=1e-4, least_motion=0.002, large_error=0.005, error_follows=("t",), most_error=_MOST,
             shows=("z", "w")),
    ),
    recorded=Recorded(6, lambda numbers: numbers[:, :3]),
)  # fmt: skip
