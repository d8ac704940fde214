"""Cold spots that are alive, listed by the slabs of water into which they reach.

A slab's list is one stretch of memory, youngest spots first, those of one step in the order in which they were drawn:
new ones are put before the others, and the oldest fall off at the end.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import kernel

LANES = 4  # of the stretches at which a spot pulls, see pulls
TABLE = 64  # 16 cases of a wall, four of them for z and x each, times slabs south, beside, north, one unused
STEPS = 1 << 40  # an entry is the row of its step times this, plus its code


class Spots(NamedTuple):
    """The spots that are alive."""

    number: Integers  # (lifetime,) by the step in which they appeared; rows are used in turn
    strength: Floats  # (lifetime,) [N] by age
    shape: Integers  # (3,) of the water: ny slabs of nz rows with room for so many patches
    reached: NDArray[np.uint64]  # (ny, room) the list of each slab
    first: Integers  # (ny,) where it begins
    last: Integers  # (ny,) and ends
    arrived: Integers  # (lifetime, ny) how many entries each step made in each slab


@kernel
def _case_along_x(i: int, width: int) -> int:
    if i == width - 1:
        return 3
    return 2 if i == width - 2 else (0 if i == 0 else 1)


@kernel
def _case_along_z(k: int, nz: int) -> int:
    if nz == 1:
        return 3
    return 0 if k == 0 else (2 if k == nz - 1 else 1)


@kernel
def _code_of(place: Integers, y: int, shape: Integers) -> int:
    """One number for a spot that reaches into slab `y`: TABLE times where its middle stretch begins, plus its case."""
    nz, width, k, i = shape[1], shape[2], place[0], place[2]
    begin = max(min(i - 1, width - LANES), 0)
    case: int = 16 * _case_along_z(k, nz) + 4 * _case_along_x(i, width) + y - place[1] + 1
    code: int = TABLE * (k * width + begin) + case
    return code


@kernel
def make_way(spots: Spots, row: int, places: Integers) -> int:
    """Let go of the spots of a row of steps and count for it those at `places` (n, 3) z, y, x.

    Returns how long the longest list becomes.
    """
    ny, longest = spots.shape[0], 0
    for y in range(ny):
        spots.last[y] -= spots.arrived[row, y]
        spots.arrived[row, y] = 0
    for spot in range(places.shape[0]):
        for y in range(max(places[spot, 1] - 1, 0), min(places[spot, 1] + 2, ny)):
            spots.arrived[row, y] += 1
    for y in range(ny):
        longest = max(longest, spots.last[y] - spots.first[y] + spots.arrived[row, y])
    return longest


@kernel
def put_in_front(spots: Spots, row: int, places: Integers) -> None:
    """Put the spots that `make_way` has counted, and for which there is room, before the others."""
    ny = spots.shape[0]
    for y in range(ny):
        if spots.first[y] < spots.arrived[row, y]:
            _move_to_end(spots, y)
    for spot in range(places.shape[0] - 1, -1, -1):
        place = places[spot]
        for y in range(max(place[1] - 1, 0), min(place[1] + 2, ny)):
            spots.first[y] -= 1
            spots.reached[y, spots.first[y]] = row * STEPS + _code_of(place, y, spots.shape)
    spots.number[row] = places.shape[0]


@kernel
def _move_to_end(spots: Spots, y: int) -> None:
    """Move a list to the end of its room, from behind so that nothing is written over."""
    alive, end = spots.last[y] - spots.first[y], spots.reached.shape[1]
    for place in range(1, alive + 1):
        spots.reached[y, end - place] = spots.reached[y, spots.last[y] - place]
    spots.first[y], spots.last[y] = end - alive, end
