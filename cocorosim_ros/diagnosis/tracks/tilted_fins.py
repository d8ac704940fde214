"""Forces and yaw moment that roll and pitch add to those of fins, along level axes of the same heading.

A fin lifts along its own normal n, which the rotation R from body axes to level ones turns, by the water that it meets
along the hull. The model of a diagnosis has it lift along n, by level water. So what is missing is

    R n L(v, d) - n L(V, D),    L(v, d) = 1/2 rho S c |v_x| (v_x d - n v),

of the velocity v in body axes and V = R v in level ones, with the angle d to the hull and D, of the model, to level
flow. A hull that pitches at the rate q moves a fin at x and z along its normal by q (n_x z - n_z x). The moment is
about the hull's own upward axis. Velocity, turn rate and attitude are those recorded, as for the forces of the hull.
Source: Prestero (2001), section 4.6, as in `effects.fin`; levelled axes as in `streams.attitude`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.tilted_hull import Flow, Motion
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects import FINS
from cocorosim_ros.world.state.state import X, Y, Z

_NUMBERS = ("actuator", "area", "slope", "density", "gain", "trim")
FIN_NUMBERS = [COLUMN[f"{fin}.{number}"] for fin in FINS for number in _NUMBERS]
"""Columns of the numbers that these forces depend on."""


class Angles(NamedTuple):
    """Angles (points, actuators) of fins [rad], without their trim: to the hull, and to level flow as the model has."""

    to_hull: Floats
    to_level: Floats


class _Fin(NamedTuple):
    """A fin: its place (3,) [m; body], normal (3,) [body], 1/2 rho S c [kg/m], and trim [rad]."""

    place: Floats
    normal: Floats
    coefficient: float
    trim: float

    def lift(self, motion: Motion, angle: Floats) -> Floats:
        """Lift (points,) [N] in a motion, at angles (points,) to its axes [rad]."""
        ahead = motion.velocity[:, X] - self.place[Y] * motion.turn_rate
        sideways = motion.velocity[:, Y] + self.place[X] * motion.turn_rate
        nodding = motion.pitch_rate * (self.normal[X] * self.place[Z] - self.normal[Z] * self.place[X])
        across = np.column_stack([ahead, sideways, motion.velocity[:, Z]]) @ self.normal + nodding
        return np.asarray(self.coefficient * np.abs(ahead) * (ahead * (angle + self.trim) - across))


def tilted_fins(vehicle: VehicleModel, flow: Flow, angles: Angles, row: Floats) -> Floats:
    """Forces and moment (points, 4) [N, N, N, N m; level axes] that the tilt adds; row (columns,) of a model."""
    force, moment = np.zeros((len(flow.turns), 3)), np.zeros(len(flow.turns))
    for actuator, fin in _fins(vehicle, row):
        tilted = fin.lift(flow.body, angles.to_hull[:, actuator])
        level = fin.lift(flow.level, angles.to_level[:, actuator])
        force += tilted[:, None] * (flow.turns @ fin.normal) - level[:, None] * fin.normal
        moment += (fin.place[X] * fin.normal[Y] - fin.place[Y] * fin.normal[X]) * (tilted - level)
    return np.column_stack([force, moment])


def _fins(vehicle: VehicleModel, row: Floats) -> Iterator[tuple[int, _Fin]]:
    """The fins that a row has, each behind the place of its angle among the actuators."""
    for name in FINS:
        number = {each: float(row[COLUMN[f"{name}.{each}"]]) for each in _NUMBERS}
        if number["area"] > 0.0:
            actuator = int(number["actuator"])
            coefficient = 0.5 * number["density"] * number["area"] * number["slope"] * number["gain"]
            place, normal = vehicle.fin_place[actuator], vehicle.fin_normal[actuator]
            yield actuator, _Fin(place, normal, coefficient, number["trim"])
