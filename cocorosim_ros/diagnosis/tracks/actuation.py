"""Forces that the actuators of a robot deliver between the grid points of its track, given the recorded commands."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.filter.commands import mean_forces
from cocorosim_ros.diagnosis.filter.records import Drive, Grid
from cocorosim_ros.diagnosis.tracks.columns import ACTUATING
from cocorosim_ros.diagnosis.tracks.lately import Lately
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.motion.actuation import ACTUATION_BITS
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.vehicle_model.vehicles import LAW_BITS, Body

REMEMBERED = 6  # sets of forces, because the same numbers are soon asked for again


class Actuation:
    """The actuators of one track: recorded commands to forces, under a row of numbers of a model.

    before: number of steps of the grid before its begin, from which on the actuators are followed; until then they are
    off. It matters for actuators that remember what they did, as late ones.
    """

    def __init__(self, vehicle: VehicleModel, log: RobotLog, grid: Grid, before: int = 0) -> None:
        self.vehicle, self.grid = vehicle, grid
        self._log, self._before = log, before
        self._lately: Lately[tuple[Floats, Floats]] = Lately(REMEMBERED)

    def drive(self, row: Floats, with_rates: bool = False) -> Drive:
        """Forces and neighbours that act on the robot from each grid point to the next, under a row (columns,).

        The rates at which forces change are computed where a law in the row may need them, or `with_rates`; they are
        zero elsewhere.
        """
        body = self.vehicle.body(row)
        if with_rates:
            body = body._replace(active=body.active | LAW_BITS)
        force, rate = self._lately.once(
            (body.active & ACTUATION_BITS, row[ACTUATING].tobytes()),
            lambda: self._forces(body),
        )
        return Drive(force, rate, self.vehicle.surroundings.around)

    def _forces(self, body: Body) -> tuple[Floats, Floats]:
        begin, step, points = self.grid
        whole = Grid(begin - self._before * step, step, points + self._before)
        force, rate = mean_forces(self._log.command_time, self._log.command, body, whole)
        return force[self._before :], rate[self._before :]

    def thrust(self, drive: Drive) -> Floats:
        """Wrench (points, 4) of the thrusters [N, N, N, N m; body]."""
        thrusters = ~self.vehicle.is_pump
        return np.asarray(drive.force[:, thrusters] @ self.vehicle.actuator_wrench[thrusters])

    def pump_force(self, drive: Drive) -> Floats:
        """Force (points,) of the pumps [N], upwards positive."""
        return np.asarray(drive.force[:, self.vehicle.is_pump].sum(axis=1))

    def course_along(self, smoothed: Smoothed, row: Floats) -> Course:
        """Quantities that laws may depend on, along a smoothed course, with the actuators under a row (columns,)."""
        drive, vehicle = self.drive(row, with_rates=True), self.vehicle
        lower, upper, around, own = vehicle.surroundings
        return Course(
            smoothed.time, smoothed.mean, self.thrust(drive), drive.force, drive.rate, vehicle.is_pump, (lower, upper),
            around[: len(smoothed.time)], own,
        )  # fmt: skip

    def nominal_force(self) -> Floats:
        """Forward and leftward force (points, 2) of the thrusters [N; body] under the platform's own numbers."""
        thrusters = ~self.vehicle.is_pump
        force = self.drive(self.vehicle.row).force[:, thrusters]
        return np.asarray(force @ self.vehicle.actuator_wrench[thrusters, :2])
