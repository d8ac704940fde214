"""The robot of the pictures of effects: the platform `lily` in numbers."""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.terms.moment import add_thrust
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles
from cocorosim_ros.world.vehicle_model.vehicles import PARAMETER_COLUMNS
from site_builder.plain_python import plain


class Lily(NamedTuple):
    """The robot of the pictures."""

    parameters: Floats  # (parameters,) see vehicle_model.vehicles
    wrench: Floats  # (actuators, 4) X, Y, Z, N per newton [1, 1, 1, m; body]
    limit: Floats  # (actuators, 2) force at command +1 and -1 [N]
    is_pump: Flags  # (actuators,)
    curve: Floats  # (actuators, columns) see terms.curve

    def number(self, name: str) -> float:
        """A parameter by its name, SI units."""
        return float(self.parameters[PARAMETER_COLUMNS[name]])

    def pushed(self, force: Floats) -> Floats:
        """(4,) wrench of the thrusters [N, N m; body] at the forces (actuators,) [N] of all actuators."""
        total = np.zeros(4)
        plain(add_thrust)(force, self.wrench, self.is_pump, total)
        return total

    @property
    def thrust(self) -> float:
        """Force of all thrusters at full command [N; forwards]."""
        return float(self.pushed(self.limit[:, 0])[0])

    @property
    def speed(self) -> float:
        """Speed [m/s] where quadratic drag is as large as that thrust."""
        return math.sqrt(self.thrust / self.number("drag"))

    @property
    def turning(self) -> float:
        """Yaw rate [rad/s] where the thruster on one side alone turns it."""
        moment = float(np.abs(self.wrench[~self.is_pump, 3] * self.limit[~self.is_pump, 0]).max())
        return math.sqrt(moment / self.number("yaw_drag"))


@cache
def lily() -> Lily:
    """The platform `lily` in numbers."""
    vehicles = build_vehicles([load_platform("lily")])
    return Lily(
        parameters=vehicles.parameters[0, 0],
        wrench=vehicles.actuator_wrench[0, 0],
        limit=vehicles.actuator_limit[0, 0],
        is_pump=vehicles.is_pump[0, 0],
        curve=vehicles.actuator_curve[0, 0],
    )
