"""Recordings of --against that are of no well vehicle, or of another one, are told so; names are not sure then.

The boat's platform knows all but the sizes, so that a comparison takes seconds.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose_against import diagnose_against
from cocorosim_ros.diagnosis.findings import Diagnosis
from cocorosim_ros.diagnosis.report.json_file import diagnosis_tree

WEAK = np.array([0.7, 1.0])  # shares of the thrust
SAID = "The recordings of --against are not those of a well vehicle"
REMARK = "boat/pose: half of its readings repeat the last one."
EVEN = "boat/pose: 601 readings at 10 Hz."  # nothing that a reader has to know


@pytest.fixture(scope="module")
def driven(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Any]:
    """Function of a seed, of the shares of their thrust that the propellers have, and of the length of a drive [s]."""
    boat = boats.platform(tmp_path_factory.mktemp("boat"), boats.KNOWN)

    def drive(seed: int, shares: Any = 1.0, seconds: float = 60.0) -> Any:
        return boats.recorded(boat, boats.Truth(), seconds, seed, lambda command: shares * command)

    return drive


def compared(bad: Any, good: Any) -> Diagnosis:
    """The comparison of two recordings."""
    return diagnose_against(bad, good, lambda words, share: None)


@pytest.fixture(scope="module")
def weakened(driven: Callable[..., Any]) -> Diagnosis:
    """A weak left propeller, compared with a sound drive."""
    return compared(driven(6, WEAK), driven(5))


def told(diagnosis: Diagnosis) -> Any:
    """Names and numbers of all differences, without how sure they are."""
    effects = [(each.id, each.topic, each.parameters, each.nats) for each in diagnosis.effects]
    return diagnosis.verdict, diagnosis.sentence, effects, diagnosis.recalibrated


def test_sound_recordings_say_nothing_of_themselves(weakened: Diagnosis) -> None:
    """The weak propeller is named and sure, and no remark or warning is about --against."""
    (found,) = weakened.effects
    gain = found.parameters["left"]
    assert (found.id, found.tier, found.because) == ("thruster_asymmetry", "confirmed", ())
    assert abs(gain.value - 0.7) <= gain.high - gain.low
    assert not [each for each in (*weakened.warnings, *weakened.remarks) if "--against" in each]
    assert diagnosis_tree(weakened)["against_remarks"] == []


def test_a_difference_that_is_the_platforms_own_number_is_that_of_the_others(driven: Callable[..., Any]) -> None:
    """Compared with a weak left propeller a sound one differs too: it is said that the others may not be well."""
    found = compared(driven(6), driven(5, WEAK))
    (effect,) = found.effects
    assert effect.id == "thruster_asymmetry"
    assert effect.parameters["left"].value == pytest.approx(1.0 / 0.7, rel=0.1)
    assert effect.tier == "suspected"
    assert any("Diagnose them by themselves" in sentence for sentence in effect.because)


def test_what_differs_from_repeated_readings_is_not_sure(driven: Callable[..., Any], weakened: Diagnosis) -> None:
    """Names and numbers stay as with sound recordings; a warning and a remark say what is wrong with --against."""
    good = driven(5)
    (recording,) = good.recordings
    (log,) = recording.robots
    streams = {"pose": replace(log.streams["pose"], filled_in=("x", "y"))}
    repeated = replace(recording, robots=(replace(log, streams=streams),), remarks=(REMARK, EVEN))
    good = replace(good, recordings=(repeated,))
    found = compared(driven(6, WEAK), good)
    verdict, sentence, *rest = told(weakened)
    assert told(found) == (verdict, sentence.replace("differ: ", "differ: perhaps "), *rest)
    (warning,) = found.warnings
    assert warning.startswith(SAID) and "many readings of x, y of boat/pose were interpolated or repeated" in warning
    assert [(each.tier, each.because) for each in found.effects] == [("suspected", (warning,))]
    assert found.remarks == (f"--against: {REMARK}",)
    tree = diagnosis_tree(found)
    assert (tree["against_remarks"], tree["warnings"]) == ([f"--against: {REMARK}"], [warning])


def test_another_boat_is_told_as_such(driven: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """Three times the mass, five times the inertia and more drag: nothing is named, and the factors are the reason."""
    good = driven(5)
    monkeypatch.setattr(boats, "MASS", 3.0 * boats.MASS)
    monkeypatch.setattr(boats, "INERTIA", 5.0 * boats.INERTIA)
    found = compared(boats.recorded(good.platform, boats.Truth(20.0, 60.0, 0.6), 60.0, 6), good)
    assert (found.verdict, found.effects, found.recalibrated, found.warnings) == ("insufficient", (), (), ())
    assert found.sentence.startswith("boat does not look like the same vehicle: thrust gain 0.28, ")
    assert found.sentence.endswith(" times as before; nothing is named.")
    assert found.reasons[0].startswith(
        "The recordings of boat and those of --against do not look like the same vehicle"
    )
    assert found.against is not None and found.against.unlike == ("boat",)
    assert (found.manoeuvres, diagnosis_tree(found)["reasons"]) == ((), list(found.reasons))


def test_a_loaded_boat_is_no_other_one(driven: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """With 1.6 times the mass and inertia the boat is still itself, and its inertia is told."""
    good = driven(5)
    monkeypatch.setattr(boats, "MASS", 1.6 * boats.MASS)
    monkeypatch.setattr(boats, "INERTIA", 1.6 * boats.INERTIA)
    found = compared(boats.recorded(good.platform, boats.Truth(), 60.0, 6), good)
    assert found.against is not None and found.against.unlike == ()
    assert found.verdict != "insufficient"


def test_what_differs_from_a_vehicle_that_was_damaged_halfway_is_not_sure(driven: Callable[..., Any]) -> None:
    """The left propeller of GOOD has half of its thrust in the second of two minutes: so nothing is sure."""
    found = compared(driven(6, WEAK), driven(5, np.repeat([[1.0, 1.0], [0.5, 1.0]], 120, axis=0), 120.0))
    (warning,) = (each for each in found.warnings if each.startswith(SAID))
    assert "the thrust of left of boat in their second half is 0." in warning
    assert all(each.tier == "suspected" and warning in each.because for each in found.effects)
