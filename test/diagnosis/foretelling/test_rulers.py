"""Errors of free runs against readings: by hand, and what no law of a reading can do to them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.shown_by import own_state
from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.foretelling.fixed_errors import STATE_OF_FORCE, with_fixed_errors
from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span
from cocorosim_ros.diagnosis.foretelling.rulers import against, errors_of_course, errors_of_readings
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.timeline import Timing, timing_of
from cocorosim_ros.world.laws.readings import READING_CODE
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.state.state import YAW, X, Y, Z

TIME = 0.1 * np.arange(101)


class Readings:
    """A timeline of readings given by kind, all at the same stamps."""

    def __init__(self, stamps: Any, **values: Any) -> None:
        kinds = [KIND_NAMES.index(name) for name in values]
        self.kind = np.repeat(kinds, len(stamps))
        self.stamp = np.tile(stamps, len(kinds))
        self.value = np.concatenate([np.broadcast_to(value, len(stamps)) for value in values.values()])
        self.grid = Grid()
        self.kinds = frozenset(values)

    def sees(self, *names: str) -> bool:
        """Tell whether any of the kinds is there."""
        return bool(np.isin(self.kind, [KIND_NAMES.index(name) for name in names]).any())

    def timing_under(self, row: Any) -> Timing:
        """Errors of stamps in a row: as it holds them, since other streams are right."""
        return timing_of(row)


class Grid:
    """The grid of TIME."""

    step = 0.1


class Track:
    """A track without laws of readings."""

    def __init__(self, stamps: Any, **values: Any) -> None:
        self.timeline = Readings(stamps, **values)
        self.filter = self

    def law_shift(self, row: Any) -> Any:
        """Errors by laws of readings: none."""
        return np.zeros(len(self.timeline.stamp))


def path(**columns: Any) -> Smoothed:
    """A path at TIME whose states are zero but for these columns."""
    mean = np.zeros((len(TIME), 8))
    for name, value in columns.items():
        mean[:, {"x": X, "y": Y, "z": Z, "yaw": YAW}[name]] = value
    return Smoothed(TIME, mean, np.zeros_like(mean))


def test_position_is_the_distance_of_both_readings() -> None:
    """Readings 3 cm and 4 cm beside the path are 5 cm off; the one at the start of the window does not count."""
    track: Any = Track(np.array([2.0, 2.5, 3.0]), pose_x=0.03, pose_y=-0.04)
    errors = errors_of_readings("position", track, path(), NEUTRAL, Span(20, 11))
    assert errors.time == pytest.approx([2.5, 3.0])
    assert errors.mean_square == pytest.approx(0.05**2)


def test_depth_is_that_of_the_pressure_where_no_pose_shows_it() -> None:
    """981 Pa more than the path's depth are a decimetre in fresh water; where both show it, the pose counts."""
    pressure = 101325.0 + 9810.0 * 0.5 + 981.0
    track: Any = Track(np.array([2.5]), pressure=pressure)
    assert errors_of_readings("depth", track, path(z=-0.5), NEUTRAL, Span(20, 11)).value == pytest.approx(0.1)
    both: Any = Track(np.array([2.5]), pressure=pressure, pose_z=-0.48)
    assert errors_of_readings("depth", both, path(z=-0.5), NEUTRAL, Span(20, 11)).value == pytest.approx(0.02)


def test_headings_differ_by_the_shorter_way() -> None:
    """A compass at 3.1 rad and a path at -3.1 rad are 0.083 rad apart."""
    track: Any = Track(np.array([2.5]), compass=3.1)
    errors = errors_of_readings("heading", track, path(yaw=-3.1), NEUTRAL, Span(20, 11))
    assert errors.value == pytest.approx(6.2 - 2.0 * np.pi)
    turning = path(yaw=-3.1 + 0.5 * TIME), path(yaw=3.1 + 0.6 * TIME)
    course = errors_of_course("heading", *turning, Span(20, 11))
    np.testing.assert_allclose(course.value[:, 0], 0.1 * np.arange(1, 11) * 0.1)
    assert len(course.time) == 10


def test_a_path_against_a_course_is_laid_where_that_begins_and_heads() -> None:
    """The same way on a map that is turned and shifted errs by nothing; one that is a tenth longer by that tenth."""
    ahead, aside = np.cos(0.3 * TIME), np.sin(0.7 * TIME)
    course, window = path(x=ahead, y=aside, z=-0.1 * TIME, yaw=0.2), Span(20, 11)
    turned = np.cos(0.9) * ahead - np.sin(0.9) * aside + 5.0, np.sin(0.9) * ahead + np.cos(0.9) * aside - 2.0
    elsewhere = path(x=turned[0], y=turned[1], z=-0.1 * TIME + 3.0, yaw=1.1)
    assert np.abs(errors_of_course("position", elsewhere, course, window).value).max() < 1e-12
    assert np.abs(errors_of_course("depth", elsewhere, course, window).value).max() < 1e-12
    longer = errors_of_course("position", path(x=1.1 * turned[0], y=1.1 * turned[1], yaw=1.1), course, window)
    way = np.column_stack([ahead, aside])[21:31] - [ahead[20], aside[20]]
    np.testing.assert_allclose(longer.value, -0.1 * way, atol=1e-12)


def test_what_no_reading_shows_is_measured_against_the_course() -> None:
    """A gyroscope tells headings by their rate alone; without it nothing does."""
    moving: Any = Track(np.array([2.5]), gyro_z=0.1)
    assert against("heading", [moving]) == "course"
    assert against("depth", [moving]) is None
    over_ground: Any = Track(np.array([2.5]), ground_velocity_u=0.1, ground_velocity_w=0.0)
    assert against("position", [over_ground]) == against("depth", [over_ground]) == "course"
    assert against("heading", [over_ground]) is None
    seen: Any = Track(np.array([2.5]), compass=0.1)
    assert against("heading", [moving, seen]) == "readings"


def law_of(reading: str) -> Any:
    """A row with a law of a reading, in the first place for such laws, and a distorted compass."""
    row = NEUTRAL.copy()
    row[COLUMN["sensor_law_1.coefficient"]] = -9350.0
    row[COLUMN["sensor_law_1.reading"]] = READING_CODE[reading]
    row[COLUMN["compass_distortion.sin"]] = 0.2
    row[COLUMN["sensor_latency.compass"]] = 0.3
    return row


def test_a_law_of_the_only_reading_of_a_state_does_not_count() -> None:
    """A law of the pressure counts where poses show the depth too; delays count always."""
    alone: Any = Readings(TIME, pressure=1e5, compass=0.0)
    row = with_fixed_errors(NEUTRAL, law_of("pressure"), alone)
    assert row[COLUMN["sensor_law_1.coefficient"]] == 0.0
    assert row[COLUMN["compass_distortion.sin"]] == 0.0
    assert row[COLUMN["sensor_latency.compass"]] == 0.3
    shown: Any = Readings(TIME, pressure=1e5, pose_z=0.0, compass=0.0, pose_yaw=0.0)
    row = with_fixed_errors(NEUTRAL, law_of("pressure"), shown)
    assert row[COLUMN["sensor_law_1.coefficient"]] == -9350.0
    assert row[COLUMN["compass_distortion.sin"]] == 0.2


def test_no_kind_of_reading_is_fixed_by_itself() -> None:
    """A sensor that is added is not forgotten: each shows a state, which it alone does not fix."""
    for kind in KINDS:
        assert own_state(kind) or kind in STATE_OF_FORCE
        alone: Any = Readings(TIME, **{kind: 0.0})
        row = with_fixed_errors(NEUTRAL, law_of(kind), alone)
        assert row[COLUMN["sensor_law_1.coefficient"]] == 0.0
