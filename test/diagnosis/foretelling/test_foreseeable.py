"""Free runs are no longer than a heading can be foretold, where a shorter length tells more."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.foretelling.foreseeable import foreseeable_parts
from cocorosim_ros.diagnosis.foretelling.free_runs import held_out_free_runs
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen, unseen_parts
from cocorosim_ros.scenario.parts.platform import load_platform

HALF_OF_A_GUESS = 0.5 * np.pi / np.sqrt(3.0)  # [rad]


@pytest.fixture(scope="module")
def swum(swim: Callable[..., Any]) -> Any:
    """A swim of a Lily."""
    return swim(load_platform("lily"), 300.0, seed=5)


def heading_of_the_floor(unseen: Unseen) -> float:
    """Error [rad] of the noise floor's heading."""
    return held_out_free_runs(unseen, unseen.base).table["heading"].noise_floor


def with_commands(evidence: Any, changed: Callable[[Any], Any]) -> Any:
    """The same recording with other commands in its log; changed: of the commands (n, actuators)."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    return replace(
        evidence, recordings=(replace(recording, robots=(replace(log, command=changed(log.command.copy())),)),)
    )


def without_turns(command: Any) -> Any:
    """Both thrusters at their mean: a log without any turn."""
    command[:, :2] = command[:, :2].mean(axis=1, keepdims=True)
    return command


def test_a_heading_that_is_foretold_keeps_the_length_of_the_runs(swum: Any) -> None:
    """A Lily's runs last as long as the times of a Lily ask for, to the same parts."""
    base = base_fit(swum)
    wanted, taken = unseen_parts(base), foreseeable_parts(base)
    assert heading_of_the_floor(wanted) < 0.2
    assert taken.seconds == wanted.seconds and taken.splits == wanted.splits


def test_a_heading_that_is_lost_on_the_way_shortens_the_runs(swum: Any) -> None:
    """Turns that no log tells are lost in the usual time; over a shorter one the turn goes on as it began."""
    base = base_fit(with_commands(swum, without_turns))
    wanted, taken = unseen_parts(base), foreseeable_parts(base)
    assert heading_of_the_floor(wanted) > HALF_OF_A_GUESS
    assert taken.seconds < wanted.seconds
    assert heading_of_the_floor(taken) < HALF_OF_A_GUESS


def with_headings_at_random(evidence: Any) -> Any:
    """The same recording, whose poses and compass show headings that have nothing to do with the vehicle's."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    rng = np.random.default_rng([2026, 11])
    streams = dict(log.streams)
    for topic in ("pose", "compass"):
        value = streams[topic].value.copy()
        value[:, -1] = rng.uniform(-np.pi, np.pi, len(value))
        streams[topic] = replace(streams[topic], value=value)
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def test_headings_that_no_length_foretells_leave_the_length(swum: Any) -> None:
    """Where the readings of a heading are noise, shorter runs tell no more of it, and less of the depth."""
    base = base_fit(with_headings_at_random(swum))
    wanted, taken = unseen_parts(base), foreseeable_parts(base)
    assert heading_of_the_floor(wanted) > HALF_OF_A_GUESS
    assert taken.seconds == wanted.seconds
