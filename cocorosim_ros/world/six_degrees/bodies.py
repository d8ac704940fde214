"""The numbers of vehicles in six degrees of freedom, laid out for compiled loops."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.six_degrees.vehicle import Vehicle, checked_mass_matrix

FIN_SIZE = 8
FIN_PLACE, FIN_NORMAL, FIN_LIFT, FIN_TRIM = 0, 3, 6, 7
"""Columns of a fin: place (3) [m; body], normal (3) [body], lift per angle and square of speed [kg/m], trim [rad]."""


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
    wrench: Floats  # (robots, actuators, 6) force and moment per newton of a thruster [1, m; body]; zero for others
    limit: Floats  # (robots, actuators, 2) force [N], angle [rad] or way [m] at command +1 and -1, both positive
    curve: Floats  # (robots, actuators, columns) see terms.curve; no columns where all are plain
    fins: Floats  # (robots, actuators, FIN_SIZE); zero for others
    sliding: Floats  # (robots, actuators, 3) weight of a sliding mass along its way [N; body]; zero for others
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
    sliding: Floats  # (actuators, 3)
    flow: Floats  # velocity of the water, see water.flow; empty in still water


def build_bodies(vehicles: Sequence[Vehicle], curves: Floats | None = None) -> Bodies:
    """The numbers of vehicles for compiled loops; who has fewer actuators than others gets ones without force.

    curves: (robots, actuators, columns), see terms.curve; plain if None. Raises CocorosimError where a mass matrix is
    not symmetric or not positive definite: such a vehicle would give energy without end.
    """
    masses = np.array([checked_mass_matrix(vehicle) for vehicle in vehicles])
    count, actuators = len(vehicles), max(len(vehicle.wrench) for vehicle in vehicles)
    bodies = Bodies(
        masses,
        np.linalg.inv(masses),
        np.array([vehicle.linear for vehicle in vehicles], dtype=np.float64),
        np.array([vehicle.quadratic for vehicle in vehicles], dtype=np.float64),
        np.array([vehicle.lift for vehicle in vehicles], dtype=np.float64),
        np.array([_hydrostatic(vehicle) for vehicle in vehicles]),
        np.zeros((count, actuators, 6)),
        np.zeros((count, actuators, 2)),
        np.zeros((count, actuators, 0)) if curves is None else curves,
        np.zeros((count, actuators, FIN_SIZE)),
        np.zeros((count, actuators, 3)),
        np.array([vehicle.gravity for vehicle in vehicles]),
    )
    for robot, vehicle in enumerate(vehicles):
        bodies.wrench[robot, : len(vehicle.wrench)] = vehicle.wrench
        bodies.limit[robot, : len(vehicle.limit)] = vehicle.limit
        for number, fin in vehicle.fins.items():
            lift = 0.5 * vehicle.density * fin.area * fin.slope
            bodies.fins[robot, number] = [*fin.place, *fin.normal, lift, fin.trim]
        for number, way in vehicle.sliding.items():
            bodies.sliding[robot, number] = vehicle.gravity * way
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
        bodies.sliding[robot],
        flow,
    )


def _hydrostatic(vehicle: Vehicle) -> Floats:
    return np.array([vehicle.buoyancy - vehicle.weight, *vehicle.moments_of_weight()])
