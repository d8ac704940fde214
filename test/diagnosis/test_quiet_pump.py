"""Evidence for a pump's own behaviour: counted where the pump was moved by more than the water asks for."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.filter.layout import COMPASS, POSE_Z, UPRIGHT
from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.diagnosis.naming.quiet_pump import quiet_gain
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import load_platform

RANDOM_FORCE = 1e-4  # N
STEP = 0.1  # s


def fits(force: Any, nats: Any, kind: int = POSE_Z, before: float = RANDOM_FORCE) -> tuple[Any, Any]:
    """Two fits of one robot with a reading at each grid point, the second better by `nats` (points,) at each.

    before: random force [N] that the first fit needs.
    """
    rows = np.tile(NEUTRAL, (2, 1, 1))
    rows[:, 0, COLUMN["random.heave_force"]] = math.log(before), math.log(RANDOM_FORCE)
    stamps = STEP * np.arange(len(force))
    grid = Grid(0.0, STEP, len(force))
    upright = np.full(len(force), kind in UPRIGHT)
    timeline = SimpleNamespace(is_upright=upright, kind=np.full(len(force), kind), stamp=stamps, grid=grid)
    actuation = SimpleNamespace(drive=lambda row: force, lift=lambda drive: drive)
    track = SimpleNamespace(timeline=timeline, actuation=actuation, vehicle=vehicle_model(load_platform("lily")))
    one = SimpleNamespace(innovation=np.sqrt(2.0 * nats), variance=np.ones(len(force)))
    other = SimpleNamespace(innovation=np.zeros(len(force)), variance=np.ones(len(force)))
    return (
        SimpleNamespace(tracks=(track,), filled=rows[0], passes=(one,)),
        SimpleNamespace(tracks=(track,), filled=rows[1], passes=(other,)),
    )


def test_small_commands_do_not_count() -> None:
    """Ten times the random force to and fro is what holding a depth asks for: all of the gain is the water's."""
    force = 5.0 * RANDOM_FORCE * np.sign(np.sin(np.arange(200.0)))
    assert quiet_gain(*fits(force, np.full(200, 0.1))) == pytest.approx(20.0)


def test_what_follows_a_step_counts() -> None:
    """A step by a hundred times the random force tells of the pump for five seconds: fifty readings of two hundred."""
    force = np.where(np.arange(200) < 100, 0.0, 100.0 * RANDOM_FORCE)
    assert quiet_gain(*fits(force, np.full(200, 0.1))) == pytest.approx(0.1 * 151, abs=0.25)


def test_readings_that_are_level_are_not_asked() -> None:
    """A pump moves nothing but depth."""
    assert quiet_gain(*fits(np.zeros(50), np.ones(50), COMPASS)) == 0.0


def test_what_passed_for_random_force_does_not_make_a_pump_quiet() -> None:
    """A fit without the pump's fault takes it for water; how loud commands are follows from the fit that has it."""
    force = np.where(np.arange(200) < 100, 0.0, 100.0 * RANDOM_FORCE)
    assert quiet_gain(*fits(force, np.full(200, 0.1), before=20.0 * RANDOM_FORCE)) == pytest.approx(15.1, abs=0.25)
