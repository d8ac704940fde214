"""The pull of cold spots on the water around them, slab by slab.

Every patch gets the pulls in the same order, however the water is gone through: of younger spots first, of those of one
step in the order in which they were drawn.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.stack import add_four
from cocorosim_ros.world.water.force_field.arriving import LANES, STEPS, TABLE, Spots

# A spot pulls at 3 x 3 patches of a slab: three stretches of four, one of them with weight zero. At walls they begin
# elsewhere so as to stay in the water: four cases along x (first column, between, last but one, last) and four along z
# (first row, between, last, the only one), times three slabs.
ROWS = 3
COMPONENT = TABLE * ROWS * LANES  # weights of one component


class Pull(NamedTuple):
    """What a spot of unit strength adds to the patches around it."""

    weight: (
        Floats  # (3, 3, 3, 3) component x, y, z; then z, y, x of the patch, beginning below, before, left of the spot
    )


class Stretches(NamedTuple):
    """The pull by case: where the stretches begin, and their weights."""

    begin: NDArray[np.uint64]  # (TABLE * ROWS,) from the beginning of the middle one, modulo 2^64 for what lies before
    weight: Floats  # (3 * TABLE * ROWS * LANES,) by component


class Pulling(NamedTuple):
    """What cold spots do at a step."""

    spots: Spots
    strength: Floats  # (lifetime,) [N] of the spots of each row of steps
    stretches: Stretches


def strength_at(spots: Spots, step: int) -> Floats:
    """(lifetime,) the strength [N] at `step` of the spots of each row of steps; zero of those to come."""
    lifetime = len(spots.strength)
    age = np.arange(min(lifetime, step + 1))
    strength = np.zeros(lifetime)
    strength[(step - age) % lifetime] = spots.strength[age]
    return strength


@allocating_kernel
def stretches_of(pull: Pull, shape: Integers) -> Stretches:
    """The pull in water of a shape (slabs, rows, width of a row)."""
    begin, weight = np.zeros((TABLE, ROWS), np.uint64), np.zeros((3, TABLE, ROWS, LANES))
    for case in range(TABLE):
        upwards, along, north = case // 16, case // 4 % 4, case % 4
        for row in range(ROWS):
            if north > 2 or (row == 0 and upwards in (0, 3)) or (row == 2 and upwards in (2, 3)):
                continue  # no such case, or no water there: weights of zero for the middle stretch
            begin[case, row] = np.uint64((row - 1) * shape[2])
            for x in range(3):
                lane = x + (-1 if along == 0 else max(along - 1, 0))
                if 0 <= lane < LANES:
                    for component in range(3):
                        weight[component, case, row, lane] = pull.weight[component, row, north, x]
    return Stretches(begin.reshape(TABLE * ROWS), weight.reshape(3 * TABLE * ROWS * LANES))


@kernel
def pull_slab(water: Floats, y: int, pulling: Pulling) -> None:
    """Add the forces of all spots to slab `y` of `water` (3, ny, slab) [N]."""
    spots, strengths, stretches = pulling
    east, north, up = water[0, y], water[1, y], water[2, y]
    for at in range(spots.first[y], spots.last[y]):
        entry = spots.reached[y, at]
        strength, code = strengths[entry // np.uint64(STEPS)], entry % np.uint64(STEPS)
        if strength == 0.0:
            continue
        place, first = code // np.uint64(TABLE), code % np.uint64(TABLE) * np.uint64(ROWS)
        for row in range(ROWS):
            here = place + stretches.begin[first + np.uint64(row)]
            weights = (first + np.uint64(row)) * np.uint64(LANES)
            add_four(east, here, stretches.weight, weights, strength)
            add_four(north, here, stretches.weight, weights + np.uint64(COMPONENT), strength)
            if row != 1:  # at the height of a spot nothing is pulled up or down
                add_four(up, here, stretches.weight, weights + np.uint64(2 * COMPONENT), strength)


@kernel
def pull_water(water: Floats, pulling: Pulling) -> None:
    """Add the forces of all spots to `water` (3, ny, slab) [N]."""
    for y in range(water.shape[1]):
        pull_slab(water, y, pulling)
