"""Numbers that foretell worse than the platform's own are held: a log that is true in some parts, a ferry."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.foretelling.collapse import collapsed_channels
from cocorosim_ros.diagnosis.foretelling.free_runs import held_out_free_runs
from cocorosim_ros.diagnosis.foretelling.restraint import Restrained, restrained
from cocorosim_ros.diagnosis.foretelling.unseen import unseen_parts
from cocorosim_ros.scenario.parts.platform import load_platform

Swim = Callable[..., Any]


def with_turning_commands_tripled(evidence: Any, among: list[tuple[float, float]]) -> Any:
    """The same recording, whose log has three times the difference of both thrusters' commands at these times [s]."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    command, time = log.command.copy(), log.command_time
    chosen = np.any([(time >= begin) & (time < end) for begin, end in among], axis=0)
    turn = command[chosen, 1] - command[chosen, 0]
    command[chosen, 0] -= turn
    command[chosen, 1] += turn
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, command=command),)),))


def test_numbers_that_stand_for_a_wrong_log_are_held(swim: Swim) -> None:
    """Fitted parts have commands logged three times as different as they were: a third of the torque gain fits them.

    In held-out parts the log is true, so that the platform as given foretells the heading there.
    """
    evidence = swim(load_platform("lily"), 480.0, seed=5)
    sound = base_fit(evidence)
    measure = unseen_parts(sound)
    assert restrained(sound, held_out_free_runs(measure, sound).table) == Restrained(sound)
    (split,), step = measure.splits, sound.tracks[0].timeline.grid.step
    wrong = with_turning_commands_tripled(evidence, [(span.first * step, span.end * step) for span in split.seen])
    base = base_fit(wrong)
    collapsed = held_out_free_runs(unseen_parts(base), base).table
    assert "heading" in collapsed_channels(collapsed)
    steady = restrained(base, collapsed)
    assert "yaw_torque_gain" in steady.held
    table = held_out_free_runs(unseen_parts(steady.base), steady.base).table
    assert table["heading"].recalibrated == pytest.approx(table["heading"].nominal, rel=0.1)
    assert any("heading" in sentence and "yaw_torque_gain" in sentence for sentence in steady.sentences)
