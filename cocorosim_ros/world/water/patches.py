"""Water cut into cubes: which patch is where."""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel


class Patches(NamedTuple):
    """Cubes of water that fill the tank; arrays over them have the shape (nz, ny, nx), x fastest."""

    lower: Floats  # (3,) lowest corner of the tank [m; world]
    side: float  # of a patch [m]
    nx: int
    ny: int
    nz: int

    @property
    def shape(self) -> tuple[int, int, int]:
        """Shape of an array over all patches."""
        return self.nz, self.ny, self.nx

    @property
    def total(self) -> int:
        """How many patches there are."""
        return self.nx * self.ny * self.nz


@kernel
def patch_at(patches: Patches, x: float, y: float, z: float) -> tuple[int, int, int]:
    """Indices (z, y, x) of the patch around a place [m; world]; beyond the water they lie outside of the array."""
    return (
        math.floor((z - patches.lower[2]) / patches.side),
        math.floor((y - patches.lower[1]) / patches.side),
        math.floor((x - patches.lower[0]) / patches.side),
    )


@kernel
def nearest_patch(patches: Patches, x: float, y: float, z: float) -> tuple[int, int, int]:
    """As `patch_at`, but a place on the far walls or the surface belongs to the last patch."""
    k, j, i = patch_at(patches, x, y, z)
    return min(max(k, 0), patches.nz - 1), min(max(j, 0), patches.ny - 1), min(max(i, 0), patches.nx - 1)


@kernel
def is_water(patches: Patches, k: int, j: int, i: int) -> bool:
    """Whether indices (z, y, x) are those of a patch."""
    return 0 <= k < patches.nz and 0 <= j < patches.ny and 0 <= i < patches.nx
