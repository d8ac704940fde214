"""A vehicle in words of hydrodynamics, before it becomes rows of numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError

ROUNDING = 1e-9  # of the largest entry or eigenvalue, by which a matrix may miss what it has to be


@dataclass(frozen=True)
class Fin:
    """A control surface with its span across the flow; its lift grows with the angle.

    place: of its centre of pressure [m; body]. normal: (3,) unit vector of the force that a positive angle gives where
    water comes from ahead [body]. area: [m^2]. slope: of the lift coefficient [1/rad]. trim: angle at command zero
    [rad].
    """

    place: tuple[float, float, float]
    normal: tuple[float, float, float]
    area: float
    slope: float
    trim: float = 0.0


@dataclass(frozen=True)
class Vehicle:
    """A vehicle in words of hydrodynamics; body axes forward-left-up, everything about their origin.

    mass [kg]; inertia (3, 3) about the centre of gravity [kg m^2]; added_mass, linear, quadratic, lift: (6, 6), see
    bodies.Bodies; centre_of_gravity, centre_of_buoyancy (3,) [m; body]; weight, buoyancy [N]; wrench (actuators, 6) and
    limit (actuators, 2) as there; fins: those actuators that are fins, by number; sliding: (3,) mass times way per
    metre of those that are sliding masses [kg; body], by number; density of the water [kg/m^3], which
    fins feel; gravity [m/s^2].
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
    fins: Mapping[int, Fin] = field(default_factory=dict)
    sliding: Mapping[int, Floats] = field(default_factory=dict)
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

    def moments_of_weight(self) -> Floats:
        """(3,) buoyancy and weight times their places, B r_b - W r_g [N m; body]."""
        lifted = self.buoyancy * np.asarray(self.centre_of_buoyancy)
        return np.asarray(lifted - self.weight * np.asarray(self.centre_of_gravity))


def cross_matrix(arm: Floats) -> Floats:
    """S(a) (3, 3), with S(a) b = a x b for every b."""
    x, y, z = arm
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def checked_mass_matrix(vehicle: Vehicle) -> Floats:
    """(6, 6) the mass matrix. Raises CocorosimError where it is not symmetric or not positive definite."""
    mass = vehicle.mass_matrix()
    if not np.allclose(mass, mass.T, rtol=ROUNDING, atol=0.0):
        raise CocorosimError("The mass matrix with added mass is not symmetric; write a symmetric added mass.")
    least = float(np.linalg.eigvalsh(mass).min())
    if least <= 0.0:
        raise CocorosimError(
            f"The mass matrix with added mass has the eigenvalue {least:.6g}, where all must be greater than zero; "
            "look at the signs of added mass and inertia."
        )
    return mass


def check_dissipation(vehicle: Vehicle) -> None:
    """Nothing, if linear damping takes energy or none at every motion: nu D nu >= 0, by the symmetric part of D.

    Raises CocorosimError otherwise.
    """
    symmetric = 0.5 * (vehicle.linear + vehicle.linear.T)
    of_each = np.linalg.eigvalsh(symmetric)
    if of_each[0] < -ROUNDING * np.abs(of_each).max():
        raise CocorosimError(
            "The linear damping gives energy at some motion, since the symmetric part of its matrix has the eigenvalue "
            f"{of_each[0]:.6g}, where none may be less than zero; look at the signs of the couplings, of which the "
            "square of the sum of both between two axes is at most four times the product of the diagonal's numbers."
        )
