"""The grid of ROMS: velocities between the points of density, levels that follow the floor, axes that are turned.

Depth of level s over a floor at h below a surface at zeta (Shchepetkin and McWilliams 2005, The regional oceanic
modeling system, Ocean Modelling 9, and ROMS's manual, "Vertical S-coordinate"):
Vtransform 1: z0 = hc (s - C) + h C, z = z0 + zeta (1 + z0 / h);
Vtransform 2: z0 = (hc s + h C) / (hc + h), z = zeta + (zeta + h) z0.
Eastward u cos(angle) - v sin(angle), northward u sin(angle) + v cos(angle).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.water.ocean.gridded_water import GriddedWater, check_covers
from cocorosim_ros.world.water.ocean.local_frame import LocalFrame
from cocorosim_ros.world.water.ocean.model_file import OceanFileError

_NEEDED = ("h", "s_rho", "Cs_r", "hc", "lon_rho", "lat_rho")


def level_heights(data: Any, h: Floats, zeta: Floats) -> Floats:
    """(nt, levels, ny, nx) z [m] of the levels over a floor `h` (ny, nx) and below a surface `zeta` (nt, ny, nx)."""
    s, stretch = (np.asarray(data[name].values, float)[None, :, None, None] for name in ("s_rho", "Cs_r"))
    critical, surface, floor = float(data["hc"]), zeta[:, None], h[None, None]
    if int(data["Vtransform"] if "Vtransform" in data else 2) == 1:
        unmoved = critical * (s - stretch) + floor * stretch
        return np.asarray(unmoved + surface * (1.0 + unmoved / floor))
    return np.asarray(surface + (surface + floor) * (critical * s + floor * stretch) / (critical + floor))


def at_density_points(data: Any, name: str) -> Floats:
    """A field (nt, levels, ny, nx) at the inner points of density, wherever it is kept."""
    field = data[name]
    values = np.asarray(field.values, dtype=np.float64)
    if values.ndim == 3:
        values = values[None]
    if "xi_u" in field.dims:
        return np.asarray(0.5 * (values[..., 1:-1, :-1] + values[..., 1:-1, 1:]))
    if "eta_v" in field.dims:
        return np.asarray(0.5 * (values[..., :-1, 1:-1] + values[..., 1:, 1:-1]))
    return values[..., 1:-1, 1:-1]


def roms_water(data: Any, names: dict[str, str], frame: LocalFrame, size: tuple[float, float, float]) -> GriddedWater:
    """The fields of a ROMS file on level axes around the origin; the first axis is a count of its moments.

    `names`: of the variables by what they are; vertical velocity is left out. `size` of the tank [m].
    """
    missing = [name for name in _NEEDED if name not in data.variables]
    if missing:
        raise OceanFileError(
            f"which has s-levels but no '{missing[0]}' to place them; take it from the model's grid file."
        )
    whole = {name: np.asarray(data[name].values, float)[1:-1, 1:-1] for name in ("h", "lon_rho", "lat_rho")}
    east, north = frame.east(whole["lon_rho"]), frame.north(whole["lat_rho"])
    fields = {what: at_density_points(data, name) for what, name in names.items() if what != "upward"}
    if "xi_u" in data[names["eastward"]].dims:
        fields["eastward"], fields["northward"] = _turned(data, fields["eastward"], fields["northward"])
    moments = fields["eastward"].shape[0]
    surface = np.asarray(data["zeta"].values, float) if "zeta" in data else np.zeros((1, *data["h"].shape))
    zeta = np.broadcast_to(surface.reshape(-1, *data["h"].shape)[:, 1:-1, 1:-1], (moments, *whole["h"].shape))
    near, spacing = _near(east, north, size)
    levels = level_heights(data, whole["h"], np.nan_to_num(zeta))[:, :, *near]
    z = np.linspace(-size[2], 0.0, max(2, levels.shape[1]))
    x, y = (np.linspace(-side / 2, side / 2, 2 + int(side / spacing)) for side in size[:2])
    check_covers(np.sort(east[near].ravel()), x[0], x[-1], "east", "west")
    check_covers(np.sort(north[near].ravel()), y[0], y[-1], "north", "south")
    flat = {what: _on_levels(field[:, :, *near], levels, whole["h"][near], z) for what, field in fields.items()}
    level = {what: _on_axes(field, east[near], north[near], x, y) for what, field in flat.items()}
    return GriddedWater((np.arange(float(moments)), z, y, x), level)


def _turned(data: Any, along: Floats, across: Floats) -> tuple[Floats, Floats]:
    """Velocities along the grid as eastward and northward ones."""
    angle = np.asarray(data["angle"].values, float)[1:-1, 1:-1] if "angle" in data else np.zeros(along.shape[-2:])
    sine, cosine = np.sin(angle), np.cos(angle)
    return np.asarray(along * cosine - across * sine), np.asarray(along * sine + across * cosine)


def _near(east: Floats, north: Floats, size: tuple[float, float, float]) -> tuple[tuple[slice, slice], float]:
    """Rows and columns of the grid that the tank touches, with two more around them, and the widest spacing [m]."""
    spacing = max(np.abs(np.diff(east, axis=1)).max(), np.abs(np.diff(north, axis=0)).max())
    spacing = max(spacing, np.abs(np.diff(east, axis=0)).max(), np.abs(np.diff(north, axis=1)).max())
    touched = (np.abs(east) <= size[0] / 2 + 2.0 * spacing) & (np.abs(north) <= size[1] / 2 + 2.0 * spacing)
    if not touched.any():
        raise OceanFileError(
            "which is nowhere near the origin; check 'latitude', 'longitude', or take another cut-out."
        )
    rows, columns = (np.flatnonzero(touched.any(axis=axis)) for axis in (1, 0))
    return (slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1)), float(spacing)


def _on_levels(field: Floats, levels: Floats, floor: Floats, z: Floats) -> Floats:
    """(nt, nz, ny, nx) a field at heights `z`: linear between its levels, held beyond, NaN below the floor."""
    out = np.full((field.shape[0], len(z), *field.shape[2:]), np.nan)
    for moment, row, column in np.ndindex(field.shape[0], *field.shape[2:]):
        values = np.interp(z, levels[moment, :, row, column], field[moment, :, row, column])
        out[moment, :, row, column] = np.where(z < -floor[row, column] - 1e-9, np.nan, values)
    return out


def _on_axes(field: Floats, east: Floats, north: Floats, x: Floats, y: Floats) -> Floats:
    """(nt, nz, ny, nx) a field on straight axes, linear within the triangles between the points of the grid."""
    from scipy.interpolate import LinearNDInterpolator  # noqa: PLC0415 (weighs much, for few)

    points = np.column_stack([east.ravel(), north.ravel()])
    moments, levels = field.shape[:2]
    values = np.moveaxis(field.reshape(moments * levels, -1), 0, 1)
    across, along = np.meshgrid(x, y)
    spread = LinearNDInterpolator(points, values)(across, along)
    return np.asarray(np.moveaxis(spread, -1, 0).reshape(moments, levels, len(y), len(x)))
