"""Results of the filter for a track: passes and smoothed courses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

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

    def change_to(self, other: Pass, angles: Flags) -> Floats:
        """Change (m,) of the innovations to another pass, angles by the shorter way; 0 where not both are believed.

        angles (m,): flags of the readings that are angles.
        """
        change: Floats = other.innovation - self.innovation
        change[angles] -= 2.0 * np.pi * np.round(change[angles] / (2.0 * np.pi))
        change[~(self.believed & other.believed)] = 0.0
        return change


@dataclass(frozen=True)
class Smoothed:
    """The smoothed course of a track: time (points,) [s]; mean and standard deviation (points, COURSE_SIZE).

    Columns: x y z [m; world], yaw [rad], u v w [m/s; body], r [rad/s], then the random force of the water
    [N, N, N, N m; world].
    """

    time: Floats
    mean: Floats
    spread: Floats
