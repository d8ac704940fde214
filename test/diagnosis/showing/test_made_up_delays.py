"""Short delays among readings whose errors last: which of them the filter may have made up."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.showing.made_up_delays import is_made_up

GAP, STEP = 0.2, 0.05
"""Time between two velocities, and between two grid points of the filter [s]."""


def made_up(identifier: str, seconds: float, topic: str | None = None, *, lasting: str | None = "a") -> bool:
    """Whether an effect of so many seconds on one robot may be made up; lasting: the robot whose errors last."""
    entry = next(each for each in ENTRIES if (each.id, each.topic) == (identifier, topic))
    candidate = Candidate(entry, ("a",), ((0,),))
    unknowns = tuple(candidate.amplitudes())
    stream = SimpleNamespace(time=GAP * np.arange(50) + 0.01 * (np.arange(50) % 2))
    track = SimpleNamespace(
        log=SimpleNamespace(streams={"velocity": stream}),
        timeline=SimpleNamespace(grid=SimpleNamespace(step=STEP)),
    )
    memory = SimpleNamespace(column="memory.velocity", owner=SimpleNamespace(robots=(lasting,)))
    q = np.array([seconds / each.slope(0.0) for each in unknowns])
    fit: Any = SimpleNamespace(unknowns=unknowns, q=q, noise=(memory,) if lasting else (), tracks=(track,))
    return is_made_up(NamedEffect(candidate, 100.0, (), HeldOutGain(np.zeros(1), 0.5)), fit)


@pytest.mark.parametrize(
    ("identifier", "topic", "seconds", "told"),
    [
        ("sensor_latency", "velocity", 0.5 * GAP, False),
        ("sensor_latency", "velocity", 1.5 * GAP, True),
        ("thruster_lag", None, 0.5 * STEP, False),
        ("thruster_lag", None, 2.0 * STEP, True),
        ("clock_skew", "velocity", 1e-4, True),
        ("torque_bias", None, 1e-6, True),
    ],
)
def test_only_times_shorter_than_a_gap_are_made_up(
    identifier: str, topic: str | None, seconds: float, told: bool
) -> None:
    """A delay below the gap of its stream, a lag below a step; what is no time never is."""
    assert made_up(identifier, seconds, topic) is not told


@pytest.mark.parametrize("lasting", [None, "b"])
def test_where_errors_of_the_robot_are_white_a_short_delay_is_told(lasting: str | None) -> None:
    """No errors last, or those of another robot do."""
    assert not made_up("sensor_latency", 0.5 * GAP, "velocity", lasting=lasting)
