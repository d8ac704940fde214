"""Velocity from a table over x, y, z and time: linear in each (trilinear in space).

Outside the table the value at its nearest edge holds, in space and in time: water does not stop where data end.
The numbers lie in one row: sizes nt, nz, ny, nx; then the axes t [s], z, y, x [m; world], ascending; then the
velocities [m/s; world] of shape (nt, nz, ny, nx, 3), last index fastest. An axis of one value is constant.
Assumes: what the linear interpolation of a divergence-free table leaves of divergence is small.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.water.current import Current

AXES = 4  # numbers before those of the first axis


@kernel
def _sizes(numbers: Floats) -> tuple[int, int, int, int]:
    """How many values the axes t, z, y, x have."""
    nt, nz, ny, nx = unpack(numbers, AXES)
    return int(nt), int(nz), int(ny), int(nx)


@kernel
def _bracket(numbers: Floats, first: int, size: int, value: float) -> tuple[int, float]:
    """The interval of the axis `numbers[first : first + size]` that holds `value`, and how far into it (0 to 1)."""
    if size == 1 or value <= numbers[first]:
        return 0, 0.0
    if value >= numbers[first + size - 1]:
        return size - 2, 1.0
    low, high = 0, size - 1
    while high - low > 1:
        middle = (low + high) // 2
        if numbers[first + middle] <= value:
            low = middle
        else:
            high = middle
    start = numbers[first + low]
    return low, (value - start) / (numbers[first + high] - start)


@kernel
def interpolate(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add to `total` (width,) the numbers, `width` at each place, of a table that is laid out as above."""
    width = total.shape[0]
    nt, nz, ny, nx = _sizes(parameters)
    t, at = _bracket(parameters, AXES, nt, time)
    z, az = _bracket(parameters, AXES + nt, nz, place[2])
    y, ay = _bracket(parameters, AXES + nt + nz, ny, place[1])
    x, ax = _bracket(parameters, AXES + nt + nz + ny, nx, place[0])
    table = AXES + nt + nz + ny + nx
    for corner in range(16):
        dt, dz, dy, dx = corner >> 3, (corner >> 2) & 1, (corner >> 1) & 1, corner & 1
        weight = (
            (at if dt else 1.0 - at) * (az if dz else 1.0 - az) * (ay if dy else 1.0 - ay) * (ax if dx else 1.0 - ax)
        )
        if weight == 0.0:
            continue
        cell = table + width * ((((t + dt) * nz + z + dz) * ny + y + dy) * nx + x + dx)
        for axis in range(width):
            total[axis] += weight * parameters[cell + axis]


@kernel
def gridded(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the interpolated velocity."""
    interpolate(place, time, parameters, total)


def fastest(parameters: Floats, size: tuple[float, float, float]) -> float:
    """The largest speed [m/s] in the table: interpolation stays between its values."""
    counts = parameters[:AXES].astype(int)
    velocities = parameters[AXES + counts.sum() :].reshape(-1, 3)
    return float(np.sqrt((velocities**2).sum(axis=1)).max())


GRIDDED = Current(summary="velocity from a netCDF file", velocity=gridded, parameters=(), fastest=fastest)
