"""What roll and pitch add to the forces of a hull: against the balance of momentum along the hull's own axes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.levelling import levelled
from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL
from cocorosim_ros.diagnosis.tracks.tilted_hull import TiltedHull
from cocorosim_ros.world.effects.anisotropic_drag import FORM_BY_NAME

MASS, LINEAR, QUADRATIC = np.array([17.0, 24.2, 26.1]), np.array([4.0, 6.2, 5.2]), np.array([18.2, 21.7, 37.0])
LIFT = np.array([0.0, 9.0, 14.0])
INERTIA, YAW_LINEAR, YAW_DRAG = 0.28, 0.07, 1.55
GRID, READ = Grid(1.0, 0.05, 200), 0.02
"""Steps of the filter, and of the readings [s]."""


def roll(t: Any) -> Any:
    """Roll at times [s]."""
    return 0.2 * np.sin(2.1 * t + 0.3)


def pitch(t: Any) -> Any:
    """Pitch at times [s]."""
    return 0.15 + 0.25 * np.sin(2.9 * t)


def heading(t: Any) -> Any:
    """Heading at times [s]."""
    return 0.4 * t + 0.3 * np.sin(0.8 * t)


def body_velocity(t: Any) -> Any:
    """Velocity (n, 3) along the hull's axes."""
    return np.column_stack([0.4 * np.sin(0.9 * t), 0.3 * np.cos(1.3 * t), 0.1 * np.sin(1.7 * t + 1.0)])


def to_level(t: Any) -> Any:
    """Rotations (n, 3, 3) from the hull's axes to level ones, written as a product of two."""
    found = []
    for r, p in zip(np.atleast_1d(roll(t)), np.atleast_1d(pitch(t)), strict=True):
        about_x = np.array([[1, 0, 0], [0, math.cos(r), -math.sin(r)], [0, math.sin(r), math.cos(r)]])
        about_y = np.array([[math.cos(p), 0, math.sin(p)], [0, 1, 0], [-math.sin(p), 0, math.cos(p)]])
        found.append(about_y @ about_x)
    return np.array(found)


def in_world(t: Any, level: Any) -> Any:
    """Vectors (n, 3) along level axes, along those of the world."""
    c, s = np.cos(heading(t)), np.sin(heading(t))
    return np.column_stack([c * level[:, 0] - s * level[:, 1], s * level[:, 0] + c * level[:, 1], level[:, 2]])


def momentum(t: Any, *, tilted: bool) -> Any:
    """Momentum (n, 3) in the world: of the hull as it is, or of one whose axes stay level."""
    turns, velocity = to_level(t), body_velocity(t)
    level = np.einsum("nij,nj->ni", turns, velocity)
    return in_world(t, np.einsum("nij,nj->ni", turns, MASS * velocity) if tilted else MASS * level)


def drag(t: Any, form: str, *, tilted: bool) -> Any:
    """Drag and lift (n, 3) along level axes: of the hull as it is, or of one whose axes stay level."""
    turns, velocity = to_level(t), body_velocity(t)
    own = velocity if tilted else np.einsum("nij,nj->ni", turns, velocity)
    fast = np.linalg.norm(own, axis=1)[:, None] if form == "total_speed" else np.abs(own)
    force = -(LINEAR + QUADRATIC * fast + LIFT * np.abs(own[:, :1])) * own
    return np.einsum("nij,nj->ni", turns, force) if tilted else force


def log_of(*, velocity: bool = True, attitude: bool = True) -> RobotLog:
    """What is recorded of this motion, exactly."""
    time = np.arange(0.0, 13.0, READ)
    level = np.einsum("nij,nj->ni", to_level(time), body_velocity(time))
    rate = 0.4 + 0.24 * np.cos(0.8 * time)
    imu = np.column_stack([rate, np.full((len(time), 3), np.nan)])
    streams = {"imu": Stream(time, imu, np.zeros(4))}
    if velocity:
        streams["velocity"] = Stream(time, level, np.zeros(3))
    known = Attitude(time, roll(time), pitch(time)) if attitude else None
    return RobotLog("rov", np.array([0.0]), np.zeros((1, 1)), streams, attitude=known)


def row_of(form: str) -> Any:
    """Numbers of the hull in a row of a model."""
    row = NEUTRAL.copy()
    row[COLUMN["mass"]] = MASS[0]
    row[COLUMN["added_mass.sway_minus_surge"]], row[COLUMN["added_mass.heave_minus_surge"]] = MASS[1:] - MASS[0]
    for axis, value in zip(("surge", "sway", "heave"), LINEAR, strict=True):
        row[COLUMN[f"linear_drag.{axis}"]] = value
    row[COLUMN["hull_lift.sway_by_drift"]], row[COLUMN["hull_lift.heave_by_climb"]] = LIFT[1:]
    row[COLUMN["yaw_inertia"]], row[COLUMN["linear_drag.yaw"]] = INERTIA, YAW_LINEAR
    row[COLUMN["yaw_drag"]] = YAW_DRAG
    row[COLUMN["drag"]], row[COLUMN["anisotropic_drag.form"]] = QUADRATIC[0], FORM_BY_NAME[form]
    row[COLUMN["anisotropic_drag.sway_ratio"]] = QUADRATIC[1] / QUADRATIC[0]
    row[COLUMN["anisotropic_drag.heave_ratio"]] = QUADRATIC[2] / QUADRATIC[0]
    return row


@pytest.mark.parametrize("form", ["total_speed", "own_speed"])
def test_a_level_model_with_these_forces_has_the_momentum_of_the_tilted_hull(form: str) -> None:
    """To what a difference over 0.2 s of swings within two seconds leaves, three hundredths of the force.

    Momentum in the world changes by the forces there. So the rate of the tilted hull's momentum, less its drag, is that
    of the level one, less drag and less what is added; rates are differences over 2 ms.
    """
    t, h = GRID.begin + (np.arange(GRID.points) + 0.5) * GRID.step, 1e-3
    rate = {kind: (momentum(t + h, tilted=kind) - momentum(t - h, tilted=kind)) / (2.0 * h) for kind in (True, False)}
    missing = -(rate[True] - rate[False]) + in_world(t, drag(t, form, tilted=True) - drag(t, form, tilted=False))
    added = in_world(t, TiltedHull(log_of(), GRID).wrench(row_of(form))[:, :3])
    scale = np.sqrt(np.mean(missing**2, axis=0))
    assert (scale > 0.2).all()
    off = np.sqrt(np.mean((added - missing) ** 2, axis=0))
    assert (off < 0.04 * scale).all()


def own_turn_rate(t: Any) -> Any:
    """Rate (n,) about the hull's own upward axis: an element of R^T dR/dt, with a difference over 2 ms."""
    h = 1e-3
    before, now, behind = (in_world_axes(moment) for moment in (t - h, t, t + h))
    return np.einsum("nji,njk->nik", now, (behind - before) / (2.0 * h))[:, 1, 0]


def in_world_axes(t: Any) -> Any:
    """Rotations (n, 3, 3) from the hull's axes to those of the world."""
    turns = to_level(t)
    return np.stack([in_world(t, turns[:, :, axis]) for axis in range(3)], axis=2)


def test_a_level_model_with_this_moment_turns_as_the_tilted_hull_does() -> None:
    """To three hundredths of the moment, as forces do.

    Along its own axes the hull has I dr/dt = N - K(r) - A u v; a level model has the rate of the heading in place of r,
    and level velocities.
    """
    t, h = GRID.begin + (np.arange(GRID.points) + 0.5) * GRID.step, 5e-3
    heading_rate, own = (lambda at: 0.4 + 0.24 * np.cos(0.8 * at)), own_turn_rate
    gained = [(rate(t + h) - rate(t - h)) / (2.0 * h) for rate in (heading_rate, own)]
    resisted = [(YAW_LINEAR + YAW_DRAG * np.abs(rate(t))) * rate(t) for rate in (heading_rate, own)]
    u, v, _ = body_velocity(t).T
    level = np.einsum("nij,nj->ni", to_level(t), body_velocity(t))
    munk = (MASS[1] - MASS[0]) * (u * v - level[:, 0] * level[:, 1])
    missing = INERTIA * (gained[0] - gained[1]) - (resisted[1] - resisted[0]) - munk
    added = TiltedHull(log_of(), GRID).wrench(row_of("own_speed"))[:, 3]
    scale = math.sqrt(np.mean(missing**2))
    assert scale > 0.05
    assert math.sqrt(np.mean((added - missing) ** 2)) < 0.04 * scale


def test_without_a_gyro_the_moment_is_that_of_the_added_mass_alone() -> None:
    """Of rates that no stream shows, nothing is said."""
    log = log_of()
    del log.streams["imu"]  # type: ignore[attr-defined]
    row = row_of("own_speed")
    row[[COLUMN["yaw_inertia"], COLUMN["linear_drag.yaw"], COLUMN["yaw_drag"]]] *= 10.0
    moment = TiltedHull(log, GRID).wrench(row)[:, 3]
    assert np.array_equal(moment, TiltedHull(log, GRID).wrench(row_of("own_speed"))[:, 3])
    assert np.abs(moment).max() > 0.05


def test_a_log_ahead_and_a_pressure_are_enough_where_a_hull_only_pitches() -> None:
    """Speed ahead and climb of a torpedo make nearly the forces of its whole velocity, but for what lies sideways."""
    time = np.arange(0.0, 13.0, READ)
    none, velocity = np.zeros(len(time)), body_velocity(time) * [3.0, 0.0, 1.0]
    attitude = Attitude(time, none, 0.6 * pitch(time))
    level = np.einsum("nij,nj->ni", attitude.turns(time), velocity)
    depth = -np.cumsum(level[:, 2]) * READ
    ahead = np.column_stack([velocity[:, 0], np.full((len(time), 2), np.nan)])
    pressure = Stream(time[::10], 9806.65 * depth[::10, None], np.zeros(1))
    logs = {
        "whole": {"velocity": Stream(time, velocity, np.zeros(3))},
        "ahead": {"velocity": Stream(time, ahead, np.zeros(3)), "pressure": pressure},
    }
    found = {}
    for name, streams in logs.items():
        log, _ = levelled(RobotLog("auv", np.zeros(1), np.zeros((1, 1)), streams, attitude=attitude))
        found[name] = TiltedHull(log, GRID).wrench(row_of("own_speed"))[:, [0, 2]]
    scale = np.sqrt(np.mean(found["whole"] ** 2, axis=0))
    assert (scale > 0.3).all()
    assert (np.sqrt(np.mean((found["ahead"] - found["whole"]) ** 2, axis=0)) < 0.1 * scale).all()


def test_nothing_is_known_without_attitude_or_velocity() -> None:
    """A robot that stays level, or whose velocity no log shows, has no such forces."""
    assert TiltedHull(log_of(), GRID).is_known
    assert not TiltedHull(log_of(velocity=False), GRID).is_known
    assert not TiltedHull(log_of(attitude=False), GRID).is_known


def test_noise_of_single_attitudes_hardly_counts() -> None:
    """Of five milliradians at every reading, which would be 0.5 N of a difference over 0.2 s, a fifth is left."""
    exact, noisy = log_of(), log_of()
    rng = np.random.default_rng(3)
    assert noisy.attitude is not None
    noise = 0.005 * rng.standard_normal((2, len(noisy.attitude.time)))
    object.__setattr__(
        noisy,
        "attitude",
        Attitude(noisy.attitude.time, noisy.attitude.roll + noise[0], noisy.attitude.pitch + noise[1]),
    )
    row = row_of("own_speed")
    off = TiltedHull(noisy, GRID).wrench(row) - TiltedHull(exact, GRID).wrench(row)
    assert float(np.sqrt(np.mean(off**2))) < 0.1
