"""Numbers with their intervals."""

from __future__ import annotations

import math
from typing import Any

import pytest
from named_in_vain import case_of


def test_no_interval_is_narrower_than_the_steps_of_the_filter(swim: Any) -> None:
    """In still water the truth, 1 % more drag in yaw, lies in an interval at least six ten-thousandths wide."""
    from dataclasses import replace

    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.showing.estimates import fitted, recalibrated
    from cocorosim_ros.scenario.parts.platform import load_platform

    plain = load_platform("lily")
    true = replace(plain, yaw_drag=1.01 * plain.yaw_drag)
    every, _ = recalibrated(fitted(base_fit(swim(true, 600.0, seed=7, base=plain, disturbance=0.0))))
    (found,) = [part.estimate for part in every if part.parameter == "yaw_drag"]
    assert found.low <= true.yaw_drag <= found.high
    assert found.high - found.low > 6e-4 * true.yaw_drag


def test_a_number_that_was_measured_has_to_leave_both_intervals(swim: Any) -> None:
    """Drag of 1.2 times what the file says: moved, if the file is sure of it; not moved, if it says 0.8 to 1.3 times.

    By hand: the file's standard deviation is log(1.3 / 0.8) / 3.92 = 0.124, and log 1.2 = 0.18.
    """
    from dataclasses import replace

    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.showing.estimates import fitted, recalibrated
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.ranges import Range

    plain = load_platform("lily")
    vague = replace(plain, intervals={"drag": Range(0.8 * plain.drag, 1.3 * plain.drag, "kg/m")})
    for base, names in ((plain, ["drag"]), (vague, [])):
        fit = base_fit(swim(replace(plain, drag=1.2 * plain.drag), 200.0, seed=8, base=base))
        _, moved = recalibrated(fitted(fit))
        assert [each.parameter for each in moved] == names


def test_a_difference_is_told_as_the_number_would_be_with_it_alone() -> None:
    """6 % on top of any scale is a scale of 1.06; an offset on top of another is itself, and a factor too."""
    from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
    from cocorosim_ros.diagnosis.showing.estimates import Fitted

    scale = Unknown(Owner("camera_scale", ("lily",), "scale", "1"), "camera_scale.scale", (0,), 0.0, 0.05, on_top=True)
    assert Fitted(scale, 1.2, 0.1).estimate.value == pytest.approx(1.06)
    offset = Unknown(
        Owner("pressure_offset", ("lily",), "offset", "Pa"), "pressure_offset.offset", (0,), 0.0, 500.0, on_top=True
    )
    assert Fitted(offset, 0.5, 0.1).estimate.value == pytest.approx(250.0)
    gain = Unknown(
        Owner("thruster_gain:left", ("lily",), "left", "1"), "own_gain.1", (0,), 1.0, 0.3, logarithmic=True, on_top=True
    )
    assert Fitted(gain, 0.0, 0.1).estimate.value == pytest.approx(1.0)


def test_numbers_that_no_reading_feels_are_not_told(swim: Any) -> None:
    """Of an IMU whose accelerometer was not recorded the bias of the gyroscope is told alone."""
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.scenario.parts.platform import load_platform

    (effect,) = case_of(base_fit(swim(load_platform("lily"), 40.0, 1)), "imu_bias").found
    assert set(effect.parameters) == {"gyro_z"}
    assert "accel" not in effect.equation


@pytest.mark.parametrize(
    ("found", "told"), [(3.522, 3.522 - 2.0 * math.pi), (-0.3, -0.3), (-3.2, -3.2 + 2.0 * math.pi)]
)
def test_an_angle_is_told_within_half_a_turn(found: float, told: float) -> None:
    """A direction that a fit left a turn too far is the same direction, and so are the ends of its interval."""
    from cocorosim_ros.diagnosis.findings import Estimate
    from cocorosim_ros.diagnosis.showing.estimates import within_half_a_turn

    angle = within_half_a_turn(Estimate(found, found - 0.02, found + 0.03, "rad"))
    assert (angle.value, angle.low, angle.high) == pytest.approx((told, told - 0.02, told + 0.03))
