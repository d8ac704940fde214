"""The water of an ocean model in one tank during one run: velocity and density as rows of numbers."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.ocean_current import OceanCurrent
from cocorosim_ros.world.water.ocean.gridded_water import GriddedWater, bracket, check_covers
from cocorosim_ros.world.water.ocean.local_frame import LocalFrame
from cocorosim_ros.world.water.ocean.model_file import (
    S_LEVELS,
    VELOCITY,
    OceanFileError,
    axis_coordinate,
    heights,
    moment_text,
    needed_variables,
    open_model,
    seconds,
)
from cocorosim_ros.world.water.ocean.roms import roms_water
from cocorosim_ros.world.water.ocean.sea_water import BAR_PER_METRE, density

_SLACK = 1e-6  # s


@dataclass(frozen=True)
class OceanField:
    """Velocity [m/s; world] and density [kg/m^3] as water.currents.gridded lays them out; no density: an empty row."""

    velocity: Floats
    density: Floats


@lru_cache(maxsize=4)  # a scenario is checked, built and drawn with the same one
def ocean_field(current: OceanCurrent, size: tuple[float, float, float], duration: float) -> OceanField:
    """The water in a tank of `size` x, y, depth [m] around the origin, for a run of `duration` [s].

    Raises OceanFileError: the end of a sentence that says what of the file does not fit.
    """
    with open_model(current.file.path) as data:
        names = needed_variables(data, current.buoyancy)
        water = _in_time(data, names, current, duration, size)
    _check_water(water)
    velocity = np.stack([water.fields.get(what, np.zeros_like(water.fields["eastward"])) for what in VELOCITY], axis=-1)
    dense = np.zeros(0)
    if current.buoyancy:
        bar = np.maximum(-water.axes[1], 0.0)[None, :, None, None] * BAR_PER_METRE
        dense = water.numbers(density(water.fields["temperature"], water.fields["salinity"], bar))
    return OceanField(water.numbers(velocity), dense)


def _in_time(
    data: Any, names: dict[str, str], current: OceanCurrent, duration: float, size: tuple[float, float, float]
) -> GriddedWater:
    """The water around the origin at the moments of the run."""
    frame, u = LocalFrame(current.latitude, current.longitude), names["eastward"]
    clock = axis_coordinate(data, u, "t")
    times = np.zeros(1)
    if clock is not None:
        times = seconds(data, clock, current.start)
        if len(times) > 1:
            if (np.diff(times) <= 0.0).any():
                raise OceanFileError(f"whose times '{clock}' do not ascend; sort the file by them.")
            _check_times(data, clock, times, duration)
            part = bracket(times, 0.0, duration)
            data, times = data.isel({data[clock].dims[0]: part}), times[part]
    shape = roms_water if S_LEVELS in data[u].dims else _rectilinear
    water = shape(data, names, frame, size)
    return replace(water, axes=(times, *water.axes[1:]))


def _check_times(data: Any, clock: str, times: Floats, duration: float) -> None:
    if times[0] > _SLACK or times[-1] < duration - _SLACK:
        first, last = (moment_text(data, clock, place) for place in (0, -1))
        raise OceanFileError(
            f"whose times reach from {first} to {last}, which does not hold the run of {duration:g} s; change "
            "'start' or 'duration', or take a longer cut-out."
        )


def _rectilinear(data: Any, names: dict[str, str], frame: LocalFrame, size: tuple[float, float, float]) -> GriddedWater:
    """The fields of a file whose axes are depth, latitude and longitude; the first axis is a count of its moments."""
    u = names["eastward"]
    found = {axis: axis_coordinate(data, u, axis) for axis in "zyx"}
    for axis, what in (("z", "depth"), ("y", "latitude"), ("x", "longitude")):
        if found[axis] is None:
            shown = ", ".join(map(str, data[u].dims))
            raise OceanFileError(f"whose '{u}' runs over {shown}, with no {what} among them; take a file that has it.")
        if data[found[axis]].ndim != 1:
            raise OceanFileError(
                f"whose {what} '{found[axis]}' is not one axis but a grid; interpolate it to latitudes and longitudes."
            )
    axes = {
        "z": heights(data, str(found["z"])),
        "y": frame.north(np.asarray(data[found["y"]].values, float)),
        "x": frame.east(np.asarray(data[found["x"]].values, float)),
    }
    check_depth(axes["z"], size[2])
    parts, cut = {}, {}
    for axis, low, high in (("z", -size[2], 0.0), ("y", -size[1] / 2, size[1] / 2), ("x", -size[0] / 2, size[0] / 2)):
        order = np.argsort(axes[axis])
        ascending = axes[axis][order]
        if axis != "z":
            check_covers(ascending, low, high, *(("east", "west") if axis == "x" else ("north", "south")))
        part = bracket(ascending, low, high)
        cut[axis], parts[str(data[found[axis]].dims[0])] = ascending[part], order[part]
    near = data.isel(parts)
    dims = [str(data[found[axis]].dims[0]) for axis in "zyx"]
    fields = {what: _values(near[name], dims) for what, name in names.items() if set(dims) <= set(near[name].dims)}
    return GriddedWater((np.arange(float(fields["eastward"].shape[0])), cut["z"], cut["y"], cut["x"]), fields)


def check_depth(z: Floats, depth: float) -> None:
    """Nothing, if levels `z` [m; world] reach down to the floor of a tank of this depth [m]. Raises OceanFileError."""
    if z.min() > -depth:
        raise OceanFileError(
            f"whose levels reach {-z.min():.4g} m down, and the tank {depth:g} m; take more levels or a shallower tank."
        )


def _values(field: Any, dims: list[str]) -> Floats:
    """(nt, nz, ny, nx) a field; further axes of one value are dropped."""
    others = [str(each) for each in field.dims if each not in dims]
    whole = np.asarray(field.transpose(*others, *dims).values, dtype=np.float64)
    return whole.reshape(-1, *whole.shape[len(others) :])


def _check_water(water: GriddedWater) -> None:
    """Nothing, if there is water wherever the tank is. Raises OceanFileError."""
    for what, field in water.fields.items():
        dry = np.isnan(field)
        if dry.any():
            _, level, row, column = np.argwhere(dry)[0]
            _, z, y, x = water.axes
            raise OceanFileError(
                f"in which there is land, or nothing, where '{what}' is needed: {np.count_nonzero(dry)} of {dry.size} "
                f"values around the tank, e.g. at z = {z[level]:.4g} m, {x[column]:.4g} m east, {y[row]:.4g} m north of"
                " the origin; move the origin, or make the tank smaller or shallower."
            )
