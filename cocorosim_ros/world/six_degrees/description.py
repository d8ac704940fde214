"""From what a platform says of its six degrees of freedom to a vehicle."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts import fin
from cocorosim_ros.scenario.parts.allocation import wrench_of
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.six_degrees import AXES, SixDegrees
from cocorosim_ros.scenario.parts.sliding_mass import SlidingMass
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.world.six_degrees.vehicle import Fin, Vehicle, check_dissipation, checked_mass_matrix


def vehicle_of(platform: Platform) -> Vehicle:
    """The vehicle of a platform with six degrees of freedom.

    Raises CocorosimError for a mass that no body has, and for linear damping that gives energy.
    """
    six = platform.six_degrees
    if six is None:
        raise CocorosimError(f"{platform.origin}: lacks 'six_degrees', which motion with roll and pitch needs; add it.")
    vehicle = Vehicle(
        mass=platform.mass,
        inertia=_inertia(six),
        centre_of_gravity=np.array(six.centre_of_gravity),
        centre_of_buoyancy=np.array(six.centre_of_buoyancy),
        weight=platform.mass * platform.gravity,
        buoyancy=platform.water_density * platform.gravity * six.volume,
        added_mass=_matrix(six, "added_mass", (*six.added_mass, *six.added_inertia)),
        linear=_matrix(six, "linear_damping", (*six.linear_damping, *six.linear_turn_damping)),
        quadratic=_matrix(six, "quadratic_damping", (*six.quadratic_damping, *six.quadratic_turn_damping)),
        lift=_matrix(six, "lift", (0.0,) * 6),
        wrench=np.array([_wrench(part) for part in platform.actuators]).reshape(-1, 6),
        limit=platform.actuator_limits(),
        fins={
            number: Fin(part.position, part.direction, part.area, _slope(part), part.trim or 0.0)
            for number, part in enumerate(platform.actuators)
            if isinstance(part, fin.Fin)
        },
        sliding={
            number: part.mass * np.array(part.direction)
            for number, part in enumerate(platform.actuators)
            if isinstance(part, SlidingMass)
        },
        density=platform.water_density,
        gravity=platform.gravity,
    )
    try:
        checked_mass_matrix(vehicle)
        check_dissipation(vehicle)
    except CocorosimError as error:
        raise CocorosimError(f"{platform.origin}: 'six_degrees' cannot be: {error}") from error
    return vehicle


def _inertia(six: SixDegrees) -> Floats:
    xx, yy, zz, xy, xz, yz = (*six.inertia, 0.0, 0.0, 0.0)[:6]
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _matrix(six: SixDegrees, name: str, diagonal: Sequence[float]) -> Floats:
    matrix = np.diag(np.array(diagonal, dtype=np.float64))
    for part in six.couplings:
        if part.matrix == name:
            force, motion = AXES.index(part.force), AXES.index(part.motion)
            matrix[force, motion] = part.number.value
            if name == "added_mass":
                matrix[motion, force] = part.number.value
    return matrix


def _slope(part: fin.Fin) -> float:
    """Of the lift coefficient [1/rad], with the fin's own gain."""
    return part.lift_slope if part.gain is None else part.gain * part.lift_slope


def _wrench(part: object) -> Floats:
    """(6,) force and moment per newton; none of a fin or a sliding mass."""
    return wrench_of(part) if isinstance(part, Thruster) else np.zeros(6)
