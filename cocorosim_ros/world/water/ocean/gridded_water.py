"""Fields of water on the axes t, z, y, x of the world, as they come out of a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.water.ocean.model_file import OceanFileError


@dataclass(frozen=True)
class GriddedWater:
    """Axes t [s since the start], z, y, x [m; world], ascending, and fields (nt, nz, ny, nx) by what they are.

    Fields: eastward, northward, upward [m/s; world], temperature [degC], salinity; NaN on land.
    """

    axes: tuple[Floats, Floats, Floats, Floats]
    fields: Mapping[str, Floats]

    def numbers(self, table: Floats) -> Floats:
        """The axes and a table (nt, nz, ny, nx, ...) as one row (water.currents.gridded)."""
        sizes = np.array([len(axis) for axis in self.axes], dtype=np.float64)
        return np.concatenate([sizes, *self.axes, table.ravel()])


def bracket(axis: Floats, low: float, high: float) -> slice:
    """The shortest part of an ascending axis that holds `low` and `high` between its ends, as far as there is one."""
    first = max(int(np.searchsorted(axis, low, "right")) - 1, 0)
    last = min(int(np.searchsorted(axis, high, "left")), len(axis) - 1)
    return slice(first, last + 1)


def check_covers(axis: Floats, low: float, high: float, up: str, down: str) -> None:
    """Nothing, if an ascending axis reaches from `low` to `high` [m]. Raises OceanFileError.

    up, down: which way goes up the axis, which down, in words.
    """
    for reaches, needed, way in ((high - axis[-1], high, up), (axis[0] - low, low, down)):
        if reaches > 0.0:
            raise OceanFileError(
                f"which ends {reaches:.4g} m before the tank does, {abs(needed):.4g} m {way} of the origin; take a "
                "larger cut-out, another origin, or a smaller tank."
            )
