"""Small cut-outs as ocean models write them, with made-up numbers that are linear in place and time.

    .venv/bin/python test/world/water/ocean/made_up.py cmems FOLDER

East of the origin by x [m], north by y, at z and t seconds after 2024-05-01T12:00:
u = 0.1 + 1e-5 x - 2e-5 y + 1e-3 z + 1e-5 t [m/s],
v = -0.05 + 1e-5 y + 2e-5 x, temperature = 12 + 0.05 z, salinity = 35 - 0.02 z.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
import xarray

LATITUDE, LONGITUDE = 60.0, 5.0  # deg
START = "2024-05-01T12:00:00"
HOUR = 3600.0


def metres(latitude: Any, longitude: Any) -> tuple[Any, Any]:
    """East and north of the origin, by the radii of curvature of the ellipsoid WGS 84 (a, f of its definition)."""
    flattening = 1.0 / 298.257223563
    squared = flattening * (2.0 - flattening)
    sine = math.sin(math.radians(LATITUDE))
    across = 6_378_137.0 / math.sqrt(1.0 - squared * sine**2)
    along = across * (1.0 - squared) / (1.0 - squared * sine**2)
    return (
        across * math.cos(math.radians(LATITUDE)) * np.radians(np.asarray(longitude) - LONGITUDE),
        along * np.radians(np.asarray(latitude) - LATITUDE),
    )


def truth(x: Any, y: Any, z: Any, t: Any) -> dict[str, Any]:
    """What the water is like."""
    still = 0.0 * (x + y + z + t)
    return {
        "u": 0.1 + 1e-5 * x - 2e-5 * y + 1e-3 * z + 1e-5 * t,
        "v": -0.05 + 1e-5 * y + 2e-5 * x + still,
        "temperature": 12.0 + 0.05 * z + still,
        "salinity": 35.0 - 0.02 * z + still,
    }


def _on_axes(t: Any, depth: Any, latitude: Any, longitude: Any) -> dict[str, Any]:
    x, y = metres(latitude, longitude)
    return truth(x[None, None, None, :], y[None, None, :, None], -depth[None, :, None, None], t[:, None, None, None])


def cmems() -> Any:
    """As the Copernicus Marine Service names things: uo, vo, thetao, so; depths positive down, hours since 1950."""
    depth, t = np.array([0.5, 2.0, 10.0, 25.0, 60.0]), np.arange(3) * HOUR
    latitude, longitude = LATITUDE + np.arange(-2, 4) / 12.0, LONGITUDE + np.arange(-3, 3) / 12.0 + 0.01
    values = _on_axes(t, depth, latitude, longitude)
    dims = ("time", "depth", "latitude", "longitude")
    names = {
        "uo": ("u", "m s-1"),
        "vo": ("v", "m s-1"),
        "thetao": ("temperature", "degrees_C"),
        "so": ("salinity", "1e-3"),
    }
    since = (np.datetime64(START) - np.datetime64("1950-01-01")) / np.timedelta64(1, "h")
    return xarray.Dataset(
        {name: (dims, values[what], {"units": unit}) for name, (what, unit) in names.items()},
        coords={
            "time": ("time", since + np.arange(3.0), {"units": "hours since 1950-01-01", "calendar": "gregorian"}),
            "depth": ("depth", depth, {"units": "m", "positive": "down", "axis": "Z"}),
            "latitude": ("latitude", latitude, {"units": "degrees_north"}),
            "longitude": ("longitude", longitude, {"units": "degrees_east"}),
        },
    )


def hycom() -> Any:
    """As HYCOM: water_u, water_v, water_temp; longitudes to 360, latitudes southwards, a `tau` of no calendar."""
    data = cmems().rename(
        uo="water_u", vo="water_v", thetao="water_temp", so="salinity", latitude="lat", longitude="lon"
    )
    data = data.assign_coords(lon=data["lon"].assign_attrs(units="degrees_east") + 360.0)
    data["salinity"].attrs["units"], data["water_temp"].attrs["units"] = "psu", "degC"
    hours = (np.datetime64(START) - np.datetime64("2000-01-01")) / np.timedelta64(1, "h") + np.arange(3.0)
    data = data.assign_coords(time=("time", hours, {"units": "hours since 2000-01-01 00:00:00"}))
    data["tau"] = ("time", np.zeros(3), {"units": "hours since analysis"})
    return data.isel(lat=slice(None, None, -1))


def roms_levels() -> Any:
    """As ROMS after interpolation to depths: u, v, temp, salt over time, depth, lat, lon."""
    return cmems().rename(uo="u", vo="v", thetao="temp", so="salt", latitude="lat", longitude="lon", time="ocean_time")


def roms(turned: float = 20.0, transform: int = 2) -> Any:
    """As ROMS itself: a grid turned by so many degrees, s-levels, u and v between the points of density."""
    rows, columns, spacing, levels = 9, 8, 400.0, 12
    angle, h, hc = math.radians(turned), 40.0, 5.0
    along, across = np.meshgrid((np.arange(columns) - 3.5) * spacing, (np.arange(rows) - 4.0) * spacing)
    x = along * math.cos(angle) - across * math.sin(angle)
    y = along * math.sin(angle) + across * math.cos(angle)
    per_degree = [float(part) for part in (metres(LATITUDE, LONGITUDE + 1.0)[0], metres(LATITUDE + 1.0, LONGITUDE)[1])]
    s = (np.arange(levels) + 0.5) / levels - 1.0
    stretch = (1.0 - np.cosh(3.0 * s)) / (math.cosh(3.0) - 1.0)
    zeta = np.array([0.0, 0.3, -0.2])
    if transform == 2:
        z = zeta[:, None] + (zeta[:, None] + h) * (hc * s + h * stretch) / (hc + h)
    else:
        unmoved = hc * (s - stretch) + h * stretch
        z = unmoved + zeta[:, None] * (1.0 + unmoved / h)
    t = np.arange(3) * HOUR
    values = truth(x[None, None], y[None, None], z[:, :, None, None], t[:, None, None, None])
    forward = values["u"] * math.cos(angle) + values["v"] * math.sin(angle)
    sideways = values["v"] * math.cos(angle) - values["u"] * math.sin(angle)
    since = (np.datetime64(START) - np.datetime64("2000-01-01")) / np.timedelta64(1, "s")
    at, rho = ("ocean_time", "s_rho"), ("eta_rho", "xi_rho")
    speed = {"units": "meter second-1"}
    return xarray.Dataset(
        {
            "u": ((*at, "eta_u", "xi_u"), 0.5 * (forward[..., 1:] + forward[..., :-1]), speed),
            "v": ((*at, "eta_v", "xi_v"), 0.5 * (sideways[..., 1:, :] + sideways[..., :-1, :]), speed),
            "temp": ((*at, *rho), values["temperature"], {"units": "Celsius"}),
            "salt": ((*at, *rho), values["salinity"]),
            "zeta": (("ocean_time", *rho), np.broadcast_to(zeta[:, None, None], (3, rows, columns)).copy()),
            "h": (rho, np.full((rows, columns), h)),
            "angle": (rho, np.full((rows, columns), angle)),
            "hc": hc,
            "Vtransform": transform,
            "Cs_r": ("s_rho", stretch),
        },
        coords={
            "ocean_time": ("ocean_time", since + t, {"units": "seconds since 2000-01-01"}),
            "s_rho": ("s_rho", s),
            "lon_rho": (rho, LONGITUDE + x / per_degree[0]),
            "lat_rho": (rho, LATITUDE + y / per_degree[1]),
        },
    )


MODELS = {"cmems": cmems, "hycom": hycom, "roms_levels": roms_levels, "roms": roms}

if __name__ == "__main__":
    name, folder = sys.argv[1:]
    MODELS[name]().to_netcdf(Path(folder) / f"{name}.nc", engine="scipy")
