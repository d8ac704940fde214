"""Numbers with their intervals."""

from __future__ import annotations

from typing import Any


def test_no_interval_is_narrower_than_the_steps_of_the_filter(swim: Any) -> None:
    """In still water the truth, 1 % more drag in yaw, lies in an interval at least six ten-thousandths wide."""
    from dataclasses import replace

    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.showing.estimates import recalibrated
    from cocorosim_ros.scenario.parts.platform import load_platform

    plain = load_platform("lily")
    true = replace(plain, yaw_drag=1.01 * plain.yaw_drag)
    every, _ = recalibrated(base_fit(swim(true, 600.0, seed=7, base=plain, disturbance=0.0)))
    (found,) = [part.estimate for part in every if part.parameter == "yaw_drag"]
    assert found.low <= true.yaw_drag <= found.high
    assert found.high - found.low > 6e-4 * true.yaw_drag
