"""The honest base: where the first guess of the noise is far off, another way leads to a better fit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.fitting import RECALIBRATION
from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.fitting import recalibration
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.declared_numbers import declared_columns
from cocorosim_ros.scenario.parts.kept_numbers import FITTED_WITHOUT_RANGE
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
from cocorosim_ros.scenario.reading.ranges import Range

Swim = Callable[..., Any]


def doubted(evidence: Any, share: float) -> Any:
    """The evidence with noise that is told as a share of what it is."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    streams = {name: replace(stream, noise=share * stream.noise) for name, stream in log.streams.items()}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def noise_of(fit: Any) -> dict[str, list[float]]:
    """Standard deviations by column, one for each group of tracks that share it."""
    found: dict[str, list[float]] = {}
    for unknown, q in zip(fit.noise, fit.q_noise, strict=True):
        found.setdefault(unknown.column, []).append(float(np.exp(unknown.value(float(q)))))
    return found


@pytest.fixture(scope="module")
def rough(swim: Swim) -> Any:
    """A minute in rough water with readings ten times worse than told."""
    return doubted(swim(load_platform("lily"), 60.0, disturbance=0.3), 0.1)


def test_the_best_of_the_ways_is_taken(rough: Any) -> None:
    """Readings that the first guess shuts out are heeded at the second start, and the base is no worse than by any."""
    first = recalibration.first_fit(rough)
    second = recalibration._at_random(first)
    shut = [[recalibration._is_shut(fit, unknown) for unknown in fit.noise] for fit in (first, second)]
    assert any(shut[0]) and sum(shut[1]) < sum(shut[0])
    ways = [
        settled(recalibration._opened(start), RECALIBRATION.most_rounds).objective
        for start in (first, second, recalibration._without_inertial(first))
    ]
    assert recalibration.base_fit(rough).objective >= max(ways) - 1e-6


def test_a_tracker_that_was_at_a_loss_once_is_good_elsewhere(swim: Swim) -> None:
    """Two recordings of one robot, one with poses at random: the other's stay as good; its own compass is one."""
    good = swim(load_platform("lily"), 60.0, seed=1)
    (recording,) = swim(load_platform("lily"), 60.0, seed=2).recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    lost = pose.value + [0.1, 0.1, 0.1, 0.0] * np.random.default_rng(3).standard_normal(pose.value.shape)
    worse = replace(log, streams={**log.streams, "pose": replace(pose, value=lost)})
    both = replace(good, recordings=(*good.recordings, replace(recording, robots=(worse,))))
    found = noise_of(recalibration.base_fit(both))
    assert found["reading.pose_xy"][0] == pytest.approx(0.002, rel=0.1) and found["reading.pose_xy"][1] > 0.03
    assert found["reading.compass"] == [pytest.approx(0.02, rel=0.1)]


def test_a_gyroscope_that_errs_does_not_discredit_camera_and_compass(swim: Swim) -> None:
    """Its offset turns the model away from both at every step; all the same it is its own noise that grows."""
    evidence = swim(load_platform("lily"), 120.0, seed=3)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    imu = log.streams["imu"]
    worse = replace(log, streams={**log.streams, "imu": replace(imu, value=imu.value + 0.3)})
    found = noise_of(recalibration.base_fit(replace(evidence, recordings=(replace(recording, robots=(worse,)),))))
    assert found["reading.pose_yaw"] == [pytest.approx(0.01, rel=0.3)]
    assert found["reading.compass"] == [pytest.approx(0.02, rel=0.3)]
    assert found["reading.gyro_z"][0] > 0.1


def test_the_same_water_may_move_one_robot_more(swim: Swim) -> None:
    """Of another inertia than told, say: the random forces of two robots are found for each, four times as strong."""
    calm, wild = (swim(load_platform("lily"), 60.0, seed=4, disturbance=share) for share in (0.02, 0.08))
    (recording,) = wild.recordings
    other = replace(recording, robots=(replace(recording.robots[0], name="lily_02"),))
    found = noise_of(recalibration.base_fit(replace(calm, recordings=(*calm.recordings, other))))
    for column in ("random.force", "random.heave_force", "random.moment"):
        quiet, loud = found[column]
        assert loud / quiet == pytest.approx(4.0, rel=0.4)  # of a minute each


def test_a_vehicle_without_yaw_control_is_turned_by_water(swim: Swim) -> None:
    """Its heading wanders by far more than its compass errs: a random moment, not a compass at a loss."""
    lily = load_platform("lily")
    pump = tuple(part for part in lily.actuators if part.name == "pump")
    evidence = swim(lily, 60.0, seed=5)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    only_pump = replace(log, command=np.ascontiguousarray(log.command[:, 2:]))
    adrift = replace(
        evidence, platform=replace(lily, actuators=pump), recordings=(replace(recording, robots=(only_pump,)),)
    )
    found = noise_of(recalibration.base_fit(adrift))
    assert found["reading.compass"] == [pytest.approx(0.02, rel=0.3)]
    assert found["reading.pose_yaw"] == [pytest.approx(0.01, rel=0.3)]


def test_a_force_that_stays_is_not_taken_for_chance(swim: Swim) -> None:
    """In water that does not push, no random force lasts for minutes to hide a torque and a trim."""
    lily = load_platform("lily")
    hidden = {
        "torque_bias": {"torque": Quantity(3e-6, "N m", "torque")},
        "buoyancy_trim": {"force": Quantity(1e-3, "N", "force")},
    }
    secret = replace(lily, effect_quantities=hidden)
    evidence = swim(secret, 300.0, seed=6, disturbance=0.0, base=lily)
    found = noise_of(recalibration.base_fit(evidence))
    assert found["random.correlation"][0] < 61.0  # s


def test_a_platform_that_is_far_off_does_not_drown_its_readings(swim: Swim) -> None:
    """By 30 mN too heavy it leaves the gauge by metres, and 8 Pa are found for the gauge's noise all the same."""
    lily = load_platform("lily")
    heavy = {"buoyancy_trim": {"force": Quantity(-0.03, "N", dimension_of("N"))}}
    evidence = swim(lily, 120.0, seed=3, base=replace(lily, effect_quantities=heavy))
    (recording,) = evidence.recordings
    (log,) = recording.robots
    blind = replace(log, streams={name: each for name, each in log.streams.items() if name != "pose"})
    fit = recalibration.base_fit(replace(evidence, recordings=(replace(recording, robots=(blind,)),)))
    assert noise_of(fit)["reading.pressure"] == [pytest.approx(8.0, rel=0.1)]


def test_steps_of_the_filter_follow_the_found_numbers(swim: Swim) -> None:
    """A file with a hundredth of a Lily's drags asks for long steps; the fit is made again with those of a Lily."""
    lily = load_platform("lily")
    wide = {"drag": Range(0.01, 5.0, "kg/m"), "yaw_drag": Range(1e-7, 1e-3, "N m s^2")}
    slow = replace(lily, drag=0.01 * lily.drag, yaw_drag=0.01 * lily.yaw_drag, ranges=wide)
    evidence = swim(lily, 100.0, seed=3, base=slow)
    before, after = recalibration.first_fit(evidence), recalibration.base_fit(evidence)
    of_lily = recalibration.first_fit(swim(lily, 100.0, seed=3)).tracks[0].timeline.grid.step
    steps = [fit.tracks[0].timeline.grid.step for fit in (before, after)]
    assert steps[0] > RECALIBRATION.alike_steps * of_lily
    assert 1.0 / RECALIBRATION.alike_steps < steps[1] / of_lily < RECALIBRATION.alike_steps
    (drag,) = [each.value(float(q)) for each, q in zip(after.unknowns, after.q, strict=True) if each.column == "drag"]
    assert drag == pytest.approx(lily.drag, rel=0.1)


def test_numbers_that_the_file_keeps_are_not_fitted(swim: Swim) -> None:
    """They are the vehicle's own all the same: an effect whose number is kept is never looked for."""
    lily = load_platform("lily")
    linear = {"linear_drag": {"surge": Quantity(0.01, "N s/m", dimension_of("N s/m"))}}
    ranges = {"effects.linear_drag.surge": Range(0.001, 0.03, "N s/m")}
    own = replace(lily, effect_quantities=linear, ranges=ranges)
    keeping = replace(own, kept_as_given=("drag", "effects.linear_drag.surge"))
    free, kept = (recalibration.first_fit(swim(lily, 60.0, seed=3, base=each)) for each in (own, keeping))
    left = {each.column for each in free.unknowns} - {each.column for each in kept.unknowns}
    assert left == {"drag", "linear_drag.surge"}
    assert declared_columns(kept.tracks) == declared_columns(free.tracks) == {"linear_drag.surge"}


def test_a_platform_that_keeps_all_its_numbers_is_diagnosed(swim: Swim) -> None:
    """With nothing left to fit but noise, a sound swim fits and a drag of twice the size is missing something."""
    lily = replace(load_platform("lily"), kept_as_given=FITTED_WITHOUT_RANGE)
    evidence = swim(lily, 100.0, seed=3)
    assert recalibration.base_fit(evidence).unknowns == ()
    assert diagnose(evidence, lambda words, share: None).verdict == "consistent"
    dragging = swim(replace(lily, drag=2.0 * lily.drag), 100.0, seed=3, base=lily)
    assert diagnose(dragging, lambda words, share: None).verdict == "mismatch"


def test_a_found_model_keeps_the_steps_by_which_it_was_found(swim: Swim) -> None:
    """However slow its numbers say the vehicle is: another step would average other readings."""
    lily = load_platform("lily")
    found = replace(lily, drag=0.01 * lily.drag, yaw_drag=0.01 * lily.yaw_drag, fitted_step=0.05)
    evidence = swim(lily, 100.0, seed=3, base=found)
    steps = [fit(evidence).tracks[0].timeline.grid.step for fit in (recalibration.first_fit, recalibration.base_fit)]
    assert steps == [0.05, 0.05]
