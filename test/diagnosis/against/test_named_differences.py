"""Compared with recordings of when it was well, what has changed is named with its number, and nothing else is.

The platform's file is imperfect on purpose: the robots have drag that it lacks, when they are well too.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

SECONDS = 60.0
WELL = {
    "linear_drag": {"surge": 0.02, "sway": 0.03, "heave": 0.02, "yaw": 3e-5},
    "anisotropic_drag": {"sway_ratio": 2.0, "heave_ratio": 1.5},
}
FOULED_AHEAD = {**WELL, "anisotropic_drag": {"sway_ratio": 2.0 / 1.5, "heave_ratio": 1.0}}
"""Effects of the well vehicle with 1.5 times the drag, that of the other axes as before."""
GOOD, BAD = (1, 2, 3, 4), (11, 12, 13)  # seeds of recordings


def weakened(actuators: Any, shares: dict[str, float]) -> Any:
    """The actuators, some of which have only a share of their force; Lily's thrusters push backwards as forwards."""
    return tuple(
        replace(each, maximum=shares[each.name] * each.maximum) if each.name in shares else each for each in actuators
    )


def vehicle(hidden: dict[str, dict[str, float]], left: float = 1.0, drag: float = 1.0) -> Any:
    """A Lily with these effects, whose left thruster has so much of its thrust, and that has so much more drag."""
    from hidden_effects import hiding

    from cocorosim_ros.scenario.parts.platform import load_platform

    plain = hiding(load_platform("lily"), hidden)
    return replace(plain, drag=drag * plain.drag, actuators=weakened(plain.actuators, {"left": left}))


def recordings(swim: Any, platform: Any, seeds: tuple[int, ...], altered: Callable[[Any], Any] | None = None) -> Any:
    """Evidence of one recording for each seed, the logs altered in a way."""
    from cocorosim_ros.diagnosis.evidence.streams.log import Evidence

    found = []
    for seed in seeds:
        evidence = swim(platform, SECONDS, seed=seed)
        (one,) = evidence.recordings
        robots = tuple(altered(log) if altered else log for log in one.robots)
        found.append(replace(one, origin=f"recording {seed}", robots=robots))
    return Evidence(vehicle({}), tuple(found))


def shifted(topic: str, offset: float) -> Callable[[Any], Any]:
    """A way to alter a log: all readings of a stream are higher."""

    def alter(log: Any) -> Any:
        stream = log.streams[topic]
        return replace(log, streams={**log.streams, topic: replace(stream, value=stream.value + offset)})

    return alter


def late(log: Any) -> Any:
    """A log whose commands are stamped 0.2 s before they act."""
    return replace(log, command_time=log.command_time - 0.2)


def compared(swim: Any, bad: Any) -> Any:
    """The comparison of recordings with those of the vehicle when it was well."""
    from cocorosim_ros.diagnosis.diagnose_against import diagnose_against

    return diagnose_against(bad, recordings(swim, vehicle(WELL), GOOD), lambda words, share: None)


def said_of_good(diagnosis: Any) -> list[str]:
    """Warnings and remarks about the recordings of --against."""
    return [each for each in (*diagnosis.warnings, *diagnosis.remarks) if "--against" in each]


def stretched(log: Any) -> Any:
    """A log whose camera shows all lengths too long by 6 %."""
    pose = log.streams["pose"]
    longer = replace(pose, value=pose.value * np.array([1.06, 1.06, 1.06, 1.0]))
    return replace(log, streams={**log.streams, "pose": longer})


def far_away(log: Any) -> Any:
    """A log of a place far from the origin."""
    pose = log.streams["pose"]
    return replace(log, streams={**log.streams, "pose": replace(pose, value=pose.value + np.array([6.0, -4.0, 0, 0]))})


def slow_gyroscope(log: Any) -> Any:
    """A log whose gyroscope reads 85 % of the rate."""
    imu = log.streams["imu"]
    slower = replace(imu, value=imu.value * np.array([0.85, 1.0, 1.0, 1.0]))
    return replace(log, streams={**log.streams, "imu": slower})


def compass_after(seconds: float) -> Callable[[Any], Any]:
    """A way to alter a log: the compass is stamped so late."""

    def alter(log: Any) -> Any:
        compass = log.streams["compass"]
        return replace(log, streams={**log.streams, "compass": replace(compass, time=compass.time + seconds)})

    return alter


CASES: dict[str, tuple[Any, Callable[[Any], Any] | None, str, str, float]] = {
    "one thruster weak": ((WELL, 0.8), None, "thruster_asymmetry", "left", 0.8),
    "fouled ahead": ((FOULED_AHEAD, 1.0, 1.5), None, "surge_drag", "surge_drag", 1.5),
    "compass askew": ((WELL,), shifted("compass", 0.1), "compass_distortion", "offset", 0.1),
    "pressure too high": ((WELL,), shifted("pressure", 300.0), "pressure_offset", "offset", 300.0),
    "lengths too long": ((WELL,), stretched, "camera_scale", "scale", 1.06),
    "gyroscope slow": ((WELL,), slow_gyroscope, "gyro_scale", "scale", 0.85),
    "commands late": ((WELL,), late, "command_delay", "delay", 0.2),
    "heavier": (({**WELL, "buoyancy_trim": {"force": -5e-4}},), None, "buoyancy_trim", "force", -5e-4),
}


@pytest.mark.parametrize("case", CASES, ids=str)
def test_what_has_changed_is_named(swim: Any, case: str) -> None:
    """The one alteration is named, with what was put in inside twice its interval; nothing is named beside it."""
    made, altered, effect, parameter, truth = CASES[case]
    diagnosis = compared(swim, recordings(swim, vehicle(*made), BAD, altered))
    assert [each.id for each in diagnosis.effects] == [effect]
    assert diagnosis.recalibrated == ()
    found = diagnosis.effects[0].parameters[parameter]
    assert abs(found.value - truth) <= found.high - found.low
    assert diagnosis.effects[0].tier == "confirmed"
    assert diagnosis.verdict == "mismatch"
    assert (diagnosis.against.control, said_of_good(diagnosis)) == ((), [])
    assert diagnosis.sentence.startswith("Compared with when it was well, these differ: ")


def test_nothing_differs_between_recordings_of_one_vehicle(swim: Any) -> None:
    """What the platform's file lacks is in both halves, and so it is not named."""
    diagnosis = compared(swim, recordings(swim, vehicle(WELL), BAD))
    assert (diagnosis.verdict, diagnosis.effects, diagnosis.recalibrated) == ("consistent", (), ())
    assert (diagnosis.against.control, said_of_good(diagnosis)) == ((), [])
    assert "linear_drag" in diagnosis.against.learned


def test_a_number_of_the_platform_that_has_changed_is_one(swim: Any) -> None:
    """All thrusters weaker by a quarter is a moved number, with the value before as its nominal one."""
    well = vehicle(WELL)
    weaker = replace(well, actuators=weakened(well.actuators, {"left": 0.75, "right": 0.75}))
    diagnosis = compared(swim, recordings(swim, weaker, BAD))
    assert (diagnosis.verdict, diagnosis.effects) == ("recalibrate", ())
    (moved,) = diagnosis.recalibrated
    assert (moved.parameter, moved.nominal) == ("thrust_gain", 1.0)
    assert abs(moved.estimate.value - 0.75) <= moved.estimate.high - moved.estimate.low


def test_a_stream_that_was_late_and_comes_later_still(swim: Any) -> None:
    """The difference is found beside a delay that the vehicle had before, and told without it."""
    from cocorosim_ros.diagnosis.diagnose_against import diagnose_against

    good = recordings(swim, vehicle(WELL), GOOD, compass_after(0.15))
    bad = recordings(swim, vehicle(WELL), BAD, compass_after(0.5))
    diagnosis = diagnose_against(bad, good, lambda words, share: None)
    (found,) = diagnosis.effects
    assert (found.id, found.topic) == ("sensor_latency", "compass")
    assert found.parameters["latency"].value == pytest.approx(0.35, abs=0.05)
    assert "sensor_latency" in diagnosis.against.learned


def screened(name: str, topic: str | None, information: float, felt: float = math.nan) -> Any:
    """A candidate of one number, as it was screened."""
    entry = SimpleNamespace(id=name, topic=topic, law=None)
    candidate = SimpleNamespace(entry=entry, spread=1.0)
    return SimpleNamespace(candidate=candidate, information=np.array([[information]]), felt=felt)


def test_what_recordings_cannot_tell_of_streams_and_thrusters() -> None:
    """A thruster that is hardly commanded, and a stream whose delay was tried and hardly felt, are listed by name."""
    from cocorosim_ros.diagnosis.naming.detectability import streams_and_numbers_not_shown

    told = [
        screened("sensor_latency", "compass", 1e4),
        screened("sensor_latency", "pressure", 1e4, felt=0.1),
        screened("thruster_gain:left", None, 1e-3),
        screened("thruster_gain:right", None, 1e4),
    ]
    assert streams_and_numbers_not_shown(told) == ("sensor_latency:pressure", "thruster_gain:left")


def test_a_delay_below_a_step_of_the_filter_is_no_difference(swim: Any) -> None:
    """Half a step of 0.1 s: as much as halves of sound recordings differ by."""
    diagnosis = compared(swim, recordings(swim, vehicle(WELL), BAD, compass_after(0.05)))
    assert "sensor_latency" not in [each.id for each in diagnosis.effects]


def test_late_poses_without_another_stream_are_told_with_their_twin(swim: Any) -> None:
    """With poses alone, commands that act 0.25 s late are the same thing: one is named, the other is its rival."""

    def poses(log: Any) -> Any:
        return replace(log, streams={"pose": log.streams["pose"]})

    def late_poses(log: Any) -> Any:
        pose = log.streams["pose"]
        return replace(log, streams={"pose": replace(pose, time=pose.time + 0.25)})

    from cocorosim_ros.diagnosis.diagnose_against import diagnose_against

    good, bad = recordings(swim, vehicle(WELL), GOOD, poses), recordings(swim, vehicle(WELL), BAD, late_poses)
    (found,) = diagnose_against(bad, good, lambda words, share: None).effects
    assert {found.id, found.ambiguous_with[0].id} == {"command_delay", "sensor_latency"}
    (number,) = found.parameters.values()
    assert number.value == pytest.approx(0.25, abs=0.05)


def test_of_a_camera_and_a_speed_log_the_one_in_error_is_named(swim_with_log: Any) -> None:
    """Both measure lengths. Far from the origin a camera with long lengths also saw a start farther away."""
    from cocorosim_ros.diagnosis.diagnose_against import diagnose_against

    good = recordings(swim_with_log, vehicle(WELL), GOOD, far_away)
    bad = recordings(swim_with_log, vehicle(WELL), BAD, lambda log: stretched(far_away(log)))
    diagnosis = diagnose_against(bad, good, lambda words, share: None)
    (found,) = diagnosis.effects
    assert found.id == "camera_scale"
    scale = found.parameters["scale"]
    assert abs(scale.value - 1.06) <= scale.high - scale.low


def test_the_step_of_the_learned_numbers_serves_both_and_is_told(swim: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file with a hundredth of the drag has longer steps than the vehicle that is learned, whose numbers are told."""
    from cocorosim_ros.diagnosis import diagnose_against
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.ranges import Range

    lily, fits = load_platform("lily"), []
    wide = {"drag": Range(0.01, 5.0, "kg/m"), "yaw_drag": Range(1e-7, 1e-3, "N m s^2")}
    slow = replace(lily, drag=0.01 * lily.drag, yaw_drag=0.01 * lily.yaw_drag, ranges=wide)

    def kept(*given: Any) -> Any:
        fits.append(joint(*given))
        return fits[-1]

    joint = diagnose_against.joint_fit
    monkeypatch.setattr(diagnose_against, "joint_fit", kept)
    good, bad = (swim(lily, 2.5 * SECONDS, seed=seed, base=slow) for seed in (4, 3))
    found = diagnose_against.diagnose_against(bad, good, lambda words, share: None)
    steps = {track.timeline.grid.step for track in fits[-1].tracks}
    assert steps == {found.step}
    assert found.step < make_tracks(bad)[0].timeline.grid.step
