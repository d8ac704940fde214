"""Times at the surface under the lift of pumps are no course of a hull under water; floating about is one."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.afloat import with_times_afloat
from cocorosim_ros.diagnosis.evidence.holes import holes_of, parts_of
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.scenario.parts.platform import Platform, load_platform

TIME = np.arange(0.0, 600.0, 1.0)
DOWN_AND_UP = np.interp(TIME, [0, 20, 220, 420, 540, 600], [0.4, 0.4, 40.0, 0.4, 0.4, 8.0])  # m; 420 to 540 s afloat
BALLAST = np.interp(TIME, [0, 15, 20, 220, 225, 530, 535, 600], [1, 1, -1, -1, 1, 1, -1, -1])


@pytest.fixture
def glider() -> Platform:
    """70 kg, 1.8 m long, a pump of 250 cm^3."""
    return load_platform("slocum_glider")


def dive(**parts: Any) -> RobotLog:
    """A glider's way down and up again, a reading a second, with some parts replaced."""
    pressure = Stream(TIME, 101325.0 + 1004 * 9.81 * DOWN_AND_UP[:, None], np.array([50.0]))
    return replace(RobotLog("glider", TIME, BALLAST[:, None], {"pressure": pressure}), **parts)


def test_it_lies_at_the_surface(glider: Platform) -> None:
    """From a hull's length below the surface on, 0.2 m/s times 7 s earlier, until the pump pushes it down no more."""
    log, (said,) = with_times_afloat(dive(), glider)
    ((begin, end),) = log.afloat
    assert begin == pytest.approx(420 - 1.8 / (39.6 / 200), abs=1.0)
    assert end == pytest.approx(531.0, abs=1.0)
    assert f"1 times, {end - begin:.0f} s at the longest and first from {begin:.1f} s on" in said


def test_depths_that_a_map_made_pressures_are_depths(glider: Platform) -> None:
    """A hull's length below the surface is one, whatever the platform's water weighs."""
    pressure = Stream(TIME, 101325.0 + 9810.0 * DOWN_AND_UP[:, None], np.array([50.0]), from_depth=True)
    log, _ = with_times_afloat(dive(streams={"pressure": pressure}), replace(glider, water_density=2000.0))
    assert log.afloat[0][0] == pytest.approx(420 - 1.8 / (39.6 / 200), abs=1.0)


def test_it_is_a_hole_between_two_courses(glider: Platform) -> None:
    """What comes before and after is diagnosed, each by itself."""
    log, _ = with_times_afloat(dive(), glider)
    assert holes_of(log) == log.afloat
    (first, before), (after, last) = parts_of(log)
    assert (first, last) == (0.0, 599.0)
    assert before == log.afloat[0][0] and after == log.afloat[0][1]


def test_heights_tell_it_too(glider: Platform) -> None:
    """Where there is no pressure, the pose shows the depth."""
    pose = np.column_stack([np.zeros((len(TIME), 2)), -DOWN_AND_UP, np.zeros(len(TIME))])
    log, _ = with_times_afloat(dive(streams={"pose": Stream(TIME, pose, np.full(4, 0.01))}), glider)
    assert len(log.afloat) == 1


def test_what_does_not_rise_by_its_pump_is_no_matter(glider: Platform) -> None:
    """A pump that pushes down or not at all, a short stay, no reading of a depth, and a vehicle without any pump."""
    for log in (
        dive(command=-BALLAST[:, None]),
        dive(command=0.3 * BALLAST[:, None]),
        dive(streams={}),
        dive(command_time=np.empty(0), command=np.empty((0, 1))),
    ):
        assert with_times_afloat(log, glider) == (log, ())
    short = {
        "pressure": Stream(TIME, 101325.0 + 9849.0 * (20.0 - 19.6 * np.cos(0.1 * TIME))[:, None], np.array([50.0]))
    }
    assert with_times_afloat(dive(streams=short), glider)[1] == ()
    assert with_times_afloat(dive(command=np.ones((len(TIME), 4))), load_platform("haizhe_auv"))[1] == ()
