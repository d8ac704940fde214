"""The pull of cold spots on the water around them, plane by plane.

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

# A spot pulls at 3 x 3 patches of a plane: three stretches of four, one of them with weight zero. At walls they begin
# elsewhere so as to stay in the water: four cases along x (first column, between, last but one, last) and three along y
# (first row, between, last), times three planes.
ROWS, LANES = 3, 4
TABLE = 64  # 16 cases of a wall, four of them for y and x each, times planes below, beside, above, one unused


class Pull(NamedTuple):
    """What a spot of unit strength adds to the patches around it."""

    weight: (
        Floats  # (3, 3, 3, 3) component x, y, z; then z, y, x of the patch, beginning below, before, left of the spot
    )


class Spots(NamedTuple):
    """The spots that are alive, by the step in which they appeared; rows are used in turn."""

    place: Integers  # (lifetime, capacity, 3) z, y, x in patches
    number: Integers  # (lifetime,)
    strength: Floats  # (lifetime,) [N] by age
    shape: Integers  # (3,) of the water: nz, ny, nx
    reached: NDArray[np.uint64]  # (lifetime, 3 capacity) the spots that reach into each plane, see pulls
    start: Integers  # (lifetime, nz + 1) where those of each plane begin


@kernel
def _case_along_x(i: int, nx: int) -> int:
    if nx < LANES:
        return i
    if i == nx - 1:
        return 3
    return 2 if i == nx - 2 else (0 if i == 0 else 1)


@kernel
def _code_of(place: Integers, z: int, shape: Integers) -> int:
    """One number for a spot that reaches into plane `z`: TABLE times where its middle stretch begins, plus its case."""
    ny, nx, j, i = shape[1], shape[2], place[1], place[2]
    across = 0 if j == 0 else (2 if j == ny - 1 else 1)
    begin = max(min(i - 1, nx - LANES), 0)
    case: int = 16 * across + 4 * _case_along_x(i, nx) + z - place[0] + 1
    code: int = TABLE * (j * nx + begin) + case
    return code


@kernel
def list_by_plane(spots: Spots, row: int) -> None:
    """List the spots of one step by the planes into which they reach; within a plane they keep their order."""
    start, nz = spots.start[row], spots.shape[0]
    for z in range(nz + 1):
        start[z] = 0
    for spot in range(spots.number[row]):
        k = spots.place[row, spot, 0]
        for z in range(max(k - 1, 0), min(k + 2, nz)):
            start[z + 1] += 1
    for z in range(nz):
        start[z + 1] += start[z]
    end = start[nz]
    for spot in range(spots.number[row] - 1, -1, -1):
        # Filled from behind, the start of the next plane becomes the start of this one.
        place = spots.place[row, spot]
        for z in range(max(place[0] - 1, 0), min(place[0] + 2, nz)):
            start[z + 1] -= 1
            spots.reached[row, start[z + 1]] = _code_of(place, z, spots.shape)
    for z in range(nz):
        start[z] = start[z + 1]
    start[nz] = end


class Stretches(NamedTuple):
    """The pull by case: where the stretches begin, and their weights."""

    begin: NDArray[np.uint64]  # (TABLE * ROWS,) from the beginning of the middle one, modulo 2^64 for what lies before
    weight: Floats  # (3 * TABLE * ROWS * LANES,) by component


@allocating_kernel
def stretches_of(pull: Pull, shape: Integers) -> Stretches:
    """The pull in water of a shape (nz, ny, nx)."""
    begin, weight = np.zeros((TABLE, ROWS), np.uint64), np.zeros((3, TABLE, ROWS, LANES))
    for case in range(TABLE):
        across, along, above = case // 16, case // 4 % 4, case % 4
        for row in range(ROWS):
            if across > 2 or above > 2 or (row == 0 and across == 0) or (row == 2 and across == 2):
                continue  # no such case, or no water there: weights of zero for the middle stretch
            begin[case, row] = np.uint64((row - 1) * shape[2])
            for x in range(3):
                lane = x + (-1 if along == 0 else max(along - 1, 0))
                if 0 <= lane < LANES:
                    for component in range(3):
                        weight[component, case, row, lane] = pull.weight[component, above, row, x]
    return Stretches(begin.reshape(TABLE * ROWS), weight.reshape(3 * TABLE * ROWS * LANES))


@kernel
def pull_plane(plane: Floats, z: int, component: int, step: int, spots: Spots, stretches: Stretches) -> None:
    """Add the forces of all spots at `step` to one component in plane `z` (ny * nx,) [N]."""
    lifetime, wide = spots.number.shape[0], spots.shape[2] >= LANES
    for age in range(min(lifetime, step + 1)):
        cohort, strength = (step - age) % lifetime, spots.strength[age]
        if strength == 0.0:
            continue
        for at in range(spots.start[cohort, z], spots.start[cohort, z + 1]):
            code = spots.reached[cohort, at]
            place, first = code // np.uint64(TABLE), code % np.uint64(TABLE) * np.uint64(ROWS)
            weights = (np.uint64(component * TABLE * ROWS) + first) * np.uint64(LANES)
            for row in range(ROWS):
                here = place + stretches.begin[first + np.uint64(row)]
                pull = weights + np.uint64(row * LANES)
                if wide:
                    add_four(plane, here, stretches.weight, pull, strength)
                else:
                    for lane in range(spots.shape[2]):
                        plane[here + np.uint64(lane)] += strength * stretches.weight[pull + np.uint64(lane)]


@kernel
def pull_water(field: Floats, spots: Spots, step: int, stretches: Stretches) -> None:
    """Add the forces of all spots at `step` to `field` (3, nz, ny, nx) [N]."""
    for component in range(3):
        water = field[component].reshape(field.shape[1], field.shape[2] * field.shape[3])
        for z in range(field.shape[1]):
            pull_plane(water[z], z, component, step, spots, stretches)
