"""Starts and errors of readings on free runs of made boats: with a log in a current, and with an antenna.

The courses are SciPy's, of formulas written out in made/boats.py. In a steady and uniform current a vehicle moves as it
does in still water, carried along; an antenna shows the place of its own point.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, Stream
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.foretelling.gains import FreeRuns
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen, starts_of, unseen_parts
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, WANDER

SECONDS = 160.0
CURRENT = (0.3, -0.2)  # m/s
AHEAD, LEFT = -0.3, 0.1  # m
LOG_NOISE = 0.005  # m/s
COMPASS_NOISE = 0.02  # rad
Numbers = dict[str, float]


def drive(folder: Path, seed: int) -> tuple[Any, Any, Any]:
    """A boat whose thrusters follow at once, its truth, and its commands."""
    boat = boats.platform(folder, boats.KNOWN.replace(boats.KNOWN[boats.KNOWN.index("  thruster_lag") :], ""))
    return boat, boats.Truth(lag=0.0, choppy=0.1), boats.drive(SECONDS, seed)


def carried(folder: Path, *, with_log: bool = True) -> Evidence:
    """A drive in a current, with poses over ground and perhaps a log of the speed through the water."""
    boat, truth, commands = drive(folder, 3)
    evidence = boats.recorded(boat, truth, SECONDS, 3)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose, rows = log.streams["pose"], boats.course(truth, commands, 3)[::2]
    moved = pose.value + pose.time[:, None] * np.array([*CURRENT, 0.0, 0.0])
    noise = LOG_NOISE * np.random.default_rng([20261127, 3]).standard_normal((len(rows), 3))
    speeds = Stream(pose.time, rows[:, 4:7] + noise, np.full(3, LOG_NOISE))
    streams = {"pose": replace(pose, value=moved)}
    if with_log:
        streams["velocity"] = speeds
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def of_an_antenna(folder: Path, *, with_compass: bool) -> Evidence:
    """A drive with the places of an antenna that is not at the boat's origin, and perhaps a compass."""
    boat, truth, _ = drive(folder, 4)
    evidence = boats.recorded(boat, truth, SECONDS, 4)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose, yaw = log.streams["pose"], boats.course(truth, boats.drive(SECONDS, 4), 4)[::2, 3]
    shift = np.column_stack([
        AHEAD * np.cos(yaw) - LEFT * np.sin(yaw), AHEAD * np.sin(yaw) + LEFT * np.cos(yaw), 0.0 * yaw, 0.0 * yaw,
    ])  # fmt: skip
    noise = COMPASS_NOISE * np.random.default_rng([20261127, 4]).standard_normal((len(yaw), 1))
    compass = Stream(pose.time, yaw[:, None] + noise, np.array([COMPASS_NOISE]))
    streams = {"pose": replace(pose, value=pose.value + shift)}
    if with_compass:
        streams["compass"] = compass
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def with_numbers(base: Fit, numbers: Numbers) -> Any:
    """Rows of the recalibrated model with numbers of effects, by column."""
    rows = base.filled.copy()
    for column, value in numbers.items():
        rows[:, COLUMN[column]] = value
    return rows


def position_error(unseen: Unseen, rows: Any, sensors: Any, *, own: bool = True) -> float:
    """Root of the mean squared error of unseen positions [m]."""
    runs = FreeRuns(unseen, sensors)
    squared = runs.errors(rows) if own else runs.errors_from_given_starts(rows)
    return math.sqrt(float(np.nanmean(squared[:, runs.channels.index("position")])))


def test_a_model_with_the_current_begins_without_the_error_of_one_that_lacks_it(tmp_path: Path) -> None:
    """From its own start it errs by less than half of what it does from the other's, and a third of what that does."""
    base = base_fit(carried(tmp_path))
    unseen = unseen_parts(base)
    rows = with_numbers(base, {"steady_current.x": CURRENT[0], "steady_current.y": CURRENT[1]})
    own = position_error(unseen, rows, unseen.rows)
    assert own < position_error(unseen, unseen.rows, unseen.rows) / 3.0
    assert own < position_error(unseen, rows, unseen.rows, own=False) / 2.0


def test_a_model_with_the_current_begins_by_itself_where_places_wander(tmp_path: Path) -> None:
    """A filter without it takes the drift for the receiver's, and so begins with speeds through the water.

    From such a start the model with the current errs half as much again as from its own.
    """
    unseen = unseen_parts(base_fit(carried(tmp_path, with_log=False)))
    wandering = unseen.rows.copy()
    wandering[:, COLUMN[WANDER]] = math.log(2.0)  # m/s^0.5
    unseen = replace(unseen, rows=wandering, starts=starts_of(unseen.tracks, wandering))
    rows = wandering.copy()
    rows[:, [COLUMN["steady_current.x"], COLUMN["steady_current.y"]]] = CURRENT
    own = position_error(unseen, rows, wandering)
    assert own < position_error(unseen, wandering, wandering) / 2.0
    assert own < position_error(unseen, rows, wandering, own=False) / 1.4


@pytest.mark.parametrize("with_compass", [True, False])
def test_an_antenna_off_the_centre_counts_beside_a_compass(tmp_path: Path, with_compass: bool) -> None:
    """With the boat's true numbers unseen positions are foretold better with its lever than without.

    Where the same instrument shows the heading, the lever has no part in what is foretold.
    """
    base = base_fit(of_an_antenna(tmp_path, with_compass=with_compass))
    unseen = unseen_parts(base)
    true = {"thrust_gain": 1.0, "yaw_torque_gain": 1.0, "drag": 8.0, "yaw_drag": 0.2, "yaw_inertia": boats.INERTIA}
    plain = with_numbers(base, true)
    rows = with_numbers(base, {**true, "pose_lever.ahead": AHEAD, "pose_lever.left": LEFT})
    found, without = position_error(unseen, rows, rows), position_error(unseen, plain, plain)
    assert found < 0.5 * without if with_compass else found == without


def shown_late(folder: Path, late: float) -> Evidence:
    """A drive whose poses are stamped so late [s], and the compass beside them in time."""
    evidence = of_an_antenna(folder, with_compass=True)
    boat, truth, _ = drive(folder, 4)
    (recording,) = boats.recorded(boat, truth, SECONDS, 4).recordings
    (log,) = recording.robots
    (beside,) = evidence.recordings[0].robots
    streams = {**log.streams, "compass": beside.streams["compass"]}
    streams["pose"] = replace(streams["pose"], time=streams["pose"].time + late)
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def test_a_model_with_late_poses_begins_by_its_own_numbers(tmp_path: Path) -> None:
    """The model of the punctual boat, with the delay, errs by less than a tenth of what the recalibrated one does.

    The numbers of that one stand for the delay, and so does what its filter makes of the readings.
    """
    late = 0.6
    rows = base_fit(shown_late(tmp_path, 0.0)).filled.copy()
    rows[:, COLUMN["sensor_latency.pose"]] = late
    unseen = unseen_parts(base_fit(shown_late(tmp_path, late)))
    assert position_error(unseen, rows, rows) < 0.1 * position_error(unseen, unseen.rows, unseen.rows)
