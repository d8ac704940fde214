"""The robots of a run that roll and pitch, beside the state that all robots share."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.motion.motion import Stepping
from cocorosim_ros.world.sensors.readings import Readings
from cocorosim_ros.world.six_degrees import state as six
from cocorosim_ros.world.six_degrees.attitude import attitude_of
from cocorosim_ros.world.six_degrees.swimming import Around, Felt, Moment, School, feel, swim
from cocorosim_ros.world.state.state import HEAVE, SURGE, YAW, X, Z
from cocorosim_ros.world.surroundings.tank import Tank


class Rolling:
    """The state in six degrees of freedom of some robots in all runs.

    `state`: (runs, vehicles, six.STATE_SIZE). What walls, neighbours and statistics look at is written into the rows
    that these robots have among all others (`seen`), see six_degrees.levelled.
    """

    def __init__(self, school: School, seen: Floats, flow: Floats, tank: Tank) -> None:
        """At the places and headings of `seen` (runs, robots, columns), upright and at rest, commands zero."""
        self._school = school
        self._around = Around(flow, tank, np.zeros(school.bodies.wrench.shape[1]))
        start = seen[:, school.number]
        self.state: Floats = np.zeros((*start.shape[:2], six.STATE_SIZE))
        self.state[..., : six.ATTITUDE] = start[..., X : Z + 1]
        for run, vehicle in np.ndindex(*start.shape[:2]):
            self.state[run, vehicle, six.ATTITUDE : six.SURGE] = attitude_of(0.0, 0.0, start[run, vehicle, YAW])
        self._yaw: Floats = start[..., YAW].copy()  # (runs, vehicles) [rad], not wrapped
        self._command: Floats = np.zeros((*seen.shape[:2], self._around.effort.shape[0]))  # that held in the last tick

    def feel(self, time: float, readings: Readings) -> None:
        """Write what inertial sensors and speed logs of these robots show at `time` [s] into `readings`."""
        felt = Felt(readings.angular_rate, readings.specific_force, readings.velocity, readings.ground_velocity)
        feel(self.state, self._command, self._school, self._around, time, felt)

    def move(self, command: Floats, begin: float, stepping: Stepping, seen: Floats) -> None:
        """Advance by a tick that begins at `begin` [s], under `command` (runs, robots, actuators), and show it."""
        self._command[...] = command[..., : self._command.shape[2]]
        seen[:, self._school.number, YAW] = self._yaw  # motion in four degrees has turned these rows as well
        swim(self.state, self._command, self._school, self._around, Moment(begin, stepping), seen)
        self._yaw = seen[:, self._school.number, YAW].copy()

    def put_attitudes(self, attitude: Floats) -> None:
        """Write the quaternions of these robots into `attitude` (runs, robots, 4)."""
        attitude[:, self._school.number] = self.state[..., six.ATTITUDE : six.SURGE]

    def put_velocities(self, velocity: Floats) -> None:
        """Write u, v, w over ground along the body's own axes into `velocity` (runs, robots, 3) [m/s; body]."""
        velocity[:, self._school.number] = self.state[..., six.SURGE : six.ROLL_RATE]


def level_attitudes(state: Floats) -> Floats:
    """(runs, robots, 4) quaternions x y z w of robots that neither roll nor pitch; `state` (runs, robots, columns)."""
    half = 0.5 * state[..., YAW]
    zero = np.zeros_like(half)
    return np.stack([zero, zero, np.sin(half), np.cos(half)], axis=-1)


def level_velocities(state: Floats) -> Floats:
    """(runs, robots, 3) u, v, w over ground [m/s; body] of such robots."""
    return state[..., SURGE : HEAVE + 1].copy()
