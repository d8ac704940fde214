"""What a netCDF file of an ocean model holds: its variables and axes by the names that CMEMS, HYCOM and ROMS give them.

Names come first, then the standard names of the CF conventions (version 1.11, section 3.3), then the attribute `axis`.
"""

from __future__ import annotations

import datetime
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.entry import listed


class OceanFileError(ValueError):
    """The end of a sentence that begins with the file: what of it cannot be used, and what to do."""


_SPEED = ("m/s", "m s-1", "m s^-1", "m s**-1", "meter second-1", "meters second-1", "meter/second")
_DEGREES = ("degc", "degrees_c", "degree_c", "degree_celsius", "degrees_celsius", "celsius", "deg_c", "\u00b0c", "c")
_SALT = ("1e-3", "0.001", "psu", "1", "g kg-1", "g/kg", "pss-78", "pss", "psal", "practical salinity unit", "")
# By what it is: names, standard names, units (the first is told).
VARIABLES: Mapping[str, tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]] = {
    "eastward": (("uo", "water_u", "u_eastward", "u"), ("eastward_sea_water_velocity", "sea_water_x_velocity"), _SPEED),
    "northward": (
        ("vo", "water_v", "v_northward", "v"),
        ("northward_sea_water_velocity", "sea_water_y_velocity"),
        _SPEED,
    ),
    "upward": (("wo", "water_w", "w"), ("upward_sea_water_velocity",), _SPEED),
    "temperature": (
        ("thetao", "water_temp", "temp", "temperature"),
        ("sea_water_potential_temperature", "sea_water_temperature"),
        ("degC", *_DEGREES),
    ),
    "salinity": (("so", "salinity", "salt"), ("sea_water_salinity", "sea_water_practical_salinity"), ("psu", *_SALT)),
}
VELOCITY = ("eastward", "northward", "upward")
# By axis: names, standard names, the letter of the attribute `axis`.
AXES: Mapping[str, tuple[tuple[str, ...], tuple[str, ...], str]] = {
    "t": (("time", "ocean_time", "time_counter", "MT"), ("time",), "T"),
    "z": (("depth", "lev", "level", "z", "Depth", "deptht", "depthu"), ("depth", "height", "altitude"), "Z"),
    "y": (("latitude", "lat", "nav_lat", "lat_rho"), ("latitude",), "Y"),
    "x": (("longitude", "lon", "nav_lon", "lon_rho"), ("longitude",), "X"),
}
S_LEVELS = "s_rho"


def open_model(path: str) -> Any:
    """The xarray.Dataset of a file; nothing of its fields is read yet. Raises OceanFileError."""
    # Weighs more than all the rest of a scenario: only who has a netCDF file loads xarray.
    import xarray  # noqa: PLC0415

    try:
        # HYCOM's `tau` has units of time that no calendar has ("hours since analysis"), so times come later.
        return xarray.open_dataset(Path(path), decode_times=False)
    except (OSError, ValueError, KeyError, TypeError, ImportError) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise OceanFileError(f"which cannot be read as netCDF ({reason}).") from error


def variable(data: Any, what: str) -> str | None:
    """The name of one of VARIABLES in the file; None if it has none. Raises OceanFileError for its units."""
    names, standard, units = VARIABLES[what]
    found = _named(data.data_vars, names, standard)
    if found is None:
        return None
    stated = str(data[found].attrs.get("units", units[0])).strip()
    if stated.lower() not in units and stated not in units:
        raise OceanFileError(f"whose '{found}' is in '{stated}'; convert it to {units[0]}.")
    return found


def needed_variables(data: Any, buoyancy: bool) -> dict[str, str]:
    """The names in the file of velocities, and of temperature and salinity where they are asked for."""
    found = {what: name for what in VARIABLES if (name := variable(data, what)) is not None}
    missing = [what for what in VELOCITY[:2] if what not in found]
    if missing:
        have = listed(map(str, data.data_vars), "and") or "nothing"
        raise OceanFileError(f"in which no {listed(missing, 'and')} velocity is recognised (it has {have}).")
    lacking = [what for what in ("temperature", "salinity") if what not in found]
    if buoyancy and lacking:
        raise OceanFileError(
            f"which has no {listed(lacking, 'and')} to make density of; take one that has, or write 'buoyancy: false'."
        )
    wanted = VARIABLES if buoyancy else VELOCITY
    return {what: found[what] for what in wanted if what in found}


def axis_coordinate(data: Any, name: str, axis: str) -> str | None:
    """The name of the coordinate of one variable along an axis of AXES; None if it has none."""
    names, standard, letter = AXES[axis]
    field = data[name]
    near = [str(each) for each in (*field.coords, *field.dims)]
    return _named(near, names, standard, data) or next(
        (each for each in near if each in data.variables and data[each].attrs.get("axis") == letter), None
    )


def seconds(data: Any, name: str, start: str | None) -> Floats:
    """The times of a coordinate [s since the start of the run, a moment in UTC; since its first without one]."""
    import xarray  # noqa: PLC0415

    try:
        moments = xarray.decode_cf(data[[name]])[name].values
        ticks = np.atleast_1d(moments).astype("datetime64[ns]")
    except (ValueError, TypeError, OverflowError) as error:
        raise OceanFileError(
            f"whose times '{name}' are in '{data[name].attrs.get('units', 'no units')}', which is no usual calendar; "
            "write them as 'seconds since 2000-01-01'."
        ) from error
    zero = ticks[0] if start is None else np.datetime64(datetime.datetime.fromisoformat(start), "ns")
    return np.asarray((ticks - zero) / np.timedelta64(1, "s"), dtype=np.float64)


def moment_text(data: Any, name: str, place: int) -> str:
    """A moment of the time coordinate as words."""
    import xarray  # noqa: PLC0415

    moments = np.atleast_1d(xarray.decode_cf(data[[name]])[name].values)
    return str(moments[place].astype("datetime64[s]"))


def heights(data: Any, name: str) -> Floats:
    """The levels of a depth coordinate as z [m; world], up positive."""
    levels, attributes = np.asarray(data[name].values, dtype=np.float64), data[name].attrs
    unit = str(attributes.get("units", "m"))
    if unit.lower() not in ("m", "meter", "meters", "metre", "metres"):
        raise OceanFileError(f"whose depth '{name}' is in '{unit}'; take a file with depths in m.")
    down = attributes.get("positive", "down" if (levels >= 0.0).all() else "up") == "down"
    return -levels if down else levels


def _named(there: Any, names: tuple[str, ...], standard: tuple[str, ...], data: Any = None) -> str | None:
    for name in names:
        if name in there and (data is None or name in data.variables):
            return name
    for name in there:
        attributes = there[name].attrs if data is None else data[name].attrs if name in data.variables else {}
        if attributes.get("standard_name") in standard:
            return str(name)
    return None
