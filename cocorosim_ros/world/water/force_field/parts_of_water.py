"""Water in parts, each a number of slabs, through which threads go side by side.

What a part becomes depends on the slabs beside it as they were: these are kept before any part begins, so that neither
the number of parts nor their order changes a bit.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.force_currents import ForceCurrents
from cocorosim_ros.world.water.force_field.stored_water import aligned_zeros, row_width
from cocorosim_ros.world.water.patches import Patches

BLOCK = 27


class Spreading(NamedTuple):
    """What the slabs from `first` to before `last` spread with, of water of `nx` patches in a row."""

    first: int
    last: int
    nx: int
    weights: Floats  # (2, 28), see spreading_weights
    before: Floats  # (3, slab) of each component the slab before the present one, as it was
    beyond: Floats  # (3, slab) the slab `last`, as it was
    sums: Floats  # (2, slab) over three patches in y, and over nine in y and z
    ends: Floats  # (2, nz) of every row


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


def spreading_parts(forces: ForceCurrents, patches: Patches, parts: int) -> list[Spreading]:
    """What so many parts of the water spread with, each for itself."""
    weights, slab = spreading_weights(forces), patches.nz * row_width(patches.nx)
    edges = [patches.ny * part // parts for part in range(parts + 1)]
    return [
        Spreading(
            first,
            last,
            patches.nx,
            weights,
            before=aligned_zeros((3, slab)),
            beyond=aligned_zeros((3, slab)),
            sums=aligned_zeros((2, slab)),
            ends=np.zeros((2, patches.nz)),
        )
        for first, last in pairwise(edges)
    ]


@kernel
def keep_edges(water: Floats, spreading: Spreading) -> None:
    """Keep the slabs beside a part of `water` (3, ny, slab) as they are, before the other parts change them."""
    for component in range(3):
        for p in range(water.shape[2]):
            if spreading.first > 0:
                spreading.before[component, p] = water[component, spreading.first - 1, p]
            if spreading.last < water.shape[1]:
                spreading.beyond[component, p] = water[component, spreading.last, p]
