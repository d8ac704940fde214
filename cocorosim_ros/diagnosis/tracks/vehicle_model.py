"""Vehicle models: from a row of numbers to the body that the simulator's physics moves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import AHEAD, full_speed
from cocorosim_ros.diagnosis.filter.layout import WATER_WEIGHT
from cocorosim_ros.diagnosis.tracks.columns import (
    ALWAYS_ACTIVE,
    COLUMN,
    EXPONENTS,
    MOST_THRUSTERS,
    NEUTRAL,
    OWN_GAINS,
    PHYSICS,
    THRUSTERS,
    active_effects,
)
from cocorosim_ros.diagnosis.tracks.own_curves import own_curves
from cocorosim_ros.diagnosis.tracks.own_numbers import Declared, gain_key, own_numbers
from cocorosim_ros.diagnosis.tracks.surge_drag import with_surge_drag
from cocorosim_ros.diagnosis.tracks.surroundings import OPEN_WATER, RecordedSurroundings
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.scenario.reading.ranges import Range, Ranges
from cocorosim_ros.world.laws.laws_of_platform import effects_of
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE
from cocorosim_ros.world.terms.curve import ANGLE, FORM
from cocorosim_ros.world.terms.moment import NEIGHBOUR_SIZE
from cocorosim_ros.world.vehicle_model.fins import fin_forces, fin_normals, fin_places
from cocorosim_ros.world.vehicle_model.rudders import rudder_forces
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, MASS, YAW_INERTIA, Body
from cocorosim_ros.world.water.flow import make_flow

STILL = make_flow([])


@dataclass(frozen=True)
class VehicleModel:
    """One robot as its platform's file describes it, in its surroundings."""

    nominal: Floats  # (parameters,) the platform's numbers, columns of PARAMETER_COLUMNS, SI units
    active: int  # bits of the effects that act even with neutral numbers
    actuator_wrench: Floats  # (actuators, 4) X, Y, Z, N per newton [1, 1, 1, m; body]
    actuator_limit: Floats  # (actuators, 2) force at command +1 and -1 without own gains, both positive [N]
    is_pump: Flags  # (actuators,)
    actuator_curve: Floats  # (actuators, columns) see world.terms.curve
    jets: Floats  # (pairs, JET_COLUMNS) see world.terms.jet
    full_force: Floats  # (actuators, 1) at command +1 as the wrench counts it [N], rudders 0
    steering: Floats  # (4,) amounts of X, Y, Z, N of rudders and fins at full speed [N, N, N, N m; body]
    above_water: tuple[float, float]  # areas as seen from ahead and from the side [m^2]
    own: Mapping[str, Declared]  # by key of the platform's file, numbers of single actuators that a model has
    known: Mapping[str, float]  # by column, numbers of sensors and stamps from the platform's file
    ranges: Ranges
    intervals: Ranges  # 95 % intervals of numbers that were measured
    kept: frozenset[str]  # keys of the numbers that no fit changes
    hull: float  # length of the hull [m]
    arm: float  # mean distance of the thrusters before the centre [m]
    height: float  # of the hull [m]
    width: float  # of the hull [m]
    weight: float  # in air [N]
    surroundings: RecordedSurroundings = OPEN_WATER
    tilts: bool = False  # whether roll and pitch are known, and thrust is turned by them
    fin_normal: Floats = field(default_factory=lambda: np.zeros((0, 3)))  # (actuators, 3) of fins [body], or zeros
    fin_place: Floats = field(default_factory=lambda: np.zeros((0, 3)))  # (actuators, 3) of fins [m; body], or zeros
    cable: tuple[float, float] = (0.0, 0.0)  # diameter of the cable, 0 without one, and its declared length [m]
    water_weight: float = PASCAL_PER_METRE  # of the water in which its pressure sensor reads [Pa per metre of depth]

    @cached_property
    def acting_wrench(self) -> Floats:
        """Wrench per newton (acting, 4) of all columns of a track's forces [1, 1, 1, m; level axes].

        A robot that tilts has four more than actuators: what the tilt adds to thrust and hull along and about the axes.
        """
        return np.vstack([self.actuator_wrench, np.eye(4)]) if self.tilts else self.actuator_wrench

    @cached_property
    def acting_pump(self) -> Flags:
        """Flags (acting,) of the pumps among the columns of a track's forces."""
        return np.concatenate([self.is_pump, np.zeros(len(self.acting_wrench) - len(self.is_pump), dtype=np.bool_)])

    @property
    def mass(self) -> float:
        """Mass in the platform's file [kg]."""
        return float(self.nominal[MASS])

    @property
    def yaw_inertia(self) -> float:
        """Yaw inertia in the platform's file [kg m^2]."""
        return float(self.nominal[YAW_INERTIA])

    @cached_property
    def force_scale(self) -> Floats:
        """Full wrench (4,): sum over all actuators of the amounts of X, Y, Z, N at command +1 [N, N, N, N m; body].

        A rudder counts with its force at full speed.
        """
        return np.asarray(np.abs(self.actuator_wrench * self.full_force).sum(axis=0)) + self.steering

    @property
    def is_thruster(self) -> Flags:
        """Flags (actuators,) of what pushes by its command."""
        return np.asarray(~self.is_pump & ~self.is_steering)

    @property
    def is_steering(self) -> Flags:
        """Flags (actuators,) of what is told an angle or a way: rudders, fins, azimuths."""
        if self.actuator_curve.shape[1] == 0:
            return np.zeros(len(self.is_pump), dtype=np.bool_)
        return np.asarray(self.actuator_curve[:, FORM] >= ANGLE)

    @property
    def row(self) -> Floats:
        """Row (columns,) of the platform's numbers without further effects; noise is still zero."""
        row = NEUTRAL.copy()
        row[PHYSICS] = self.nominal
        row[COLUMN[WATER_WEIGHT]] = self.water_weight
        for column, value in self.known.items():
            row[COLUMN[column]] = value
        for number in self.own.values():
            row[COLUMN[number.column]] = number.value
        return row

    def body(self, row: Floats) -> Body:
        """Make the simulator's body with the numbers of a row (columns,); effects with numbers not neutral are active.

        The array of neighbours holds zeros: the filter writes the neighbours of each grid point into it.
        """
        return self.actuating_body(row)._replace(actuator_wrench=self.acting_wrench, is_pump=self.acting_pump)

    def actuating_body(self, row: Floats) -> Body:
        """Make the body with the actuators alone, which turn commands into forces along the robot's own axes."""
        row = with_surge_drag(row)
        around = self.surroundings
        return Body(
            row[PHYSICS].copy(),
            self.active | active_effects(row),
            self.actuator_wrench,
            self._limit(row),
            self.is_pump,
            self._curve(row),
            self.jets,
            STILL,
            around.lower,
            around.upper,
            np.zeros((around.around.shape[1], NEIGHBOUR_SIZE)),
            around.own,
        )

    def _curve(self, row: Floats) -> Floats:
        """Curves (actuators, columns) with the thrusters' own exponents of a row (columns,)."""
        if (row[EXPONENTS] == 1.0).all():
            return self.actuator_curve
        exponents, single = np.ones(len(self.is_pump)), np.flatnonzero(self.is_thruster)[:MOST_THRUSTERS]
        exponents[single] = row[EXPONENTS][: len(single)]
        return own_curves(self.actuator_curve, exponents)

    def _limit(self, row: Floats) -> Floats:
        """Force (actuators, 2) at command +1 and -1 [N], with the thrusters' own gains of a row (columns,)."""
        gains = row[THRUSTERS]
        if (gains == 1.0).all():
            return self.actuator_limit
        limit = self.actuator_limit.copy()
        single = np.flatnonzero(self.is_thruster)[:MOST_THRUSTERS]
        limit[self.is_thruster] *= gains[0]
        limit[single] *= gains[1 : 1 + len(single), None]
        return limit


def vehicle_model(platform: Platform) -> VehicleModel:
    """Make the model of one robot from its platform, in open water."""
    vehicles = build_vehicles([platform])
    own = own_numbers(platform)
    thrusters = [actuator.position[0] for actuator in platform.actuators if isinstance(actuator, Thruster)]
    return VehicleModel(
        vehicles.parameters[0, 0],
        int(vehicles.active[0, 0]) | ALWAYS_ACTIVE,
        vehicles.actuator_wrench[0, 0],
        _without_gains(platform, own, vehicles.actuator_limit[0, 0]),
        vehicles.is_pump[0, 0],
        vehicles.actuator_curve[0, 0],
        vehicles.jets[0, 0],
        platform.full_forces()[:, AHEAD],
        rudder_forces(platform, full_speed(platform)) + fin_forces(platform, full_speed(platform)),
        (platform.hull.front_above_water or 0.0, platform.hull.side_above_water or 0.0),
        own,
        _known_of_sensors(platform),
        {**gain_ranges(platform), **platform.ranges},
        platform.intervals,
        frozenset(platform.kept_as_given or ()),
        platform.hull.length,
        float(np.mean(thrusters)) if thrusters else 0.0,
        platform.hull.height,
        platform.hull.width,
        platform.mass * platform.gravity,
        fin_normal=fin_normals(platform),
        fin_place=fin_places(platform),
        cable=(platform.hull.cable_diameter or 0.0, platform.hull.cable_length or 0.0),
        water_weight=platform.water_density * platform.gravity,
    )


def _without_gains(platform: Platform, own: Mapping[str, Declared], limit: Floats) -> Floats:
    """Limits (actuators, 2) [N] without the gains that stand in columns of their own."""
    gains = {key: number.value for key, number in own.items() if number.column in OWN_GAINS and number.value != 1.0}
    if not gains:
        return limit
    gain = [gains.get(gain_key(name), 1.0) for name in platform.actuator_names]
    return np.asarray(limit / np.array(gain).reshape(-1, 1))


def gain_ranges(platform: Platform) -> dict[str, Range]:
    """Ranges of the gains of all thrusters, by column, that keep the maximum of each within its range in the file."""
    low, high = 0.0, np.inf
    for actuator in platform.actuators:
        given = platform.ranges.get(f"actuators.{actuator.name}.maximum")
        if isinstance(actuator, Thruster) and given is not None and actuator.maximum > 0.0:
            low, high = max(low, given.low / actuator.maximum), min(high, given.high / actuator.maximum)
    return dict.fromkeys(("thrust_gain", "yaw_torque_gain"), Range(low, high, "1")) if np.isfinite(high) else {}


def _known_of_sensors(platform: Platform) -> dict[str, float]:
    """Numbers of sensors and stamps that the platform's file gives, by column."""
    return {
        f"{effect}.{name}": value
        for effect, parameters in effects_of(platform).items()
        for name, value in parameters.items()
        if effect not in EFFECT_BIT and f"{effect}.{name}" in COLUMN
    }
