"""What was learned but makes the model run away from the recordings to be judged is taken back."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

GROWTH = 30.0  # 1/s, of a yaw rate; in 50 s without a reading it becomes e^1500 times what it was, beyond any number
UNSTABLE, HARMLESS = "linear_drag.yaw", "buoyancy_trim.force"


def silent(evidence: Any) -> Any:
    """The recordings with readings of the heading in the first and the last five seconds alone, and no others."""

    def cut(log: Any) -> Any:
        stream = log.streams["compass"]
        kept = (stream.time < 5.0) | (stream.time > stream.time[-1] - 5.0)
        return replace(log, streams={"compass": replace(stream, time=stream.time[kept], value=stream.value[kept])})

    recordings = tuple(replace(each, robots=tuple(cut(log) for log in each.robots)) for each in evidence.recordings)
    return replace(evidence, recordings=recordings)


def learned_with(base: Any, columns: tuple[str, ...]) -> Any:
    """A learned vehicle that has these numbers of effects beside the platform's own, at nothing."""
    from cocorosim_ros.diagnosis.against.learning import LEARNED
    from cocorosim_ros.diagnosis.fitting.fit import evaluated
    from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown

    robots, every = (base.tracks[0].name,), tuple(range(len(base.tracks)))
    more = tuple(Unknown(Owner(LEARNED, robots, each, "1"), each, every, 0.0, 1.0, prior=1.0) for each in columns)
    q = np.concatenate([base.q, np.zeros(len(more))])
    return evaluated(replace(base, unknowns=(*base.unknowns, *more), q=q))


@pytest.fixture(scope="module")
def sides(swim: Any) -> tuple[Any, Any]:
    """The recalibrated fit of a Lily, and evidence of another dive with a long silence."""
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.scenario.parts.platform import load_platform

    lily = load_platform("lily")
    return base_fit(swim(lily, 40.0, seed=1)), silent(swim(lily, 60.0, seed=2))


def joined(bad: Any, columns: dict[str, float]) -> Any:
    """A function that makes the model of a learned vehicle for other recordings, with numbers there by column."""
    from cocorosim_ros.diagnosis.fitting.fit import evaluated
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks

    tracks = make_tracks(bad)

    def make(learned: Any) -> Any:
        q = np.array([columns.get(each.column, value) for each, value in zip(learned.unknowns, learned.q, strict=True)])
        return evaluated(replace(learned, tracks=tracks, rows=learned.rows[: len(tracks)], q=q))

    return make


def test_a_model_that_follows_is_left_as_it_is(sides: tuple[Any, Any]) -> None:
    """A silence alone takes nothing back."""
    from cocorosim_ros.diagnosis.against.running import runnable

    base, bad = sides
    running = runnable(learned_with(base, (HARMLESS,)), joined(bad, {}))
    assert running.taken_back == ()
    assert HARMLESS in [unknown.column for unknown in running.joint.unknowns]


def test_what_grows_without_bounds_is_taken_back(sides: tuple[Any, Any]) -> None:
    """What was learned after it goes first, what was learned before it stays."""
    from cocorosim_ros.diagnosis.against.learning import learned_effects
    from cocorosim_ros.diagnosis.against.running import runnable, runs_away

    base, bad = sides
    make = joined(bad, {UNSTABLE: -GROWTH * bad.platform.yaw_inertia})
    learned = learned_with(base, (HARMLESS, UNSTABLE, "torque_bias.torque"))
    assert runs_away(make(learned))
    running = runnable(learned, make)
    assert running.taken_back == ("torque_bias", "linear_drag")
    assert learned_effects(running.learned) == ("buoyancy_trim",)
    assert not runs_away(running.joint)


@pytest.mark.parametrize(("share", "away"), [(0.5, False), (2.0, True)])
def test_slopes_beyond_the_bound_are_a_model_that_runs_away(sides: tuple[Any, Any], share: float, away: bool) -> None:
    """Readings so exact that the largest slope is this share of the bound, in their standard deviations."""
    from cocorosim_ros.diagnosis.against.running import runs_away
    from cocorosim_ros.diagnosis.criteria.against import COMPARISON
    from cocorosim_ros.diagnosis.fitting.fit import slopes

    base, _ = sides
    own = slopes(base, base.unknowns, base.q)
    largest = max(
        float((np.abs(moved) / np.sqrt(passed.variance)[:, None]).max())
        for moved, passed in zip(own, base.passes, strict=True)
    )
    factor = (largest / (share * COMPARISON.runaway)) ** 2
    passes = tuple(replace(passed, variance=factor * passed.variance) for passed in base.passes)
    assert runs_away(replace(base, passes=passes)) is away
