"""Diffusion and decay of forces in one pass: F <- keep F + share * (sum over the 27 patches around, itself included).

Both forms of the paper's equation are of this kind, with n the patches of the 27 that are water:
  paper_equation_5  dF = ((1 - kappa) mean of the n - 1 neighbours - kappa F) gamma
  released          F <- gamma ((1 - kappa) F + kappa mean of all n)
Source: Read et al. 2013, equation (5) with its footnote 4 (fewer neighbours at the boundary).
"""

from __future__ import annotations

from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES, four, four_at, put_four_at
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.shuffled import lanes_after, lanes_before
from cocorosim_ros.foundation.compiling.stack import fetch_ahead
from cocorosim_ros.world.water.force_field.parts_of_water import Spreading
from cocorosim_ros.world.water.force_field.stored_water import LINE

FETCHED = 2  # lines of the cache ahead: rows of large water are further apart than a processor looks by itself

# Neighbours are added first, the patch between them last: mirrored water then gives mirrored sums to the last bit.
# Beyond the water stand zeros, which change no sum.


@kernel
def _sum_along_y(south: Floats, here: Floats, north: Floats, at: int) -> Any:
    """Four patches of a slab from `at` on, each with its two neighbours in y."""
    return (four_at(south, at) + four_at(north, at)) + four_at(here, at)


@kernel
def _sum_along_y_and_z(south: Floats, here: Floats, north: Floats, width: int, sums: Floats) -> None:
    """Write the sums over the nine patches in y and z around each of a slab into `sums`.

    Column after column, upwards, each as wide as a line of the cache: what two rows share stays in registers.
    """
    rows = here.shape[0] // width
    for x in range(0, width, LINE):
        nothing = four(0.0, 0.0, 0.0, 0.0)
        left_below, left = nothing, _sum_along_y(south, here, north, x)
        right_below, right = nothing, _sum_along_y(south, here, north, x + LANES)
        p = x
        for _ in range(rows - 1):
            above = p + width
            fetch_ahead(north, above + FETCHED * LINE)
            left_above = _sum_along_y(south, here, north, above)
            right_above = _sum_along_y(south, here, north, above + LANES)
            put_four_at(sums, p, (left_below + left_above) + left)
            put_four_at(sums, p + LANES, (right_below + right_above) + right)
            left_below, left, right_below, right = left, left_above, right, right_above
            p = above
        put_four_at(sums, p, left_below + left)
        put_four_at(sums, p + LANES, right_below + right)


@kernel
def _present(index: int, size: int) -> int:
    """How many of a patch and its two neighbours along an axis are water."""
    return min(index + 1, size - 1) - max(index - 1, 0) + 1


@kernel
def _mix_slab(slab: Floats, before: Floats, spreading: Spreading, slabs: int) -> None:
    """Let one slab diffuse and decay and keep it in `before` as it was.

    `spreading.sums`: over the nine patches in y and z around each, which lie in `slabs` slabs.
    """
    keeps, shares, sums, rows = spreading.keep, spreading.share, spreading.sums, spreading.rows
    width = slab.shape[0] // rows
    left, here = four(0.0, 0.0, 0.0, 0.0), four_at(sums, 0)
    for row in range(rows):
        present = _present(row, rows)
        keep, share = keeps[slabs - 1, present - 1], shares[slabs - 1, present - 1]
        for x in range(0, width, LANES):
            p = row * width + x
            right, old = four_at(sums, p + LANES), four_at(slab, p)
            around = (lanes_before(left, here) + lanes_after(here, right)) + here
            put_four_at(before, p, old)
            put_four_at(slab, p, four_at(keep, x) * old + four_at(share, x) * around)
            left, here = here, right


@kernel
def spread_slab(water: Floats, y: int, component: int, spreading: Spreading) -> None:
    """Let slab `y` of one component `water` (ny, slab) diffuse and decay by one step, in place.

    The slabs of the part before it have done so. Every patch is written once; only the slab before and sums of this
    one are kept.
    """
    slab, before = water[y], spreading.before[component]
    beyond = spreading.beyond[component] if y + 1 == spreading.last else water[y + 1]
    _sum_along_y_and_z(before, slab, beyond, water.shape[1] // spreading.rows, spreading.sums)
    _mix_slab(slab, before, spreading, _present(y, water.shape[0]))
