"""Pose: the true position and yaw, as the simulation or the tank's cameras see it; no instrument of the robot."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.influences import PLACE, TURN
from cocorosim_ros.world.sensors.sensor import Kind, MostError, Recorded, Sensor, fixed
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.blocks import HR, HU, HV, HX, HY, HYAW, VW, VZ

# mypy: disable-error-code="no-any-return"
When = tuple[float, float, float, float]
Rates = tuple[Floats, Floats]
_BENT = ("x*x", "y*y", "x*y")  # a lens that bends


@kernel
def _x(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    """x [m; world] by a Taylor series of second order."""
    after, rate = when[1], rates[0]
    half = 0.5 * after * after
    sine, cosine = sine_cosine(row[YAW])
    forward, left = rate[SURGE] - row[SWAY] * row[YAW_RATE], rate[SWAY] + row[SURGE] * row[YAW_RATE]
    ahead = after * (row[SURGE] * cosine - row[SWAY] * sine) + half * (forward * cosine - left * sine)
    return row[X] + ahead


@kernel
def _y(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    """y [m; world] by a Taylor series of second order."""
    after, rate = when[1], rates[0]
    half = 0.5 * after * after
    sine, cosine = sine_cosine(row[YAW])
    forward, left = rate[SURGE] - row[SWAY] * row[YAW_RATE], rate[SWAY] + row[SURGE] * row[YAW_RATE]
    ahead = after * (row[SURGE] * sine + row[SWAY] * cosine) + half * (forward * sine + left * cosine)
    return row[Y] + ahead


@kernel
def height(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    """z [m; world] by a Taylor series of second order."""
    after = when[1]
    half = 0.5 * after * after
    return row[Z] + after * row[HEAVE] + half * rates[0][HEAVE]


@kernel
def heading(when: When, row: Floats, rates: Rates, water: Floats) -> float:
    """Yaw [rad; world], not wrapped, by a Taylor series of second order."""
    after = when[1]
    half = 0.5 * after * after
    return row[YAW] + after * row[YAW_RATE] + half * rates[0][YAW_RATE]


@kernel
def _by_x(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    sine, cosine = sine_cosine(row[YAW])
    seen[HX] = slope
    seen[HYAW] = -slope * after * (row[SURGE] * sine + row[SWAY] * cosine)
    seen[HU], seen[HV] = slope * after * cosine, -slope * after * sine


@kernel
def _by_y(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    sine, cosine = sine_cosine(row[YAW])
    seen[HY] = slope
    seen[HYAW] = slope * after * (row[SURGE] * cosine - row[SWAY] * sine)
    seen[HU], seen[HV] = slope * after * sine, slope * after * cosine


@kernel
def _by_height(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    seen[VZ], seen[VW] = slope, slope * after


@kernel
def by_heading(after: float, row: Floats, slope: float, rates: Floats, seen: Floats) -> None:
    """Add the derivative of a heading to `seen`, see Kind."""
    seen[HYAW], seen[HR] = slope, slope * after


def yaw_of_quaternions(quaternion: Floats) -> Floats:
    """(n,) yaw [rad] of (n, 4) quaternions x y z w of any length; NaN for zero ones."""
    x, y, z, w = quaternion.T
    yaw = np.arctan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z)
    return np.where((quaternion == 0).all(axis=1), np.nan, yaw)


def _orientation(numbers: Floats) -> Floats:
    return numbers[:, 3:]


def _columns(numbers: Floats) -> Floats:
    return np.column_stack([numbers[:, :3], yaw_of_quaternions(numbers[:, 3:])])


_LENGTH = MostError(0.1, 0.1)  # refraction and lenses; a marker off the centre

POSE = Sensor(
    topic="pose",
    message="geometry_msgs/msg/PoseStamped",
    publisher="simulation, or the tank's cameras",
    meaning="true position and attitude in frame `world`",
    layout=fixed(*(f"pose.position.{axis}" for axis in "xyz"), *(f"pose.orientation.{axis}" for axis in "xyzw")),
    optional=False,
    for_all=True,
    kinds=(
        Kind("pose_x", "x", "m", _x, _by_x, noise="pose_xy", noise_words="a reading of pose, x and y",
             words="the pose along x",
             least_noise=1e-4,
             least_motion=0.005, large_error=0.03, error_follows=("y", "z", *_BENT, "|x|^2*x"),
             most_error=_LENGTH, shows=("x",)),
        Kind("pose_y", "y", "m", _y, _by_y, noise="pose_xy",
             words="the pose along y",
             least_noise=1e-4,
             least_motion=0.005, large_error=0.03, error_follows=("x", "z", *_BENT, "|y|^2*y"),
             most_error=_LENGTH, shows=("y",)),
        Kind("pose_z", "z", "m", height, _by_height, upright=True, noise_words="a reading of pose, z",
             words="the height of the pose",
             least_noise=1e-4,
             least_motion=0.005, large_error=0.03, error_follows=(*PLACE, "x*x", "y*y", "z*z"),
             most_error=_LENGTH, shows=("z", "w")),
        Kind("pose_yaw", "yaw", "rad", heading, by_heading, angle=True, noise_words="a reading of pose, yaw",
             words="the heading of the pose",
             least_noise=1e-3, least_motion=0.02, large_error=0.05, error_follows=(*PLACE, "t"),
             most_error=MostError(0.5), shows=TURN),
    ),
    recorded=Recorded(7, _columns, drawn="pose_x", late_with="u", orientation=_orientation),
)  # fmt: skip
