"""Axes of poses, told by the learned vehicle: a ship that coasts for long, of which nothing but poses is read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import ships

from cocorosim_ros.diagnosis.against.axes import in_its_axes
from cocorosim_ros.diagnosis.against.joint import joint_fit
from cocorosim_ros.diagnosis.evidence.intake import Intake
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit

NOISE = np.array([0.02, 0.02, 0.02, 0.005])  # m, m, m, rad
TICKS = 300  # of half a second


def quarter(pose: Any) -> Any:
    """Positions a right angle to the left of where they were seen from the origin."""
    return np.column_stack([-pose[:, 1], pose[:, 0], pose[:, 2:]])


def turned_world(pose: Any) -> Any:
    """Poses a right angle to the left, the yaw too."""
    return quarter(pose) + np.array([0.0, 0.0, 0.0, np.pi / 2.0])


# By case: how poses are altered, the words of the correction, and the poses that it leads to from right ones; positions
# that are turned by a right angle are right in a turned world, where the yaw is a right angle more.
ALTERED: dict[str, tuple[Callable[[Any], Any], str, Callable[[Any], Any]]] = {
    "y": (lambda pose: pose * np.array([1.0, -1.0, 1.0, 1.0]), "the sign of y is flipped", lambda pose: pose),
    "yaw": (lambda pose: pose * np.array([1.0, 1.0, 1.0, -1.0]), "its sign is flipped", lambda pose: pose),
    "turned": (quarter, "90 degrees have to be added to it", turned_world),
}


def commands(period: float) -> Any:
    """(TICKS, 2) of a zigzag: the propeller in steps, the rudder to and fro with a period in ticks."""
    tick = np.arange(TICKS)
    angle = 0.6 * np.sign(np.sin(2.0 * np.pi * tick / period)) * (tick > 20)
    return np.column_stack([np.where(tick % 150 < 100, 0.9, 0.5), angle])


def sailed(ship: Any, periods: tuple[float, ...], alter: Callable[[Any], Any] | None = None) -> Evidence:
    """Evidence of one zigzag for each period, poses altered."""
    found = []
    for number, period in enumerate(periods):
        rows = ships.run(ship, commands(period), start=(0.8, 0.0, 0.0))[:, :4]
        value = rows + NOISE * np.random.default_rng([20261126, number]).standard_normal(rows.shape)
        pose = Stream(0.5 * np.arange(TICKS + 1), alter(value) if alter else value, NOISE)
        log = RobotLog("ship", 0.5 * np.arange(TICKS), commands(period), {"pose": pose})
        found.append(RecordingLog(f"zigzag {period}", 0.5 * TICKS, (log,)))
    return Evidence(ship, tuple(found))


@pytest.fixture(scope="module")
def ship(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """A ship with a propeller and a rudder."""
    folder: Path = tmp_path_factory.mktemp("ship")
    return ships.ship(
        folder, ships.PROPELLER + ships.RUDDER.replace(f", {ships.STOCK[1]}, 0]", ", 0, 0]") + ships.BEHIND
    )


@pytest.mark.parametrize("case", ALTERED, ids=str)
def test_turned_poses_are_turned_back(ship: Any, case: str) -> None:
    """The correction is named, and the poses are those that were read; sound ones stay the very same evidence."""
    alter, words, right = ALTERED[case]
    learned, sound = base_fit(sailed(ship, (70.0, 50.0))), sailed(ship, (60.0, 80.0))
    bad = sailed(ship, (60.0, 80.0), alter)
    intake = in_its_axes(learned, joint_fit(learned, bad), Intake(bad, (), ()))
    (mixup,) = intake.mixups
    assert mixup.robots == ("ship",)
    assert words in mixup.correction.wrong
    for put_right, true in zip(intake.evidence.recordings, sound.recordings, strict=True):
        (mine,), (theirs,) = put_right.robots, true.robots
        np.testing.assert_allclose(mine.streams["pose"].value, right(theirs.streams["pose"].value), atol=1e-9)
    as_it_is = Intake(sound, (), ())
    assert in_its_axes(learned, joint_fit(learned, sound), as_it_is) is as_it_is


def test_without_poses_nothing_is_turned(ship: Any) -> None:
    """There is nothing to turn."""
    learned = base_fit(sailed(ship, (70.0, 50.0)))
    bad = sailed(ship, (60.0, 80.0))
    blind = replace(
        bad,
        recordings=tuple(
            replace(each, robots=tuple(replace(log, streams={"compass": _heading(log)}) for log in each.robots))
            for each in bad.recordings
        ),
    )
    intake = Intake(blind, (), ())
    assert in_its_axes(learned, joint_fit(learned, blind), intake) is intake


def _heading(log: RobotLog) -> Stream:
    pose = log.streams["pose"]
    return Stream(pose.time, pose.value[:, 3:], NOISE[3:])
