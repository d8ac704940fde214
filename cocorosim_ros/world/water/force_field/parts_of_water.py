"""Water in parts, each a number of slabs, through which threads go side by side.

What a part becomes depends on the slabs beside it as they were: these are kept before any part begins, so that neither
the number of parts nor their order changes a bit.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.force_currents import ForceCurrents
from cocorosim_ros.world.water.force_field.stored_water import aligned_zeros, row_width
from cocorosim_ros.world.water.patches import Patches

BLOCK = 27


class Spreading(NamedTuple):
    """What the slabs from `first` to before `last` spread with, of water of `rows` rows of patches in each slab."""

    first: int
    last: int
    rows: int
    keep: Floats  # (3, 3, row width) of a patch; by how many of it and its two neighbours in y, and in z, are water
    share: Floats  # (3, 3, row width) of the sum over the block of 27
    before: Floats  # (3, slab) of each component the slab before the present one, as it was; zero beyond the water
    beyond: Floats  # (3, slab) the slab `last`, as it was; zero beyond the water
    sums: Floats  # (slab + LANES,) over nine patches in y and z; zeros at the end


def spreading_weights(forces: ForceCurrents) -> Floats:
    """(2, 28) keep and share of a patch by how many patches of its block of 27 are water."""
    kappa, gamma = forces.diffusion_rate, forces.decay_rate
    weights = np.zeros((2, BLOCK + 1))
    for n in range(1, BLOCK + 1):
        if forces.diffusion == "released":
            weights[:, n] = gamma * (1.0 - kappa), gamma * kappa / n
        else:
            share = gamma * (1.0 - kappa) / (n - 1) if n > 1 else 0.0
            weights[:, n] = 1.0 - gamma * kappa - share, share
    return weights


def weights_of_rows(weights: Floats, nx: int) -> Floats:
    """(2, 3, 3, row width) keep and share along a row of `nx` patches of a slab with one, two or three of y and of z.

    `weights` (2, 28): see spreading_weights. The void after a row keeps nothing and gets nothing.
    """
    along = np.minimum(np.arange(nx) + 1, nx - 1) - np.maximum(np.arange(nx) - 1, 0) + 1
    present = np.arange(1, 4)
    of_rows = aligned_zeros((2, 3, 3, row_width(nx)))
    of_rows[..., :nx] = weights[:, present[:, None, None] * present[:, None] * along]
    return of_rows


def spreading_parts(forces: ForceCurrents, patches: Patches, parts: int) -> list[Spreading]:
    """What so many parts of the water spread with, each for itself."""
    slab = patches.nz * row_width(patches.nx)
    keep, share = weights_of_rows(spreading_weights(forces), patches.nx)
    edges = [patches.ny * part // parts for part in range(parts + 1)]
    return [
        Spreading(
            first,
            last,
            patches.nz,
            keep,
            share,
            before=aligned_zeros((3, slab)),
            beyond=aligned_zeros((3, slab)),
            sums=aligned_zeros((slab + LANES,)),
        )
        for first, last in pairwise(edges)
    ]


@kernel
def keep_edges(water: Floats, spreading: Spreading) -> None:
    """Keep the slabs beside a part of `water` (3, ny, slab) as they are, before the other parts change them."""
    for component in range(3):
        for p in range(water.shape[2]):
            south = water[component, spreading.first - 1, p] if spreading.first > 0 else 0.0
            spreading.before[component, p] = south
            if spreading.last < water.shape[1]:
                spreading.beyond[component, p] = water[component, spreading.last, p]
