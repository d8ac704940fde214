"""The numbers that a vehicle with `six_degrees` has while it stays level, in surge, sway, heave and yaw.

Of its mass matrix only surge, sway, heave and yaw count: M_11 = m - X_u', M_22 = m - Y_v', M_33 = m - Z_w',
M_66 = I_z + m (x_g^2 + y_g^2) - N_r', M_26 = m x_g - Y_r' and M_16 = -m y_g - X_r'. In still water a mass of M_11 whose
centre is M_26 / M_11 ahead of the origin and -M_16 / M_11 left of it, with M_22 - M_11 of added mass sideways, has the
same equations. Drag is that of each axis by itself; the trim is what buoyancy has over weight.
Source: Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2011), sections 6.5 and 7.3.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.six_degrees import SixDegrees

SIX = "six_degrees."
EFFECTS = "effects."
SURGE, SWAY, HEAVE, YAW = 0, 1, 2, 2  # of vectors of three along the axes, and about them
BASIC = {"mass": "kg", "yaw_inertia": "kg m^2", "drag": "kg/m", "yaw_drag": "N m s^2"}
"""Numbers of every platform, with their units."""


class Cell(NamedTuple):
    """Where a coupling stands: the name of its matrix, and the axes of the force and of the motion."""

    matrix: str
    force: str
    motion: str


_LIFT = {
    "sway_by_drift": ("sway", "sway", "kg/m"),
    "sway_by_turn": ("sway", "yaw", "kg"),
    "yaw_by_drift": ("yaw", "sway", "kg"),
    "yaw_by_turn": ("yaw", "yaw", "kg m"),
    "heave_by_climb": ("heave", "heave", "kg/m"),
}
_ALONG = Cell("lift", "surge", "surge")
_OFFSETS = (Cell("added_mass", "sway", "yaw"), Cell("added_mass", "surge", "yaw"))
CARRIED = {
    *(Cell("lift", force, motion) for force, motion, _ in _LIFT.values()),
    *_OFFSETS,
    *(Cell(matrix, motion, force) for matrix, force, motion in _OFFSETS),
    _ALONG,
}
"""Couplings that a level vehicle has in numbers of its own."""


@dataclass(frozen=True)
class LevelNumber:
    """A number of the level vehicle, by its dotted key in a platform file, in SI units.

    made_of: by how much it changes with each number of the file whose range it takes over, by the key of that; what
    else it is made of is held there. neutral: where an effect does nothing.
    """

    key: str
    value: float
    unit: str
    made_of: Mapping[str, float] = field(default_factory=dict)
    neutral: float = 0.0


def level_numbers(platform: Platform, six: SixDegrees) -> list[LevelNumber]:
    """The numbers of a platform with these six degrees of freedom, those of every platform before those of effects."""
    return [*_basic(platform, six), *_added_mass(platform, six), *_drag(six), *_lift(six), _trim(platform, six)]


def _basic(platform: Platform, six: SixDegrees) -> Iterator[LevelNumber]:
    surge, turning = f"{SIX}added_mass.{SURGE}", {f"{SIX}inertia.{YAW}": 1.0, f"{SIX}added_inertia.{YAW}": 1.0}
    yield LevelNumber("mass", platform.mass + six.added_mass[SURGE], "kg", {"mass": 1.0, surge: 1.0})
    yield LevelNumber("yaw_inertia", six.inertia[YAW] + six.added_inertia[YAW], "kg m^2", turning)
    ahead = {f"{SIX}quadratic_damping.{SURGE}": 1.0, **_place(six, _ALONG)}
    yield LevelNumber("drag", _drag_ahead(six), "kg/m", ahead)
    turn = f"{SIX}quadratic_turn_damping.{YAW}"
    yield LevelNumber("yaw_drag", six.quadratic_turn_damping[YAW], "N m s^2", {turn: 1.0})


def _added_mass(platform: Platform, six: SixDegrees) -> Iterator[LevelNumber]:
    """Added mass beyond that ahead, and where the centre of all mass is; about that, `yaw` makes up the inertia."""
    along, across, upwards = six.added_mass
    x, y, _ = six.centre_of_gravity
    whole = platform.mass + along
    sway_by_yaw, surge_by_yaw = (_coupling(six, cell) for cell in _OFFSETS)
    ahead, left = (platform.mass * x + sway_by_yaw) / whole, (platform.mass * y - surge_by_yaw) / whole
    about_centre = platform.mass * (x**2 + y**2) - whole * (ahead**2 + left**2)
    name = f"{EFFECTS}added_mass"
    yield LevelNumber(f"{name}.sway_minus_surge", across - along, "kg", {f"{SIX}added_mass.{SWAY}": 1.0})
    yield LevelNumber(f"{name}.yaw", about_centre, "kg m^2")
    yield LevelNumber(f"{name}.heave_minus_surge", upwards - along, "kg", {f"{SIX}added_mass.{HEAVE}": 1.0})
    moved = platform.mass / whole
    name = f"{EFFECTS}offset_centre"
    yield LevelNumber(f"{name}.ahead", ahead, "m", {f"{SIX}centre_of_gravity.0": moved})
    yield LevelNumber(f"{name}.left", left, "m", {f"{SIX}centre_of_gravity.1": moved})


def _drag(six: SixDegrees) -> Iterator[LevelNumber]:
    for axis, name in enumerate(("surge", "sway", "heave")):
        source = f"{SIX}linear_damping.{axis}"
        yield LevelNumber(f"{EFFECTS}linear_drag.{name}", six.linear_damping[axis], "N s/m", {source: 1.0})
    source = f"{SIX}linear_turn_damping.{YAW}"
    yield LevelNumber(f"{EFFECTS}linear_drag.yaw", six.linear_turn_damping[YAW], "N m s", {source: 1.0})
    ahead = _drag_ahead(six)
    if ahead == 0.0:  # to which no drag has a ratio
        return
    for axis, name in ((SWAY, "sway_ratio"), (HEAVE, "heave_ratio")):
        source = f"{SIX}quadratic_damping.{axis}"
        ratio = six.quadratic_damping[axis] / ahead
        yield LevelNumber(f"{EFFECTS}anisotropic_drag.{name}", ratio, "1", {source: 1.0 / ahead}, neutral=1.0)


def _lift(six: SixDegrees) -> Iterator[LevelNumber]:
    for name, (force, motion, unit) in _LIFT.items():
        cell = Cell("lift", force, motion)
        yield LevelNumber(f"{EFFECTS}hull_lift.{name}", _coupling(six, cell), unit, _place(six, cell))


def _trim(platform: Platform, six: SixDegrees) -> LevelNumber:
    """What lifts it, with buoyancy of the whole volume."""
    force = (platform.water_density * six.volume - platform.mass) * platform.gravity
    made_of = {f"{SIX}volume": platform.water_density * platform.gravity, "mass": -platform.gravity}
    return LevelNumber(f"{EFFECTS}buoyancy_trim.force", force, "N", made_of)


def _drag_ahead(six: SixDegrees) -> float:
    """Quadratic drag ahead [kg/m]; a lift ahead that grows with the speed ahead is the same."""
    return six.quadratic_damping[SURGE] + _coupling(six, _ALONG)


def _coupling(six: SixDegrees, cell: Cell) -> float:
    """The number of a coupling, of added mass of its mirrored one too; 0 without it."""
    return sum(six.couplings[index].number.value for index in _written(six, cell))


def _place(six: SixDegrees, cell: Cell) -> dict[str, float]:
    """The key of the number of a coupling, as `LevelNumber.made_of` has it."""
    return {f"{SIX}couplings.{index}.number": 1.0 for index in _written(six, cell)}


def _written(six: SixDegrees, cell: Cell) -> Iterator[int]:
    """Where in the list a coupling stands."""
    matrix, force, motion = cell
    axes = {(force, motion), (motion, force)} if matrix == "added_mass" else {(force, motion)}
    for index, part in enumerate(six.couplings):
        if part.matrix == matrix and (part.force, part.motion) in axes:
            yield index
