"""Axes that were put right, as effects, and what they leave in doubt."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.frames.correction import COMMAND, Fault, FrameCorrection, affine
from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.diagnosis.showing.framing import mixed_up, unexplained
from cocorosim_ros.diagnosis.showing.hard_stops import stopped
from cocorosim_ros.scenario.parts.platform import load_platform

MIRRORED = affine("pose", Fault("x and y are swapped", "only so all agree"), 40.0, np.eye(4)[[1, 0, 2, 3]])
WEAK = FoundEffect("thruster_asymmetry", "thrusters that differ", "", ("lily_01",), "confirmed", {}, 300.0)


def intake(correction: FrameCorrection) -> Intake:
    """A recording of which one stream was put right."""
    evidence = Evidence(load_platform("lily"), ())
    return Intake(evidence, (Mixup(("lily_01",), correction),), ())


@pytest.mark.parametrize("rival", ["", COMMAND])
def test_axes_that_exchanged_commands_explain_too_are_suspected(rival: str) -> None:
    """The exchange is the rival, and what turns the robot may be that of the other side: nothing else is sure."""
    taken = intake(replace(MIRRORED, rival=rival))
    (mixup,) = mixed_up(taken)
    assert [each.id for each in mixup.ambiguous_with] == (["frame_mixup:thruster_command"] if rival else [])
    found = stopped((mixup, WEAK), unexplained(taken))
    assert [each.tier for each in found] == (["suspected"] * 2 if rival else ["confirmed"] * 2)
    assert found[0].because == ()
    assert [len(each.because) for each in found] == [0, 1 if rival else 0]
