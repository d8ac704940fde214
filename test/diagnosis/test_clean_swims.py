"""Clean simulations, with holes in their recordings and without, are consistent."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

HOLE = (50.0, 63.0)  # s


def with_hole(evidence: Any, streams: tuple[str, ...]) -> Any:
    """Evidence with a hole of the commands and of these streams."""
    (recording,) = evidence.recordings
    (robot,) = recording.robots
    kept = (robot.command_time <= HOLE[0]) | (robot.command_time >= HOLE[1])
    cut = dict(robot.streams)
    for name in streams:
        inside = (cut[name].time <= HOLE[0]) | (cut[name].time >= HOLE[1])
        cut[name] = replace(cut[name], time=cut[name].time[inside], value=cut[name].value[inside])
    robot = replace(robot, command_time=robot.command_time[kept], command=robot.command[kept], streams=cut)
    return replace(evidence, recordings=(replace(recording, robots=(robot,)),))


@pytest.mark.parametrize("streams", [("pose", "compass", "pressure", "imu"), ("pose",), ()])
def test_a_clean_swim_with_a_hole_is_consistent(swim: Any, streams: tuple[str, ...]) -> None:
    """No noise, no random force, nothing hidden: neither a number nor an effect passes for the missing commands."""
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform

    evidence = swim(load_platform("lily"), 120.0, seed=21, disturbance=0.0, blur=0.0)
    diagnosis = diagnose(with_hole(evidence, streams), lambda words, share: None)
    assert diagnosis.effects == ()
    assert diagnosis.recalibrated == ()
    assert diagnosis.verdict == "consistent"


def test_a_clean_swim_is_consistent(swim: Any) -> None:
    """Without holes as well: what the filter's steps move is no shift of a number."""
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform

    diagnosis = diagnose(
        swim(load_platform("lily"), 120.0, seed=22, disturbance=0.0, blur=0.0), lambda words, share: None
    )
    assert (diagnosis.verdict, diagnosis.recalibrated) == ("consistent", ())
