"""Exchanged commands are put right where physics bears that out; a rough comparison that errs is overruled by it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.frames.correction import COMMAND, FrameCorrection, put_right
from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup, take_in
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.borne_out import borne_out
from cocorosim_ros.scenario.parts.platform import load_platform

SECONDS = 60.0
LEFT_FOR_RIGHT = FrameCorrection(
    COMMAND, "left and right are exchanged", "it was made up", 22.0, np.eye(3)[[1, 0, 2]], np.zeros(3)
)


def exchanged(evidence: Evidence) -> Evidence:
    """The same with the commands of the two thrusters exchanged."""
    (recording,) = evidence.recordings
    robots = tuple(put_right(log, [LEFT_FOR_RIGHT]) for log in recording.robots)
    return replace(evidence, recordings=(replace(recording, robots=robots),))


@pytest.fixture(scope="module")
def sound(swim: Callable[..., Any]) -> Evidence:
    """A minute of a Lily whose commands are right."""
    found: Evidence = swim(load_platform("lily"), SECONDS)
    return found


def test_commands_that_only_looked_exchanged_stay_as_they_are(sound: Evidence) -> None:
    """The intake without a comparison of the commands is taken, and nothing is mixed up."""
    wrong = Intake(exchanged(sound), (Mixup(("lily_01",), LEFT_FOR_RIGHT),), ())
    taken = borne_out(wrong, lambda: take_in(sound, by_commands=False))
    assert taken.mixups == ()
    (log,), (before,) = taken.evidence.recordings[0].robots, sound.recordings[0].robots
    np.testing.assert_array_equal(log.command, before.command)


def test_commands_that_are_exchanged_are_put_right(sound: Evidence) -> None:
    """The rough comparison finds it, streams among each other do not, and physics prefers what it found."""
    mixed = exchanged(sound)
    intake = take_in(mixed)
    assert [mixup.correction.wrong for mixup in intake.mixups] == [LEFT_FOR_RIGHT.wrong]
    assert take_in(mixed, by_commands=False).mixups == ()
    assert borne_out(intake, lambda: take_in(mixed, by_commands=False)) is intake


def test_what_streams_show_among_each_other_needs_no_physics(sound: Evidence, monkeypatch: pytest.MonkeyPatch) -> None:
    """A gyroscope of the other sign contradicts poses and compass, whatever was commanded: both change the same."""
    (recording,) = sound.recordings
    (log,) = recording.robots
    imu = replace(log.streams["imu"], value=log.streams["imu"].value * [-1.0, 1.0, 1.0, 1.0])
    robots = (replace(log, streams={**log.streams, "imu": imu}),)
    mixed = replace(sound, recordings=(replace(recording, robots=robots),))
    intake = take_in(mixed)
    assert [mixup.correction.topic for mixup in intake.mixups] == ["imu"]
    monkeypatch.setattr("cocorosim_ros.diagnosis.fitting.borne_out.base_fit", lambda _: pytest.fail("asked in vain"))
    assert borne_out(intake, lambda: take_in(mixed, by_commands=False)) is intake


def test_nothing_is_asked_where_nothing_was_changed(sound: Evidence) -> None:
    """A second intake costs a fit, and is made for a change alone."""
    intake = take_in(sound)
    assert borne_out(intake, lambda: pytest.fail("asked in vain")) is intake
