"""The numbers of vehicles in six degrees of freedom, laid out for compiled loops."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.errors import CocorosimError

FIN_SIZE = 7
FIN_PLACE, FIN_NORMAL, FIN_LIFT = 0, 3, 6
"""Columns of a fin: place (3) [m; body], normal (3) [body], lift per angle and square of speed [kg/m]."""


class Bodies(NamedTuple):
    """Numbers of vehicles, one row for each; all about the origin of the body axes, forces first, then moments.

    Rows and columns of matrices are in the order of u, v, w, p, q, r.
    """

    mass_matrix: Floats  # (robots, 6, 6) rigid body and added mass [kg, kg m, kg m^2]
    inverse: Floats  # (robots, 6, 6) of it
    linear: Floats  # (robots, 6, 6) force = -linear @ nu [N s/m, N s, N m s]
    quadratic: Floats  # (robots, 6, 6) force = -quadratic @ (|nu| nu) [kg/m, kg, N m s^2 and so on]
    lift: Floats  # (robots, 6, 6) force = -|u| lift @ nu [kg/m, kg, kg m]
    hydrostatic: Floats  # (robots, 4) upward force [N], and weight and buoyancy times their places (3) [N m; body]
    wrench: Floats  # (robots, actuators, 6) force and moment per newton of a thruster [1, m; body]; zero for fins
    limit: Floats  # (robots, actuators, 2) force [N] or angle [rad] at command +1 and -1, both positive
    curve: Floats  # (robots, actuators, columns) see terms.curve; no columns where all are plain
    fins: Floats  # (robots, actuators, FIN_SIZE); zero for thrusters
    gravity: Floats  # (robots,) [m/s^2], which accelerometers show


class Body(NamedTuple):
    """One of `Bodies`, and the water."""

    mass_matrix: Floats  # (6, 6)
    inverse: Floats  # (6, 6)
    linear: Floats  # (6, 6)
    quadratic: Floats  # (6, 6)
    lift: Floats  # (6, 6)
    hydrostatic: Floats  # (4,)
    wrench: Floats  # (actuators, 6)
    limit: Floats  # (actuators, 2)
    curve: Floats  # (actuators, columns)
    fins: Floats  # (actuators, FIN_SIZE)
    flow: Floats  # velocity of the water, see water.flow; empty in still water


@dataclass(frozen=True)
class Fin:
    """A control surface with its span across the flow; its lift grows with the angle until its limit.

    place: of its centre of pressure [m; body]. normal: (3,) unit vector of the force that a positive angle gives where
    water comes from ahead [body]. area: [m^2]. slope: of the lift coefficient [1/rad]. limit: largest angle [rad].
    """

    place: tuple[float, float, float]
    normal: tuple[float, float, float]
    area: float
    slope: float


@dataclass(frozen=True)
class Vehicle:
    """A vehicle in words of hydrodynamics; body axes forward-left-up, everything about their origin.

    mass [kg]; inertia (3, 3) about the centre of gravity [kg m^2]; added_mass, linear, quadratic, lift: (6, 6), see
    Bodies; centre_of_gravity, centre_of_buoyancy (3,) [m; body]; weight, buoyancy [N]; wrench (actuators, 6), limit
    (actuators, 2) and curve (actuators, columns) as in Bodies; fins: those actuators that are fins, by number;
    density of the water [kg/m^3], which fins feel; gravity [m/s^2].
    """

    mass: float
    inertia: Floats
    centre_of_gravity: Floats = field(default_factory=lambda: np.zeros(3))
    centre_of_buoyancy: Floats = field(default_factory=lambda: np.zeros(3))
    weight: float = 0.0
    buoyancy: float = 0.0
    added_mass: Floats = field(default_factory=lambda: np.zeros((6, 6)))
    linear: Floats = field(default_factory=lambda: np.zeros((6, 6)))
    quadratic: Floats = field(default_factory=lambda: np.zeros((6, 6)))
    lift: Floats = field(default_factory=lambda: np.zeros((6, 6)))
    wrench: Floats = field(default_factory=lambda: np.zeros((0, 6)))
    limit: Floats = field(default_factory=lambda: np.zeros((0, 2)))
    curve: Floats = field(default_factory=lambda: np.zeros((0, 0)))
    fins: Mapping[int, Fin] = field(default_factory=dict)
    density: float = 1000.0
    gravity: float = 9.81

    def mass_matrix(self) -> Floats:
        """(6, 6) rigid body and added mass about the origin.

        M_RB = [m 1, -m S(r_g); m S(r_g), I_g - m S(r_g)^2] (Fossen 2011, eq. 3.44), with S(a) b = a x b.
        """
        arm = cross_matrix(self.centre_of_gravity)
        total = np.array(self.added_mass, dtype=np.float64)
        total[:3, :3] += self.mass * np.eye(3)
        total[:3, 3:] -= self.mass * arm
        total[3:, :3] += self.mass * arm
        total[3:, 3:] += self.inertia - self.mass * arm @ arm
        return total


def cross_matrix(arm: Floats) -> Floats:
    """S(a) (3, 3), with S(a) b = a x b for every b."""
    x, y, z = arm
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def build_bodies(vehicles: list[Vehicle]) -> Bodies:
    """The numbers of vehicles for compiled loops; who has fewer actuators than others gets ones without force.

    Raises CocorosimError where a mass matrix is not symmetric or not positive definite: such a vehicle would give
    energy without end.
    """
    masses = np.array([_checked_mass(vehicle) for vehicle in vehicles])
    count, actuators = len(vehicles), max(len(vehicle.wrench) for vehicle in vehicles)
    columns = max(vehicle.curve.shape[1] for vehicle in vehicles)
    bodies = Bodies(
        masses,
        np.linalg.inv(masses),
        np.array([vehicle.linear for vehicle in vehicles], dtype=np.float64),
        np.array([vehicle.quadratic for vehicle in vehicles], dtype=np.float64),
        np.array([vehicle.lift for vehicle in vehicles], dtype=np.float64),
        np.array([_hydrostatic(vehicle) for vehicle in vehicles]),
        np.zeros((count, actuators, 6)),
        np.zeros((count, actuators, 2)),
        np.zeros((count, actuators, columns)),
        np.zeros((count, actuators, FIN_SIZE)),
        np.array([vehicle.gravity for vehicle in vehicles]),
    )
    for robot, vehicle in enumerate(vehicles):
        bodies.wrench[robot, : len(vehicle.wrench)] = vehicle.wrench
        bodies.limit[robot, : len(vehicle.limit)] = vehicle.limit
        bodies.curve[robot, : len(vehicle.curve), : vehicle.curve.shape[1]] = vehicle.curve
        for number, fin in vehicle.fins.items():
            lift = 0.5 * vehicle.density * fin.area * fin.slope
            bodies.fins[robot, number] = [*fin.place, *fin.normal, lift]
    return bodies


@kernel
def body_of(bodies: Bodies, robot: int, flow: Floats) -> Body:
    """One vehicle in the water of `flow`; the arrays are views."""
    return Body(
        bodies.mass_matrix[robot],
        bodies.inverse[robot],
        bodies.linear[robot],
        bodies.quadratic[robot],
        bodies.lift[robot],
        bodies.hydrostatic[robot],
        bodies.wrench[robot],
        bodies.limit[robot],
        bodies.curve[robot],
        bodies.fins[robot],
        flow,
    )


def _hydrostatic(vehicle: Vehicle) -> Floats:
    moment = vehicle.buoyancy * np.asarray(vehicle.centre_of_buoyancy)
    moment = moment - vehicle.weight * np.asarray(vehicle.centre_of_gravity)
    return np.array([vehicle.buoyancy - vehicle.weight, *moment])


def _checked_mass(vehicle: Vehicle) -> Floats:
    mass = vehicle.mass_matrix()
    if not np.allclose(mass, mass.T, rtol=1e-9, atol=0.0):
        raise CocorosimError("The mass matrix with added mass is not symmetric; write a symmetric added mass.")
    least = float(np.linalg.eigvalsh(mass).min())
    if least <= 0.0:
        raise CocorosimError(
            f"The mass matrix with added mass has the eigenvalue {least:.6g}, where all must be greater than zero; "
            "look at the signs of added mass and inertia."
        )
    return mass
