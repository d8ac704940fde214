"""From what is asked of the whole vehicle to what each of its actuators gives of it.

wrench = B f        B: one row for each axis that is commanded, one column for each thruster
f = pinv(B) wrench  the smallest forces that give it, as most mixers choose them
Source: Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2011), section 12.3, all weights equal.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.scenario.reading.entry import Entry


def wrench_of(thruster: Thruster) -> Floats:
    """(6,) force and moment per newton of a thruster [1, m; body]."""
    return np.concatenate([thruster.direction, np.cross(thruster.position, thruster.direction)])


def smallest_forces(matrix: Floats) -> Floats:
    """(thrusters, axes) the smallest forces of each thruster for one of each axis; matrix: B (axes, thrusters)."""
    return np.asarray(np.linalg.pinv(matrix))


def check_rank(matrix: Floats, axes: Sequence[str], place: Entry) -> None:
    """Nothing, if thrusters can give every axis by itself; matrix: B (axes, thrusters); place: the file's.

    Raises CocorosimError otherwise, and where there is no thruster.
    """
    rank = int(np.linalg.matrix_rank(matrix)) if matrix.size else 0
    if rank < len(axes):
        raise place.problem(
            f"gives an allocation matrix of rank {rank}, and {len(axes)} axes are commanded ({', '.join(axes)}): "
            f"these {matrix.shape[1]} thrusters cannot give each by itself; correct the thrusters, or leave out axes."
        )
