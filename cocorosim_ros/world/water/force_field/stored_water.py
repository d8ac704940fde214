"""How the forces on patches lie in memory, so that a step goes through them once.

Slab by slab from south to north; a slab is all patches of one y, row above row. The sums over neighbours in y, which
are taken first, then need three slabs, and slabs of a shallow tank fit into the caches where planes of one depth do
not.
Rows are as long as whole lines of the cache, so that loops over a slab read aligned vectors, and have at least one
place more than patches. What lies beyond the last patch of a row is void and stays zero, so that the last patch of a
row and the first of the next find nothing beside them.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.water.patches import Patches

LINE = 8  # floats in a line of the cache


def row_width(nx: int) -> int:
    """How many floats a row of `nx` patches takes."""
    return (nx // LINE + 1) * LINE


def aligned_zeros(shape: tuple[int, ...]) -> Floats:
    """Zeros that begin where a line of the cache does."""
    size = math.prod(shape)
    room = np.zeros(size + LINE)
    first = -(room.ctypes.data // room.itemsize) % LINE
    return room[first : first + size].reshape(shape)


def still_water(patches: Patches) -> Floats:
    """(3, ny, nz * row width) forces of zero: components x, y, z of slabs."""
    return aligned_zeros((3, patches.ny, patches.nz * row_width(patches.nx)))


def by_place(water: Floats, patches: Patches) -> Floats:
    """The same forces as (3, nz, ny, nx); what is written there is written in `water`."""
    rows = water.reshape(3, patches.ny, patches.nz, row_width(patches.nx))
    return rows[..., : patches.nx].transpose(0, 2, 1, 3)
