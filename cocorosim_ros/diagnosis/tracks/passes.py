"""What the filter leaves of a track: passes and smoothed courses."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.foundation.arrays import Flags, Floats

# Columns of a smoothed course behind those of world.state.state: the random force of the water [N, N, N, N m; world].
FORCE_X, FORCE_Y, FORCE_Z, YAW_MOMENT = range(8, 12)
COURSE_SIZE = 12


@dataclass(frozen=True)
class Pass:
    """What a pass of the filter leaves, each (m,) in the order of the track's timeline, gain (m, HORIZONTAL)."""

    innovation: Floats
    variance: Floats
    gain: Floats
    believed: Flags  # innovations within the gate
    log_likelihood: float


@dataclass(frozen=True)
class Smoothed:
    """time (points,) [s]; mean, spread (points, COURSE_SIZE): x y z yaw u v w r, then the random force of the water."""

    time: Floats
    mean: Floats
    spread: Floats
