"""Diffusion and decay of forces in one pass: F <- keep F + share * (sum over the 27 patches around, itself included).

Both forms of the paper's equation are of this kind, with n the patches of the 27 that are water:
  paper_equation_5  dF = ((1 - kappa) mean of the n - 1 neighbours - kappa F) gamma
  released          F <- gamma ((1 - kappa) F + kappa mean of all n)
Source: Read et al. 2013, equation (5) with its footnote 4 (fewer neighbours at the boundary).
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.force_currents import ForceCurrents

BLOCK = 27


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


def spreading_scratch(shape: tuple[int, int, int]) -> tuple[Floats, Floats]:
    """Room for `spread` on a field of shape (nz, ny, nx): four planes of sums, and both ends of every row."""
    _, ny, nx = shape
    return np.zeros((4, ny * nx)), np.zeros((2, ny))


# All long loops run over whole planes, not rows of a few dozen patches, and over slices that begin at zero: that is
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
def _column_sums(plane: Floats, nx: int, sums: Floats) -> None:
    """Write the sum of every patch of `plane` (ny * nx,) and its two neighbours in y into `sums`."""
    size = plane.shape[0]
    if size == nx:
        for p in range(size):
            sums[p] = plane[p]
        return
    _sum_of_two(plane[nx : 2 * nx], plane[:nx], sums[:nx])
    _sum_of_three(plane[: size - 2 * nx], plane[2 * nx :], plane[nx : size - nx], sums[nx : size - nx])
    _sum_of_two(plane[size - 2 * nx : size - nx], plane[size - nx :], sums[size - nx :])


@kernel
def _mix(patches: Floats, sums: Floats, keep: float, share: float) -> None:
    """Replace `patches` (n,) by keep * patches + share * (block sums); `sums` (n + 2,) has one more at each end."""
    left, right, here = sums[:-2], sums[2:], sums[1:-1]
    for p in range(patches.shape[0]):
        patches[p] = keep * patches[p] + share * ((left[p] + right[p]) + here[p])


@kernel
def _present(index: int, size: int) -> int:
    """How many of a patch and its two neighbours along an axis are water."""
    return min(index + 1, size - 1) - max(index - 1, 0) + 1


@kernel
def _row_ends(plane: Floats, sums: Floats, weights: Floats, rows: int, ends: Floats) -> None:
    """Write what the first and the last patch of every row become; `rows`: planes that are water around this one."""
    ny = ends.shape[1]
    nx = plane.shape[0] // ny
    for y in range(ny):
        n = rows * _present(y, ny) * _present(0, nx)
        for end in range(2):
            p = y * nx + end * (nx - 1)
            total = sums[p]
            if nx > 1:
                total = sums[p + 1 - 2 * end] + total
            ends[end, y] = weights[0, n] * plane[p] + weights[1, n] * total


@kernel
def _mix_plane(plane: Floats, sums: Floats, weights: Floats, rows: int, ends: Floats) -> None:
    """Let one plane (ny * nx,) diffuse and decay; `sums`: over the nine patches in y and z around each."""
    ny = ends.shape[1]
    nx = plane.shape[0] // ny
    _row_ends(plane, sums, weights, rows, ends)
    if nx > 2:
        last = (ny - 1) * nx
        n = rows * _present(0, ny) * 3
        _mix(plane[1 : nx - 1], sums[:nx], weights[0, n], weights[1, n])
        if ny > 1:
            _mix(plane[last + 1 : last + nx - 1], sums[last:], weights[0, n], weights[1, n])
        if ny > 2:
            n = rows * 9
            # Across the ends of rows too: they are put right below.
            _mix(plane[nx:last], sums[nx - 1 : last + 1], weights[0, n], weights[1, n])
    for y in range(ny):
        plane[y * nx] = ends[0, y]
        plane[y * nx + nx - 1] = ends[1, y]


@kernel
def begin_spreading(water: Floats, nx: int, planes: Floats) -> None:
    """Get ready to let the planes of `water` (nz, ny * nx) spread one after the other, from below."""
    _column_sums(water[0], nx, planes[0])


@kernel
def spread_plane(water: Floats, z: int, weights: Floats, planes: Floats, ends: Floats) -> None:
    """Let plane `z` of `water` (nz, ny * nx) diffuse and decay by one step, in place; those below have done so."""
    nz, nine = water.shape[0], planes[3]
    here, above, below = planes[z % 3], planes[(z + 1) % 3], planes[(z + 2) % 3]
    if z + 1 < nz:
        _column_sums(water[z + 1], water.shape[1] // ends.shape[1], above)
    if z > 0 and z + 1 < nz:
        _sum_of_three(below, above, here, nine)
    elif z > 0:
        _sum_of_two(below, here, nine)
    elif nz > 1:
        _sum_of_two(above, here, nine)
    else:
        for p in range(nine.shape[0]):
            nine[p] = here[p]
    _mix_plane(water[z], nine, weights, _present(z, nz), ends)


@kernel
def spread(field: Floats, weights: Floats, planes: Floats, ends: Floats) -> None:
    """Let one component `field` (nz, ny, nx) diffuse and decay by one step, in place.

    Every patch is read once and written once; only sums of three planes are kept.
    """
    nz, ny, nx = field.shape
    water = field.reshape(nz, ny * nx)
    begin_spreading(water, nx, planes)
    for z in range(nz):
        spread_plane(water, z, weights, planes, ends)
