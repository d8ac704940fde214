"""IMU: yaw rate and specific force, after REP 145: at rest it reads +g upwards.

The specific force is the acceleration of the hull in body axes less gravity, at the very moment of the
measurement, under the forces that the actuators deliver then.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.influences import HEADING, MOTORS, PUMP, TURN
from cocorosim_ros.world.sensors.pose import Rates, When
from cocorosim_ros.world.sensors.rates_of_state import by_level_rate, rate_after
from cocorosim_ros.world.sensors.sensor import Column, Field, Kind, MostError, Recorded, Sensor, fixed
from cocorosim_ros.world.sensors.sight import Sight
from cocorosim_ros.world.state.pressure import GRAVITY
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW_RATE
from cocorosim_ros.world.terms.blocks import HORIZONTAL, HR, HU, HV, VERTICAL, VFZ, VW, VZ

# mypy: disable-error-code="no-any-return"
_ACCELERATED = (*MOTORS, "z", "t", "u", "r", "r*r", "u*u")
NOT_ESTIMATED = -1.0  # REP 145: first element of the covariance of what an IMU does not measure


@kernel
def force_ahead(rate: float, row: Floats) -> float:
    """Specific force along x [m/s^2; body] where surge changes at `rate` [m/s^2]; `row` is the state."""
    return rate - row[SWAY] * row[YAW_RATE]


@kernel
def force_left(rate: float, row: Floats) -> float:
    """Specific force along y [m/s^2; body] where sway changes at `rate` [m/s^2]; `row` is the state."""
    return rate + row[SURGE] * row[YAW_RATE]


@kernel
def force_up(rate: float, gravity: float) -> float:
    """Specific force along z [m/s^2; body] where heave changes at `rate` [m/s^2]."""
    return rate + gravity


@kernel
def measure(sight: Sight, angular_rate: Floats, specific_force: Floats) -> None:
    """Write the angular rate (3,) [rad/s; body], which has no pitch and no roll, and the specific force (3,)."""
    angular_rate[0] = 0.0
    angular_rate[1] = 0.0
    angular_rate[2] = sight.row[YAW_RATE]
    specific_force[0] = force_ahead(sight.rate[SURGE], sight.row)
    specific_force[1] = force_left(sight.rate[SWAY], sight.row)
    specific_force[2] = force_up(sight.rate[HEAVE], sight.instruments.gravity[sight.robot])


@kernel
def _gyro(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return rate_after(YAW_RATE, when, row, rates)


@kernel
def _ahead(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return force_ahead(rates[0][SURGE] + 0.5 * when[3] * rates[1][SURGE], row)


@kernel
def _left(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return force_left(rates[0][SWAY] + 0.5 * when[3] * rates[1][SWAY], row)


@kernel
def _up(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    return force_up(rates[0][HEAVE] + 0.5 * when[3] * rates[1][HEAVE], GRAVITY)


@kernel
def _by_gyro(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    by_level_rate(HR, after, slope, rates, seen)


@kernel
def _by_ahead(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    for column in range(HORIZONTAL):
        seen[column] = slope * rates[HU * HORIZONTAL + column]
    seen[HV] -= slope * row[YAW_RATE]
    seen[HR] -= slope * row[SWAY]


@kernel
def _by_left(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    for column in range(HORIZONTAL):
        seen[column] = slope * rates[HV * HORIZONTAL + column]
    seen[HU] += slope * row[YAW_RATE]
    seen[HR] += slope * row[SURGE]


@kernel
def _by_up(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    seen[VZ], seen[VW] = slope * rates[VW * VERTICAL + VZ], slope * rates[VW * VERTICAL + VW]
    seen[VFZ] = slope * rates[VW * VERTICAL + VFZ]


def _orientation(numbers: Floats) -> Floats:
    """The first four numbers, unless the covariance behind them says that the IMU does not estimate them."""
    return np.where(numbers[:, 4:5] == NOT_ESTIMATED, np.nan, numbers[:, :4])


def _columns(numbers: Floats) -> Floats:
    """After orientation (4), its covariance (9), rate (3), its covariance (9), specific force (3), its covariance."""
    rate, force = numbers[:, 15:16].copy(), numbers[:, 25:28].copy()
    rate[numbers[:, 16] == NOT_ESTIMATED] = np.nan
    force[(numbers[:, 28] == NOT_ESTIMATED) | (force == 0.0).all(axis=1)] = np.nan
    return np.hstack([rate, force])


_TILTED = MostError(2.0, 0.1)  # gravity at a tilt of 12 degrees

IMU = Sensor(
    topic="imu",
    message="sensor_msgs/msg/Imu",
    meaning="angular rate and specific force in `base_link`",
    layout=fixed(
        *(f"angular_velocity.{axis}" for axis in "xyz"),
        *(f"linear_acceleration.{axis}" for axis in "xyz"),
        orientation_covariance=np.array([NOT_ESTIMATED, 0, 0, 0, 0, 0, 0, 0, 0]),
        orientation={"w": 1.0},
    ),
    fields=(
        Field("angular_rate", "rad/s", 3, channels={"gyro": slice(0, 3)}),
        Field("specific_force", "m/s^2", 3, channels={"accelerometer": slice(0, 3)}),
    ),
    measure=measure,
    optional=False,
    for_all=True,
    columns=(
        *(Column(f"angular_rate_{axis}", f"angular_velocity.{axis}", "rad/s") for axis in "xyz"),
        *(Column(f"specific_force_{axis}", f"linear_acceleration.{axis}", "m/s^2") for axis in "xyz"),
    ),
    kinds=(
        Kind("gyro_z", "gyro_z", "rad/s", _gyro, _by_gyro, ("angular_rate", 2),
             noise_words="a reading of the gyroscope",
             words="the gyroscope",
             least_noise=1e-3, least_motion=0.01, large_error=0.02,
             error_follows=(*MOTORS, *PUMP, "t", "z", "u", "v", "speed", *HEADING, "|r|", "|r|*r"),
             most_error=MostError(0.2, 0.35), shows=TURN),  # a cheap gyroscope that is cold, or scaled for another
        Kind("accel_x", "accel_x", "m/s^2", _ahead, _by_ahead, ("specific_force", 0), noise="accel",
             noise_words="a reading of the accelerometer",
             words="the accelerometer along the hull",
             least_noise=1e-3, large_error=0.03,
             error_follows=_ACCELERATED, most_error=_TILTED),
        Kind("accel_y", "accel_y", "m/s^2", _left, _by_left, ("specific_force", 1), noise="accel",
             words="the accelerometer across the hull",
             least_noise=1e-3,
             large_error=0.03, error_follows=_ACCELERATED, most_error=_TILTED),
        Kind("accel_z", "accel_z", "m/s^2", _up, _by_up, ("specific_force", 2), upright=True, noise="accel",
             words="the upright accelerometer",
             least_noise=1e-3, large_error=0.03, error_follows=_ACCELERATED, most_error=_TILTED),
    ),
    recorded=Recorded(37, _columns, drawn="gyro_z", orientation=_orientation),
)  # fmt: skip
