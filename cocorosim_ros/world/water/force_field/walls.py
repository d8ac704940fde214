"""What happens to force that points into a wall: with `redirected` it flows along the wall, away from the patch.

Its strength is shared equally by those of the four neighbours along the wall that are water (a quarter each; a third
or a half at edges and corners), each pushed away from the patch. All walls at once: what one wall redirects is not
redirected by another in the same step.
Source: behaviour of the authors' released model; the paper says nothing about it.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel


def wall_scratch(shape: tuple[int, int, int]) -> Floats:
    """Room (6, longest * next longest side) for what flows into each wall of a field of shape (nz, ny, nx)."""
    ordered = sorted(shape)
    return np.zeros((6, ordered[1] * ordered[2]))


@kernel
def _take(layer: Floats, sign: float, taken: Floats) -> None:
    """Move what flows into the wall (the way `sign` points) out of `layer` (rows, columns) into `taken`."""
    rows, columns = layer.shape
    for row in range(rows):
        for column in range(columns):
            strength = max(sign * layer[row, column], 0.0)
            taken[row * columns + column] = strength
            if strength > 0.0:
                layer[row, column] = 0.0


@kernel
def _share(taken: Floats, along_rows: Floats, along_columns: Floats) -> None:
    """Push the neighbours of each patch of the wall away from it.

    The layers (rows, columns) hold the components that point along increasing row and along increasing column.
    """
    rows, columns = along_rows.shape
    for row in range(rows):
        for column in range(columns):
            strength = taken[row * columns + column]
            if strength == 0.0:
                continue
            there = (row > 0) + (row < rows - 1) + (column > 0) + (column < columns - 1)
            part = strength / max(there, 1)
            if row > 0:
                along_rows[row - 1, column] -= part
            if row < rows - 1:
                along_rows[row + 1, column] += part
            if column > 0:
                along_columns[row, column - 1] -= part
            if column < columns - 1:
                along_columns[row, column + 1] += part


@kernel
def redirect_at_walls(field: Floats, taken: Floats) -> None:
    """Turn what points into walls, floor and surface along them; `field` (3, nz, ny, nx), components x, y, z."""
    for side in range(2):
        sign, end = (1.0, -1) if side else (-1.0, 0)
        _take(field[0, :, :, end], sign, taken[side])
        _take(field[1, :, end, :], sign, taken[2 + side])
        _take(field[2, end, :, :], sign, taken[4 + side])
    for side in range(2):
        end = -1 if side else 0
        _share(taken[side], field[2, :, :, end], field[1, :, :, end])
        _share(taken[2 + side], field[2, :, end, :], field[0, :, end, :])
        _share(taken[4 + side], field[1, end, :, :], field[0, end, :, :])
