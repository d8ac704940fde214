"""Results of the filter for a track: passes and smoothed courses."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.foundation.arrays import Flags, Floats

# Columns of a smoothed course behind those of world.state.state: the random force of the water [N, N, N, N m; world].
FORCE_X, FORCE_Y, FORCE_Z, YAW_MOMENT = range(8, 12)
COURSE_SIZE = 12


@dataclass(frozen=True)
class Pass:
    """Results of a pass of the filter: arrays (m,) by reading in the order of the timeline, gain (m, HORIZONTAL).

    innovation: reading less prediction, in the unit of the reading; variance: that of the innovation; log_likelihood:
    of all readings [nats], minus infinity where the model's state is no number any more. A gain fills the first columns
    of its row where its reading is of the vertical block, which is smaller (terms.blocks).
    """

    innovation: Floats
    variance: Floats
    gain: Floats
    believed: Flags  # innovations within the gate
    log_likelihood: float


@dataclass(frozen=True)
class Smoothed:
    """The smoothed course of a track: time (points,) [s]; mean and standard deviation (points, COURSE_SIZE).

    Columns: x y z [m; world], yaw [rad], u v w [m/s; body], r [rad/s], then the random force of the water
    [N, N, N, N m; world].
    """

    time: Floats
    mean: Floats
    spread: Floats
