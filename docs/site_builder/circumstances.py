"""The circumstances of the pictures of effects: a Lily at full speed, and what else an effect may ask for."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.jet import JET_COLUMNS
from cocorosim_ros.world.terms.moment import NEIGHBOUR_SIZE, Moment
from site_builder.lily import lily


@dataclass(frozen=True, kw_only=True)
class Circumstances:
    """One moment, as a picture has it; fields are called as in terms.regressors where they stand there."""

    u: float  # m/s, body, through the water, as v, w
    thrust: float  # N, forwards
    v: float = 0.0
    w: float = 0.0
    r: float = 0.0  # rad/s
    x: float = 0.0  # m, world, as y, z
    y: float = 0.0
    z: float = -0.5
    yaw: float = 0.0  # rad
    t: float = 0.0  # s
    side_thrust: float = 0.0  # N, to the left
    command: float = 1.0  # of all thrusters
    wall_distance: float = math.inf  # m
    neighbour_distance: float = math.inf  # m, to one straight ahead that swims away at the same thrust

    @property
    def force(self) -> Floats:
        """(actuators,) [N]: the thrust, in equal parts from all thrusters."""
        robot = lily()
        return np.where(robot.is_pump, 0.0, self.thrust / np.count_nonzero(~robot.is_pump))

    @property
    def row(self) -> Floats:
        """The state, with the forces of the actuators behind it (state.state)."""
        return np.array([self.x, self.y, self.z, self.yaw, self.u, self.v, self.w, self.r, *self.force])

    @property
    def relative(self) -> Floats:
        """(4,) velocity through the water [m/s, rad/s; body]."""
        return np.array([self.u, self.v, self.w, self.r])

    @property
    def moment(self) -> Moment:
        """Circumstances beside the state."""
        robot = lily()
        near = [[self.x + self.neighbour_distance, self.y, self.z, self.thrust, 0.0]]
        return Moment(
            time=self.t,
            thrust=np.array([self.thrust, self.side_thrust, 0.0, 0.0]),
            force=self.force,
            actuator_wrench=robot.wrench,
            is_pump=robot.is_pump,
            pump=0.0,
            pump_rate=0.0,
            drag=robot.number("drag"),
            yaw_drag=robot.number("yaw_drag"),
            clearance=self.wall_distance,
            neighbours=np.array(near) if math.isfinite(self.neighbour_distance) else np.empty((0, NEIGHBOUR_SIZE)),
            own=-1,
            advance_loss=0.0,
            jets=np.empty((0, JET_COLUMNS)),
        )


def cruising(**quantities: float) -> Circumstances:
    """A Lily at full thrust and the speed that it comes to, but for the `quantities`."""
    return replace(_undisturbed(), **quantities)


@cache
def _undisturbed() -> Circumstances:
    return Circumstances(u=lily().speed, thrust=lily().thrust)
