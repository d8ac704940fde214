"""Currents as velocities of the water, as a scenario asks for them; several add up."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.parts.flow_file import FlowFile, read_flow_file
from cocorosim_ros.scenario.parts.ocean_current import OceanCurrent
from cocorosim_ros.scenario.parts.stated_file import stated_file_text
from cocorosim_ros.scenario.parts.waves import Waves
from cocorosim_ros.scenario.reading.records import choice, quantity, stored


@dataclass(frozen=True)
class UniformCurrent:
    """The same velocity x, y [m/s; world] everywhere."""

    x: float = field(metadata=quantity("speed"))
    y: float = field(metadata=quantity("speed"))
    kind: Literal["uniform"] = field(default="uniform", metadata=choice("uniform"))


@dataclass(frozen=True)
class ShearedCurrent:
    """Velocity x, y [m/s; world] at the world's origin, and what each metre adds to it [1/s]."""

    x: float = field(metadata=quantity("speed"))
    y: float = field(metadata=quantity("speed"))
    dx_dy: float = field(default=0.0, metadata=quantity("rate"))
    dx_dz: float = field(default=0.0, metadata=quantity("rate"))
    dy_dx: float = field(default=0.0, metadata=quantity("rate"))
    dy_dz: float = field(default=0.0, metadata=quantity("rate"))
    kind: Literal["sheared"] = field(default="sheared", metadata=choice("sheared"))


@dataclass(frozen=True)
class TidalCurrent:
    """(x, y) sin(2 pi t / period + phase) [m/s; world], period [s], phase [rad]."""

    x: float = field(metadata=quantity("speed"))
    y: float = field(metadata=quantity("speed"))
    period: float = field(metadata=quantity("time", "positive"))
    phase: float = field(default=0.0, metadata=quantity("angle"))
    kind: Literal["tidal"] = field(default="tidal", metadata=choice("tidal"))


@dataclass(frozen=True)
class VortexCurrent:
    """An eddy around x, y [m; world]: circulation [m^2/s], counter-clockwise positive, and core radius [m]."""

    x: float = field(metadata=quantity("length"))
    y: float = field(metadata=quantity("length"))
    circulation: float = field(metadata=quantity("area rate"))
    core: float = field(metadata=quantity("length", "positive"))
    kind: Literal["vortex"] = field(default="vortex", metadata=choice("vortex"))


@dataclass(frozen=True)
class GriddedCurrent:
    """Velocity from a netCDF file, held at its edges beyond them.

    sha256: digest of the file; a scenario that states it refuses a file that has changed since.
    """

    file: FlowFile = field(metadata=stored(read_flow_file, stated_file_text, form="path of a netCDF file"))
    kind: Literal["gridded"] = field(default="gridded", metadata=choice("gridded"))


VelocityCurrent = UniformCurrent | ShearedCurrent | TidalCurrent | VortexCurrent | GriddedCurrent | OceanCurrent | Waves
VELOCITY_CURRENTS: dict[str, type[VelocityCurrent]] = {
    "uniform": UniformCurrent,
    "sheared": ShearedCurrent,
    "tidal": TidalCurrent,
    "vortex": VortexCurrent,
    "gridded": GriddedCurrent,
    "ocean": OceanCurrent,
    "waves": Waves,
}
