"""A made boat whose pod turns slowly, or whose reports come late: what is reported drives its model, or the orders.

The courses are SciPy's, of formulas written out in made/boats.py.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.following.reported_angles import with_reported_angles
from cocorosim_ros.diagnosis.evidence.streams.feedback import Feedback
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence

SECONDS, SEED = 160.0, 1
CHOPPY = 0.3  # N, at random
DRAG = boats.KNOWN.replace(boats.KNOWN[boats.KNOWN.index("  thruster_lag") :], "")  # known, thrusters follow at once
SLEW = 0.05  # rad in a tick of half a second


def slow(commands: Any) -> Any:
    """Commands (ticks, 2) as they are delivered: the angle goes by SLEW in a tick."""
    delivered = commands.copy()
    for tick in range(1, len(commands)):
        before = delivered[tick - 1, 1]
        delivered[tick, 1] = before + np.clip(commands[tick, 1] - before, -SLEW, SLEW)
    return delivered


def driven(folder: Path, stands: Any, late: float = 0.0) -> Evidence:
    """One drive of a pod that stands by `stands` of its commands, and reports that every 0.1 s, so late [s]."""
    boat = boats.platform(folder, DRAG, boats.with_pod())
    truth = boats.Truth(lag=0.0, choppy=CHOPPY)
    evidence = boats.recorded(boat, truth, SECONDS, SEED, thrust=stands, forces=boats.pod)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    moments = np.arange(0.05, SECONDS, 0.1)
    tick = np.clip(((moments - late) / boats.TICK).astype(int), 0, len(log.command) - 1)
    report = Feedback("turn", "angle", moments, stands(log.command)[tick, 1])
    told = replace(recording, robots=(replace(log, feedback=(report,)),))
    return with_reported_angles(replace(evidence, recordings=(told,)))


def said(evidence: Evidence) -> Any:
    """The diagnosis."""
    return diagnose(evidence, lambda words, share: None)


@pytest.fixture(scope="module")
def slowly(tmp_path_factory: pytest.TempPathFactory) -> Evidence:
    """A pod that takes 6 s from one side to the other."""
    return driven(tmp_path_factory.mktemp("slow"), slow)


def test_a_servo_that_is_reported_has_no_other_name(slowly: Evidence) -> None:
    """Nothing is missing from a model that is driven by where the pod stands, and the remark says what drives it."""
    found = said(slowly)
    assert (found.verdict, found.effects) in (("consistent", ()), ("recalibrate", ()))
    assert any("driven by the angles that turn reports, which explain" in remark for remark in found.remarks)


def test_without_its_report_the_same_servo_leaves_something_unexplained(slowly: Evidence) -> None:
    """The same drive, whose reports were not recorded: what the report spares."""
    logs = tuple(replace(log, feedback=(), acting=None) for log in slowly.recordings[0].robots)
    blind = replace(slowly, recordings=(replace(slowly.recordings[0], robots=logs),))
    assert said(blind).verdict == "mismatch"


def test_reports_that_come_late_do_not_drive(tmp_path: Path) -> None:
    """The pod stands as ordered, its reports are a second old: the orders explain the motion better, and are taken."""
    evidence = driven(tmp_path, lambda commands: commands, late=1.0)
    assert evidence.recordings[0].robots[0].acting is not None
    found = said(evidence)
    assert [effect.id for effect in found.effects] == []
    assert any(
        "driven by the angles that were ordered, since those that turn reports do not" in each for each in found.remarks
    )
