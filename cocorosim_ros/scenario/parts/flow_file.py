"""A velocity field from a netCDF file: variables u, v and optionally w [m/s] over x, y, optionally z and t.

x, y, z are in metres in the world frame (z up, 0 at the surface; `positive: down` on z is turned round), t in seconds
since the start of the run (dates count from the first of them).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.stated_file import StatedFile, naming_entry, read_stated_file
from cocorosim_ros.scenario.reading.entry import Entry, listed, quoted

_AXES = ("t", "z", "y", "x")
_SPEED_UNITS = ("m/s", "m s-1", "m s^-1", "m s**-1", "meter second-1", "1")


@dataclass(frozen=True)
class FlowFile(StatedFile):
    """A netCDF file by its place and the digest of its bytes, with its axes and velocities.

    numbers: sizes nt, nz, ny, nx; the axes t [s], z, y, x [m; world]; velocities [m/s] (nt, nz, ny, nx, 3).
    """

    numbers: Floats = field(compare=False, repr=False)


def read_flow_file(entry: Entry) -> FlowFile:
    """The velocity field that `path.nc` or {path, sha256} names; a relative path counts from the scenario's folder.

    Raises CocorosimError: no such file, no netCDF, a missing variable or axis, values that are missing or not m/s,
    an axis that does not ascend or descend, a file whose bytes differ from the stated digest.
    """
    file = read_stated_file(entry)
    return FlowFile(file.path, file.sha256, _numbers(Path(file.path), naming_entry(entry)))


def _numbers(path: Path, entry: Entry) -> Floats:
    # Weighs more than all the rest of a scenario: only who has a netCDF file loads xarray.
    import xarray  # noqa: PLC0415

    try:
        with xarray.open_dataset(path) as data:
            loaded = data.load()
    except (OSError, ValueError, KeyError, TypeError, ImportError) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise entry.problem(f"has '{entry.value}', which cannot be read as netCDF ({reason}).") from error
    _check_names(loaded, entry)
    axes = {name: _axis(loaded, name, entry) for name in _AXES}
    values = [_component(loaded, name, axes, entry) for name in ("u", "v", "w")]
    for place, name in enumerate(_AXES):
        if len(axes[name]) > 1 and axes[name][0] > axes[name][-1]:
            axes[name] = axes[name][::-1]
            values = [np.flip(each, place) for each in values]
    sizes = np.array([len(axes[name]) for name in _AXES], dtype=np.float64)
    return np.concatenate([sizes, *(axes[name] for name in _AXES), np.stack(values, axis=-1).ravel()])


def _check_names(data: Any, entry: Entry) -> None:
    missing = [name for name in ("u", "v") if name not in data.data_vars]
    if missing:
        raise entry.problem(
            f"has '{entry.value}', which lacks {quoted(missing)} (it has {listed(map(str, data.data_vars), 'and')}); "
            "rename its variables to u, v [m/s] and, if there is one, w."
        )
    for name in ("u", "v", "w"):
        if name not in data.data_vars:
            continue
        strange = [str(axis) for axis in data[name].dims if axis not in _AXES]
        lacking = [axis for axis in ("x", "y") if axis not in data[name].dims]
        if strange or lacking:
            raise entry.problem(
                f"has '{entry.value}', whose '{name}' runs over {listed(map(str, data[name].dims), 'and')}; it must "
                "run over x and y, and may run over z and t."
            )
        unit = str(data[name].attrs.get("units", "m/s"))
        if unit not in _SPEED_UNITS:
            raise entry.problem(f"has '{entry.value}', whose '{name}' is in '{unit}'; convert it to m/s.")


def _axis(data: Any, name: str, entry: Entry) -> Floats:
    if name not in data.dims:
        return np.zeros(1)
    if name not in data.coords:
        raise entry.problem(f"has '{entry.value}', whose axis '{name}' has no values; add the coordinate '{name}'.")
    values = data[name].values
    if np.issubdtype(values.dtype, np.datetime64):
        values = (values - values[0]) / np.timedelta64(1, "s")
    elif np.issubdtype(values.dtype, np.timedelta64):
        values = values / np.timedelta64(1, "s")
    axis = np.asarray(values, dtype=np.float64)
    if name == "z" and data[name].attrs.get("positive") == "down":
        axis = -axis
    steps = np.diff(axis)
    if not np.isfinite(axis).all() or not ((steps > 0).all() or (steps < 0).all()):
        raise entry.problem(
            f"has '{entry.value}', whose axis '{name}' neither ascends nor descends throughout; sort the file by it."
        )
    return axis


def _component(data: Any, name: str, axes: dict[str, Floats], entry: Entry) -> Floats:
    """(nt, nz, ny, nx) one component; zero for a `w` that is not there."""
    shape = tuple(len(axes[axis]) for axis in _AXES)
    if name not in data.data_vars:
        return np.zeros(shape)
    absent = [axis for axis in _AXES if axis not in data[name].dims]
    whole = data[name].expand_dims(absent).transpose(*_AXES)
    values = np.asarray(whole.values, dtype=np.float64)
    if not np.isfinite(values).all():
        raise entry.problem(
            f"has '{entry.value}', whose '{name}' has {np.count_nonzero(~np.isfinite(values))} missing values; fill "
            "them, with 0 where there is land."
        )
    return np.array(np.broadcast_to(values, shape))
