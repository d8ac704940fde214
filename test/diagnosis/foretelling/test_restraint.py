"""Numbers that foretell worse than the platform's own are held: a log that is true in some parts alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.fitting.fit import evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.foretelling.collapse import collapsed_channels
from cocorosim_ros.diagnosis.foretelling.free_runs import held_out_free_runs
from cocorosim_ros.diagnosis.foretelling.restraint import Restrained, mends, restrained
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen, unseen_parts
from cocorosim_ros.scenario.parts.platform import load_platform

Swim = Callable[..., Any]


class Swum(NamedTuple):
    """A recording, and the measure of its sound base."""

    evidence: Any
    measure: Unseen


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


@pytest.fixture(scope="module")
def sound(swim: Swim) -> Swum:
    """A swim of a Lily, and what is held out of it."""
    evidence = swim(load_platform("lily"), 480.0, seed=5)
    return Swum(evidence, unseen_parts(base_fit(evidence)))


@pytest.fixture(scope="module")
def wrong(sound: Swum) -> Any:
    """The same swim, whose log is true in held-out parts alone."""
    (split,), step = sound.measure.splits, sound.measure.tracks[0].timeline.grid.step
    return with_turning_commands_tripled(sound.evidence, [(each.first * step, each.end * step) for each in split.seen])


def test_numbers_that_stand_for_a_wrong_log_are_held(sound: Swum, wrong: Any) -> None:
    """Fitted parts have commands logged three times as different as they were: a third of the torque gain fits them.

    In held-out parts the log is true, so that the platform as given foretells the heading there.
    """
    good = sound.measure.base
    assert restrained(good, held_out_free_runs(sound.measure, good)) == Restrained(good)
    base = base_fit(wrong)
    collapsed = held_out_free_runs(unseen_parts(base), base)
    assert "heading" in collapsed_channels(collapsed.table)
    assert restrained(base, collapsed._replace(runs=collapsed.runs[:2])) == Restrained(base)  # two may be chance
    steady = restrained(base, collapsed)
    assert "yaw_torque_gain" in steady.held
    table = held_out_free_runs(unseen_parts(steady.base), steady.base).table
    assert table["heading"].recalibrated == pytest.approx(table["heading"].nominal, rel=0.1)
    assert any("heading" in sentence and "yaw torque gain" in sentence for sentence in steady.sentences)


def test_a_climb_that_ended_too_low_goes_on_with_all_numbers(sound: Swum) -> None:
    """A fit that stopped at three times the torque is less likely than one that holds the turning numbers.

    From that one the climb goes on, and ends where the sound fit is: nothing has to be held.
    """
    good = sound.measure.base
    gain = [unknown.owner.parameter for unknown in good.unknowns].index("yaw_torque_gain")
    q = good.q.copy()
    q[gain] += np.log(3.0)
    stopped = evaluated(replace(good, q=q))
    free = held_out_free_runs(unseen_parts(stopped), stopped)
    # What is not held out is fitted anew, which mends such a fit: so the collapse is put in.
    collapsed = free._replace(table=free.table | table(heading=(0.1, 1.0)))
    steady = restrained(stopped, collapsed)
    assert steady.held == () and steady.sentences == ()
    assert steady.base.objective == pytest.approx(good.objective, abs=1.0)
    assert steady.base.q[gain] == pytest.approx(good.q[gain], abs=0.01)


def table(**channels: tuple[float, float]) -> dict[str, HeldOut]:
    """Free runs whose errors are sure: by channel those of the platform as given, and of the found model."""
    return {
        name: HeldOut(nominal, found, found, 0.0, "m", {"augmented": (found, found)}, 20.0, "readings")
        for name, (nominal, found) in channels.items()
    }


def test_a_course_is_no_reason_to_hold_numbers(sound: Swum) -> None:
    """Where no reading shows a place, that of the base stands in, which an error of its instruments has bent."""
    good = sound.measure.base
    free = held_out_free_runs(sound.measure, good)
    bent = table(position=(1.0, 5.0))
    by_course = {"position": replace(bent["position"], against="course")}
    assert restrained(good, free._replace(table=by_course)) == Restrained(good)


@pytest.mark.parametrize(
    ("again", "mended"),
    [
        (table(position=(1.0, 0.9), heading=(1.0, 1.0)), True),  # 0.9 for 0.8 times 2
        (table(position=(1.0, 0.9), heading=(1.0, 1.3)), False),  # still worse than the platform as given
        (table(position=(1.0, 1.3), heading=(1.0, 0.5)), False),  # worse in another channel
        (table(position=(1.0, 1.2), heading=(1.0, 1.2)), True),  # 1.44 for 1.6
        (table(position=(10.0, 9.0), heading=(0.1, 0.1)), True),  # in multiples of the platform as given
    ],
)
def test_held_numbers_are_to_mend_what_had_collapsed(again: dict[str, HeldOut], mended: bool) -> None:
    """Before, headings erred by twice as much as with the platform as given, and positions by 0.8 of it."""
    assert mends(again, table(position=(1.0, 0.8), heading=(1.0, 2.0))) is mended


def test_a_diagnosis_says_what_it_holds(wrong: Any) -> None:
    """Of a log that is true in held-out parts alone: numbers are kept, names suspected, and the headline says it."""
    found = diagnose(wrong, lambda words, share: None)
    assert "yaw_torque_gain" in found.held
    assert any("yaw torque gain" in warning for warning in found.warnings)
    assert all(effect.tier == "suspected" for effect in found.effects)
    assert "collapsed" in found.sentence and found.verdict in ("mismatch", "insufficient")
    assert "yaw_torque_gain" not in {number.parameter for number in found.all_recalibrated}
    assert found.fit["heading"].augmented <= 1.25 * found.fit["heading"].nominal
