"""Forces that the actuators of a robot deliver between the grid points of its track, given the recorded commands."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE
from cocorosim_ros.diagnosis.filter.commands import mean_forces
from cocorosim_ros.diagnosis.filter.records import Drive, Grid
from cocorosim_ros.diagnosis.tracks.columns import ACTUATING, COLUMN, COMMAND_DELAY
from cocorosim_ros.diagnosis.tracks.lately import Lately
from cocorosim_ros.diagnosis.tracks.lateness import clocks_of, common_lateness
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.tilted_fins import FIN_NUMBERS, Angles, tilted_fins
from cocorosim_ros.diagnosis.tracks.tilted_hull import TAKEN, TiltedHull
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.motion.actuation import ACTUATION_BITS
from cocorosim_ros.world.state.state import X, Z
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.vehicle_model.vehicles import LAW_BITS, Body

_TILTED = [*TAKEN, *FIN_NUMBERS]  # columns of the numbers that the forces of a tilted hull and its fins depend on


class Actuation:
    """The actuators of one track: recorded commands to forces, under a row of numbers of a model.

    before: number of steps of the grid before its begin, from which on the actuators are followed; until then they are
    off. It matters for actuators that remember what they did, as late ones.
    """

    def __init__(self, vehicle: VehicleModel, log: RobotLog, grid: Grid, before: int = 0) -> None:
        self.vehicle, self.grid = vehicle, grid
        self._log, self._before, self._clocks = log, before, clocks_of(log)
        self._lately: Lately[tuple[Floats, Floats]] = Lately()
        self._hull = TiltedHull(log, grid)
        self._with_hull: Lately[Floats] = Lately()

    def drive(self, row: Floats, with_rates: bool = False) -> Drive:
        """Forces and neighbours that act on the robot from each grid point to the next, under a row (columns,).

        The rates at which forces change are computed where a law in the row may need them, or `with_rates`; they are
        zero elsewhere.
        """
        body = self.vehicle.actuating_body(row)
        if with_rates:
            body = body._replace(active=body.active | LAW_BITS)
        acting = (body.active & ACTUATION_BITS, row[ACTUATING].tobytes(), self._delay(row))
        force, rate = self._lately.once(acting, lambda: self._tilted(*self._forces(row, body)))
        if self._hull.is_known:
            force = self._with_hull.once((acting, row[_TILTED].tobytes()), lambda: self._on_hull(force, row))
        return Drive(force, rate, self.vehicle.surroundings.around)

    def _forces(self, row: Floats, body: Body) -> tuple[Floats, Floats]:
        begin, step, points = self.grid
        whole = Grid(begin - self._before * step, step, points + self._before)
        force, rate = mean_forces(self._times(row), self._log.acts.command, body, whole)
        return force[self._before :], rate[self._before :]

    def _times(self, row: Floats) -> Floats:
        """Moments [s] from which the commands act under a row (columns,), by the stamps of the readings."""
        delay = self._delay(row)
        time = self._log.acts.time
        return time if delay == 0.0 else time + delay

    def _delay(self, row: Floats) -> float:
        """Time [s] by which commands act late under a row (columns,), and by which all readings are late."""
        return float(row[COLUMN[COMMAND_DELAY]]) + common_lateness(row, self._clocks)

    def _tilted(self, force: Floats, rate: Floats) -> tuple[Floats, Floats]:
        """Forces and rates (points, acting): the actuators', then what roll and pitch add to the thrust's wrench."""
        if self._turns is None:
            return force, rate
        added = [self._added(self._turns, numbers) for numbers in (force, rate)]
        if self.vehicle.fin_normal.any():
            force = force + self._angles_to_level
        return np.hstack([force, added[0]]), np.hstack([rate, added[1]])

    def _on_hull(self, force: Floats, row: Floats) -> Floats:
        """Forces (points, acting) with what roll and pitch add to those of the hull, under a row (columns,)."""
        commanded = len(self.vehicle.actuator_wrench)  # what the tilt adds stands behind the actuators
        added = force[:, commanded:] + self._hull.wrench(row)
        if self.vehicle.fin_normal.any():
            to_level = force[:, :commanded]
            angles = Angles(to_level - self._angles_to_level, to_level)
            added = added + tilted_fins(self.vehicle, self._hull.flow, angles, row)
        return np.hstack([force[:, :commanded], added])

    @cached_property
    def _angles_to_level(self) -> Floats:
        """Angles (points, actuators) that roll and pitch add to those of fins to level flow [rad]; 0 of others.

        Level flow u meets a normal n, turned by R, with u (R n)_x in place of u n_x; the lift u d - V_n falls by that.
        A hull that pitches at a rate q moves a fin at x and z along its normal by q (n_x z - n_z x), where its speed
        is known. Assumes: small angles to the level, as the law of fins does.
        """
        assert self._turns is not None
        normals, places = self.vehicle.fin_normal, self.vehicle.fin_place
        angles = normals[:, X] - np.einsum("nj,aj->na", self._turns[:, X], normals)
        if self._hull.is_known:
            arms = normals[:, Z] * places[:, X] - normals[:, X] * places[:, Z]
            angles = angles + self._hull.nodding[:, None] * arms
        return np.asarray(angles)

    def _added(self, turns: Floats, force: Floats) -> Floats:
        """Difference (points, 4) of the thrust in level axes and in the robot's own, of forces (points, actuators).

        The moment is that about the robot's own upward axis.
        """
        thrusters = ~self.vehicle.is_pump
        thrust = force[:, thrusters] @ self.vehicle.actuator_wrench[thrusters, :3]
        return np.column_stack([np.einsum("nij,nj->ni", turns, thrust) - thrust, np.zeros(len(force))])

    @cached_property
    def _turns(self) -> Floats | None:
        """Rotations (points, 3, 3) from the robot's axes to level ones, in the middle between grid points."""
        attitude = self._log.attitude
        if attitude is None:
            return None
        return attitude.turns(np.asarray(self.grid.begin + (np.arange(self.grid.points) + 0.5) * self.grid.step))

    def thrust(self, drive: Drive) -> Floats:
        """Wrench (points, 4) of the thrusters [N, N, N, N m; body]."""
        thrusters = ~self.vehicle.acting_pump
        return np.asarray(drive.force[:, thrusters] @ self.vehicle.acting_wrench[thrusters])

    def lift(self, drive: Drive) -> Floats:
        """Force (points,) of pumps and thrusters along the robot's upward axis [N], without what the hull adds."""
        commanded = drive.force[:, : len(self.vehicle.actuator_wrench)]
        return np.asarray(commanded @ self.vehicle.actuator_wrench[:, Z])

    def course_along(self, smoothed: Smoothed, row: Floats) -> Course:
        """Quantities that laws may depend on, along a smoothed course, with the actuators under a row (columns,)."""
        drive, vehicle = self.drive(row, with_rates=True), self.vehicle
        lower, upper, around, own = vehicle.surroundings
        return Course(
            smoothed.time, smoothed.mean, self.thrust(drive), _forces_alone(vehicle, drive.force), drive.rate,
            vehicle.acting_pump,
            (lower, upper), around[: len(smoothed.time)], own,
        )  # fmt: skip

    def nominal_force(self) -> Floats:
        """Forward and leftward force (points, 2) of the thrusters [N; body] under the platform's own numbers."""
        return self.thrust(self.drive(self.vehicle.row))[:, PLANE]


def _forces_alone(vehicle: VehicleModel, force: Floats) -> Floats:
    """Forces (points, acting) [N] with zeros in the place of the angles of rudders."""
    if vehicle.acting_wrench.any(axis=1).all():
        return force
    return np.where(vehicle.acting_wrench.any(axis=1), force, 0.0)
