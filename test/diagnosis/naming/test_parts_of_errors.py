"""An IMU whose gyroscope alone is off does not pay for three accelerations, and none errs by more than an IMU can."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.screening import Screen
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.naming.parts_of_errors import parts_of_errors
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.tracks.vehicle_size import LILY_SIZES
from cocorosim_ros.scenario.parts.platform import load_platform

ACCELERATIONS = {"accel_x", "accel_y", "accel_z"}
IMU_BIAS = next(entry for entry in ENTRIES if entry.id == "imu_bias")


def track_of(*kinds: str) -> Any:
    """A track whose timeline sees these kinds of readings."""
    return SimpleNamespace(timeline=SimpleNamespace(sees=lambda *names: bool(set(names) & set(kinds))))


def test_the_gyroscope_and_the_accelerometer_may_err_each_alone() -> None:
    """One entry of either, where both were recorded; none where one is missing."""
    parts = parts_of_errors([track_of("gyro_z", *ACCELERATIONS)])
    assert [{amplitude.name for amplitude in entry.amplitudes} for entry in parts] == [{"gyro_z"}, ACCELERATIONS]
    assert {entry.id for entry in parts} == {"imu_bias"}
    assert parts_of_errors([track_of("gyro_z")]) == []


def test_what_another_entry_has_by_itself_is_no_part() -> None:
    """A drift may begin at nothing; the offset that it begins with otherwise has an entry of its own."""
    parts = parts_of_errors([track_of("pressure")])
    assert [(entry.id, [amplitude.name for amplitude in entry.amplitudes]) for entry in parts] == [
        ("pressure_drift", ["rate"])
    ]


def test_no_instrument_errs_more_for_a_stronger_vehicle() -> None:
    """Full thrust of 350 times a Lily's acceleration: 2 m/s^2 is what an IMU tilted by 12 degrees shows of gravity."""
    strong = Candidate(IMU_BIAS, ("rov",), ((0,),), sizes={**LILY_SIZES, "m/s^2": 350.0, "rad/s": 2.0})
    large = {amplitude.name: strong.large(amplitude) for amplitude in IMU_BIAS.amplitudes}
    assert large["gyro_z"] == pytest.approx(0.04)
    assert {large[name] for name in ACCELERATIONS} == {2.0}


def test_accelerations_that_were_not_recorded_cost_nothing(swim: Any) -> None:
    """The evidence of the gyroscope's bias is the same with them and without."""
    base = base_fit(swim(load_platform("lily"), 60.0, 2))
    screen = Screen(base, scene_of(base.tracks, smoothed_tracks(base)))
    (alone,) = (entry for entry in parts_of_errors([track_of("gyro_z", *ACCELERATIONS)]) if len(entry.amplitudes) == 1)
    both = [screen.test(expand([entry], base.tracks, base.rows)[0]) for entry in (alone, IMU_BIAS)]
    assert both[0].nats == pytest.approx(both[1].nats)
    assert np.isfinite(both[1].information).all()
