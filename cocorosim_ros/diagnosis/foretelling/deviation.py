"""Deviations of readings: what a stream read less what a model expects it to show on a course."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import ANGLES, KIND_NAMES, KINDS_OF_STREAM
from cocorosim_ros.diagnosis.filter.reading import NO_MOTORS, Along, expected_along
from cocorosim_ros.diagnosis.tracks.body_velocity import through_water
from cocorosim_ros.diagnosis.tracks.columns import SENSORS as SENSORS_IN_ROW
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.world.sensors import KINDS, SENSORS
from cocorosim_ros.world.sensors.errors import NEUTRAL, changes_of
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.terms.motors import Motors

RECORDED = {topic: sensor.recorded for topic, sensor in SENSORS.items() if sensor.recorded and sensor.recorded.drawn}
KIND_OF_TOPIC = {topic: KIND_NAMES.index(recorded.drawn) for topic, recorded in RECORDED.items()}
"""Kind of reading, as its code, that is drawn for a stream; by topic."""


def unit_of_kind(kind: int) -> str:
    """The SI unit of a kind of reading."""
    return KINDS[KIND_NAMES[kind]].unit


def deviation(track: Track, chosen: Flags, course: Smoothed, row: Floats) -> Floats:
    """Deviations (n,) of readings of one kind: readings less expectations on a smoothed course, angles the shorter way.

    chosen (m,): flags of the readings in the track's timeline; row: the numbers of the model, sensors' errors and the
    errors of stamps among them.
    """
    kind = int(track.timeline.kind[chosen][0])
    topic = next(name for name, each in KINDS_OF_STREAM.items() if kind in each)
    stamp, timing = track.timeline.stamp[chosen], track.timeline.timing_under(row)
    moment = (stamp - timing.latency[topic]) / (1.0 + timing.skew[topic])
    state = np.array([np.interp(moment, course.time, column) for column in course.mean.T]).T
    of_water = KINDS[KIND_NAMES[kind]].of_water
    water = through_water(track, moment, state, row) if of_water else np.zeros((len(moment), 4))
    motors, forces = _motors(track, kind, moment, row)
    along = Along(stamp, np.column_stack([state[:, :STATE_SIZE], forces]), water)
    shown = np.empty(len(stamp))
    expected_along(kind, along, motors, row[SENSORS_IN_ROW], shown)
    deviation = track.timeline.value[chosen] - track.filter.law_shift(row)[chosen] - shown
    return np.mod(deviation + np.pi, 2.0 * np.pi) - np.pi if kind in ANGLES else deviation


def _motors(track: Track, kind: int, moment: Floats, row: Floats) -> tuple[Motors, Floats]:
    """Make the motors and their forces (n, actuators) [N] at moments (n,) [s]; none where readings do not feel them.

    A force is a mean from each grid point to the next, and belongs to the middle between them.
    """
    if not _feels_motors(kind, row[SENSORS_IN_ROW]):
        return NO_MOTORS, np.zeros((len(moment), 0))
    vehicle, middle = track.actuation.vehicle, track.timeline.grid.moments + 0.5 * track.timeline.grid.step
    forces = track.actuation.drive(row).force.T[: len(vehicle.is_pump)]
    force = np.array([np.interp(moment, middle, each) for each in forces]).T
    return Motors(vehicle.is_pump, vehicle.actuator_curve, vehicle.actuator_limit), force


def _feels_motors(kind: int, numbers: Floats) -> bool:
    """Tell whether the errors of a kind of readings, by numbers in the order of NEUTRAL, depend on what motors do."""
    return any(
        "motors" in change.takes and any(numbers[column] != NEUTRAL[column] for column in columns)
        for change, columns in changes_of(KIND_NAMES[kind])
    )
