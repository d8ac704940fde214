"""What streams show less what the model expects: by hand for every stream that an effect may be of."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.filter.layout import COMPASS, GYRO, POSE_X, PRESSURE
from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.diagnosis.foretelling.held_out_streams import HeldOutPart, held_out_streams
from cocorosim_ros.diagnosis.showing.residual_reading import SmoothedFit, residual_readings
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL
from cocorosim_ros.diagnosis.tracks.timeline import timing_of
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.terms.course import Course

TIME = np.linspace(0.0, 10.0, 101)
# x, y, z, yaw, u, v, w, r at any moment: steady, so that delays are seen in x and yaw.
COURSE = SimpleNamespace(
    time=TIME,
    mean=np.stack([0.2 * TIME, 0 * TIME, -1 + 0 * TIME, 0.1 * TIME, 0.2 + 0 * TIME, 0 * TIME, 0 * TIME, 0.1 + 0 * TIME],
                  axis=1),
)  # fmt: skip


def swum(course: Any, row: np.ndarray) -> Course:
    """What laws may depend on along this course, with two thrusters that push ever more."""
    force = np.stack([-0.001 * TIME, 0.002 * TIME], axis=1)
    far = np.full(3, -9.0), np.full(3, 9.0)
    nobody = np.zeros((1, 0, 5))
    return Course(TIME, course.mean, np.zeros((101, 4)), force, 0 * force, np.zeros(2, dtype=bool), far, nobody, -1)


def fit(kind: int, values: np.ndarray, **numbers: float) -> Any:
    """A fit of one robot whose stream of this kind has these values."""
    row = NEUTRAL.copy()
    for name, value in numbers.items():
        row[COLUMN[name.replace("__", ".")]] = value
    timeline = SimpleNamespace(
        timing_under=timing_of,
        kind=np.full(len(TIME), kind),
        stamp=TIME,
        value=values,
        share=np.full(len(TIME), 0.25),
        grid=Grid(0.0, 0.1, 101),
    )
    log = SimpleNamespace(streams=dict.fromkeys(("compass", "imu"), SimpleNamespace(noise=np.array([0.02]))))
    without_laws = SimpleNamespace(law_shift=lambda row: np.zeros(len(TIME)))
    vehicle = SimpleNamespace(
        is_pump=np.zeros(2, dtype=bool), actuator_curve=np.zeros((2, 0)), actuator_limit=np.full((2, 2), 0.05)
    )
    drive = SimpleNamespace(force=swum(COURSE, row).force)
    swimming = SimpleNamespace(course_along=swum, vehicle=vehicle, drive=lambda row: drive)
    track = SimpleNamespace(name="lily_01", timeline=timeline, log=log, filter=without_laws, actuation=swimming)
    return SimpleNamespace(tracks=(track,), filled=row[None])


def smoothed(fit: Any) -> SmoothedFit:
    """A fit whose only track takes the course."""
    return SmoothedFit(fit, [COURSE])


def effect(name: str, topic: str | None = None, correction: str | None = None) -> FoundEffect:
    """An effect of lily_01."""
    return FoundEffect(name, name, "", ("lily_01",), "confirmed", {}, 10.0, topic=topic, correction=correction)


CASES = [
    (effect("compass_distortion"), COMPASS, 0.1 * TIME + 0.05 + 0.2 * np.sin(0.1 * TIME),
     {"compass_distortion__offset": 0.05, "compass_distortion__sin": 0.2}, "yaw"),
    (effect("motor_field"), COMPASS, 0.1 * TIME + 0.2 * np.maximum(0.003 * (TIME - 0.05), 0.0) / 0.1,
     {"motor_field__field": 0.2}, "|thrust|"),
    (effect("pressure_drift"), PRESSURE, 101325.0 + 9810.0 + 3.0 * TIME, {"pressure_drift__rate": 3.0}, "t"),
    (effect("imu_bias"), GYRO, 0.13 + 0 * TIME, {"imu_bias__gyro_z": 0.03}, "t"),
    (effect("camera_scale"), POSE_X, 0.22 * TIME, {"camera_scale__scale": 1.1}, "x"),
]  # fmt: skip


@pytest.mark.parametrize(("found", "kind", "values", "numbers", "regressor"), CASES)
def test_with_its_number_a_stream_shows_what_is_expected(
    found: FoundEffect, kind: int, values: np.ndarray, numbers: dict[str, float], regressor: str
) -> None:
    """Before, the deviation is the effect itself; after, it is nothing."""
    before, after = fit(kind, values), fit(kind, values, **numbers)
    (reading,) = residual_readings(smoothed(before), smoothed(after), [found])
    assert np.abs(reading.after).max() < 1e-9 * max(1.0, np.abs(values).max())
    assert np.abs(reading.before).max() > 0.02
    assert (reading.robot, reading.regressor) == ("lily_01", regressor)


def test_a_late_stream_is_off_by_rate_times_delay() -> None:
    """A compass 0.5 s late on a steady turn of 0.1 rad/s lags by 0.05 rad; half a turn is no jump."""
    values = 0.1 * (TIME - 0.5) + 2 * np.pi
    before, after = fit(COMPASS, values), fit(COMPASS, values, sensor_latency__compass=0.5)
    late = effect("sensor_latency", "compass")
    (reading,) = residual_readings(smoothed(before), smoothed(after), [late])
    assert reading.before == pytest.approx(-0.05)
    assert reading.against == pytest.approx(0.1)
    assert reading.after[10:] == pytest.approx(0.0, abs=1e-9)


def held_out_fit(
    values: np.ndarray, hidden: list[str], poses: bool = True, kind: int = COMPASS, **numbers: float
) -> Any:
    """A fit whose compass has these values; `hidden` notes the streams without which a course was smoothed."""
    one = fit(kind, values, **numbers)
    (track,) = one.tracks
    track.timeline.sees = lambda *kinds: poses and "pose_yaw" in kinds
    track.filter.smoothed = lambda row: SimpleNamespace(
        time=TIME, mean=COURSE.mean, spread=np.full((101, 8), 0.01 * np.sqrt(3.0))
    )
    track.without_stream = lambda name: hidden.append(name) or track
    return one


def test_held_out_errors_of_a_stream() -> None:
    """In the last 4 s: 0.05 rad of offset before, nothing after, on a course made without the compass.

    The floor: means of four readings of 0.02 rad, on a course uncertain by 0.01 sqrt(3) rad.
    """
    values, hidden = 0.1 * TIME + np.where(TIME < 5.9, 0.9, 0.05), []
    plain = held_out_fit(values, hidden)
    better = held_out_fit(values, hidden, compass_distortion__offset=0.05)
    models = {"nominal": plain.filled, "recalibrated": plain.filled, "augmented": better.filled}
    table = held_out_streams(plain.tracks, plain.filled, models, HeldOutPart([[(6.0, 10.0)]], 2.0))
    assert list(table) == ["compass"] and hidden == ["compass"]
    row = table["compass"]
    assert (row.nominal, row.recalibrated, row.noise_floor) == pytest.approx((0.05, 0.05, 0.02))
    assert (row.unit, row.against) == ("rad", "course")
    assert row.augmented == pytest.approx(0.0, abs=1e-9)
    assert row.intervals["nominal"] == pytest.approx((0.05, 0.05))


@pytest.mark.parametrize(("skew", "poses", "left_out"), [(0.0, True, []), (1e-3, True, ["imu"]), (1e-3, False, None)])
def test_a_stream_with_other_stamps_does_not_show_its_own_course(
    skew: float, poses: bool, left_out: list[str] | None
) -> None:
    """A gyroscope in time is seen on a course that it shows too; one whose clock a model has as wrong is not.

    Where nothing else shows the turn, it is not measured at all.
    """
    hidden: list[str] = []
    plain = held_out_fit(0.1 + 0.0 * TIME, hidden, poses, kind=GYRO)
    other = held_out_fit(0.1 + 0.0 * TIME, [], poses, kind=GYRO, clock_skew__imu=skew)
    models = {"nominal": plain.filled, "recalibrated": plain.filled, "augmented": other.filled}
    table = held_out_streams(plain.tracks, plain.filled, models, HeldOutPart([[(6.0, 10.0)]], 2.0))
    assert list(table) == ([] if left_out is None else ["imu"])
    assert hidden == (left_out or [])


def test_a_stream_that_alone_shows_its_state_has_no_errors() -> None:
    """Without poses nothing tells what a compass should show."""
    alone = held_out_fit(0.1 * TIME, [], poses=False)
    models = dict.fromkeys(("nominal", "recalibrated", "augmented"), alone.filled)
    assert held_out_streams(alone.tracks, alone.filled, models, HeldOutPart([[(6.0, 10.0)]], 2.0)) == {}


def test_other_effects_have_no_reading() -> None:
    """Physics of the body, mixed-up frames, streams that the robot does not have."""
    one = fit(COMPASS, 0.1 * TIME)
    others = [effect("added_mass"), effect("frame_mixup", "compass", "in degrees"), effect("pressure_offset")]
    assert residual_readings(smoothed(one), smoothed(one), others) == ()


def test_a_law_is_drawn_over_its_product() -> None:
    """A compass in error with what all thrusters deliver, 0.003 N/s t, is drawn over that, in newtons."""
    fits = fit(COMPASS, 0.1 * TIME + 8.0 * 0.003 * TIME), fit(COMPASS, 0.1 * TIME)
    law = Law.parse("unknown:compass~|thrust|")
    named = replace(effect(law.text, "compass"), law=law)
    (reading,) = residual_readings(*map(smoothed, fits), [named])
    assert (reading.regressor, reading.against_unit) == ("|thrust|", "N")
    # What actuators deliver is a mean until the next point, half a step of 0.1 s later.
    assert reading.against[1:] == pytest.approx(0.003 * (TIME[1:] - 0.05))
    assert reading.before == pytest.approx(0.024 * TIME, abs=1e-12)


def test_laws_of_readings_without_a_picture_have_no_other_readings() -> None:
    """An accelerometer in error is not shown by the gyroscope of the same topic."""
    one = fit(GYRO, 0.1 + 0 * TIME)
    law = Law.parse("unknown:imu~u", "accel_x")
    assert residual_readings(smoothed(one), smoothed(one), [replace(effect(law.text, "imu"), law=law)]) == ()
