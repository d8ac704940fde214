"""Diffusion and decay of forces in one pass: F <- keep F + share * (sum over the 27 patches around, itself included).

Both forms of the paper's equation are of this kind, with n the patches of the 27 that are water:
  paper_equation_5  dF = ((1 - kappa) mean of the n - 1 neighbours - kappa F) gamma
  released          F <- gamma ((1 - kappa) F + kappa mean of all n)
Source: Read et al. 2013, equation (5) with its footnote 4 (fewer neighbours at the boundary).
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.water.force_field.parts_of_water import Spreading

# All long loops run over whole slabs, not rows of a few dozen patches, and over slices that begin at zero: that is
# what the compiler turns into vector instructions. Neighbours are added first: mirrored water then gives mirrored
# sums to the last bit.


@kernel
def _sum_of_three(one: Floats, other: Floats, middle: Floats, sums: Floats) -> None:
    """Write (one + other) + middle, element by element."""
    for p in range(sums.shape[0]):
        sums[p] = (one[p] + other[p]) + middle[p]


@kernel
def _sum_of_two(one: Floats, other: Floats, sums: Floats) -> None:
    """Write one + other, element by element."""
    for p in range(sums.shape[0]):
        sums[p] = one[p] + other[p]


@kernel
def _sum_along_y(water: Floats, y: int, component: int, spreading: Spreading, sums: Floats) -> None:
    """Write the sum of every patch of slab `y` of `water` (ny, slab) and its two neighbours in y into `sums`."""
    south, here = spreading.before[component], water[y]
    if water.shape[0] == 1:
        for p in range(sums.shape[0]):
            sums[p] = here[p]
        return
    if y + 1 == water.shape[0]:
        _sum_of_two(south, here, sums)
        return
    north = spreading.beyond[component] if y + 1 == spreading.last else water[y + 1]
    if y == 0:
        _sum_of_two(north, here, sums)
    else:
        _sum_of_three(south, north, here, sums)


@kernel
def _sum_along_z(columns: Floats, width: int, sums: Floats) -> None:
    """Write the sum of every element of `columns` (slab,) and its two neighbours in z into `sums`."""
    size = columns.shape[0]
    if size == width:
        for p in range(size):
            sums[p] = columns[p]
        return
    _sum_of_two(columns[width : 2 * width], columns[:width], sums[:width])
    _sum_of_three(columns[: size - 2 * width], columns[2 * width :], columns[width:-width], sums[width:-width])
    _sum_of_two(columns[size - 2 * width : size - width], columns[size - width :], sums[size - width :])


@kernel
def _mix(patches: Floats, before: Floats, sums: Floats, keep: float, share: float) -> None:
    """Replace `patches` (n,), which are kept in `before`, by keep * patches + share * (block sums).

    `sums` (n + 2,) has one more at each end.
    """
    left, right, here = sums[:-2], sums[2:], sums[1:-1]
    for p in range(patches.shape[0]):
        old = patches[p]
        before[p] = old
        patches[p] = keep * old + share * ((left[p] + right[p]) + here[p])


@kernel
def _present(index: int, size: int) -> int:
    """How many of a patch and its two neighbours along an axis are water."""
    return min(index + 1, size - 1) - max(index - 1, 0) + 1


@kernel
def _row_ends(slab: Floats, before: Floats, sums: Floats, spreading: Spreading, slabs: int) -> None:
    """Write what the first and the last patch of every row become; keep them in `before`."""
    ends, nx, nz = spreading.ends, spreading.nx, spreading.ends.shape[1]
    width = slab.shape[0] // nz
    for z in range(nz):
        n = slabs * _present(z, nz) * _present(0, nx)
        for end in range(2):
            p = z * width + end * (nx - 1)
            total = sums[p]
            if nx > 1:
                total = sums[p + 1 - 2 * end] + total
            before[p] = slab[p]
            ends[end, z] = spreading.weights[0, n] * slab[p] + spreading.weights[1, n] * total


@kernel
def _mix_slab(slab: Floats, before: Floats, sums: Floats, spreading: Spreading, slabs: int) -> None:
    """Let one slab diffuse and decay; `sums`: over the nine patches in y and z around each."""
    ends, weights, nz = spreading.ends, spreading.weights, spreading.ends.shape[1]
    width = slab.shape[0] // nz
    last = (nz - 1) * width
    _row_ends(slab, before, sums, spreading, slabs)
    n = slabs * _present(0, nz) * 3
    _mix(slab[1 : width - 1], before[1 : width - 1], sums[:width], weights[0, n], weights[1, n])
    if nz > 1:
        _mix(slab[last + 1 : -1], before[last + 1 : -1], sums[last:], weights[0, n], weights[1, n])
    if nz > 2:
        n = slabs * 9
        # Across the ends of rows too: they are put right below.
        _mix(slab[width:last], before[width:last], sums[width - 1 : last + 1], weights[0, n], weights[1, n])
    for z in range(nz):
        slab[z * width] = ends[0, z]
        slab[z * width + spreading.nx - 1] = ends[1, z]


@kernel
def spread_slab(water: Floats, y: int, component: int, spreading: Spreading) -> None:
    """Let slab `y` of one component `water` (ny, slab) diffuse and decay by one step, in place.

    The slabs of the part before it have done so. Every patch is read once and written once; only the slab before and
    sums of this one are kept.
    """
    before, columns, nine = spreading.before[component], spreading.sums[0], spreading.sums[1]
    _sum_along_y(water, y, component, spreading, columns)
    _sum_along_z(columns, water.shape[1] // spreading.ends.shape[1], nine)
    _mix_slab(water[y], before, nine, spreading, _present(y, water.shape[0]))
