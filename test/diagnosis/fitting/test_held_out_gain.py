"""Held-out gains of some tracks of a fit alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.fitting import HELD_OUT
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.fitting.climbing import improved, settled
from cocorosim_ros.diagnosis.fitting.fit import evaluated
from cocorosim_ros.diagnosis.fitting.held_out import Block, held_out_gain
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.scenario.parts.platform import load_platform


def test_blocks_of_some_tracks_are_those_of_all_there(swim: Callable[..., Any]) -> None:
    """A gain on one recording says nothing of another, in which the same addition may foretell badly."""
    lily = load_platform("lily")
    wrong = replace(lily, drag=2.0 * lily.drag)
    one, other = swim(lily, 40.0, 1, base=wrong), swim(lily, 40.0, 2, base=wrong)
    base = first_fit(replace(one, recordings=(*one.recordings, *other.recordings)))
    more = improved(base, 2)
    every = held_out_gain(base, more).nats.reshape(2, HELD_OUT.blocks)
    second = held_out_gain(base, more, among=(1,))
    np.testing.assert_array_equal(second.nats, every[1])
    assert second.total != held_out_gain(base, more).total
    assert held_out_gain(base, more, among=(0, 1)).total == held_out_gain(base, more).total


TENTH_OF_YAW_DRAG = boats.PLATFORM.replace("value: 0.2, unit: N m s^2", "value: 0.02, unit: N m s^2")


def straight_then_turning(folder: Path, share: float = 1.0) -> Evidence:
    """A boat that turns in the last tenth of 100 s alone, whose file has a tenth of its yaw drag; a share of it."""
    boat = boats.platform(folder, boats.KNOWN, TENTH_OF_YAW_DRAG)
    commands = np.tile([0.5, 0.5], (200, 1))
    commands[np.arange(200) // 10 % 2 == 1] = [0.1, 0.1]
    commands[182:190], commands[190:198] = [0.9, -0.3], [-0.2, 0.8]
    rows = boats.course(boats.Truth(), commands, 1)[::2, :4]
    value = rows + np.array(boats.NOISE) * np.random.default_rng(5).standard_normal(rows.shape)
    stamps = 2 * boats.STEP * np.arange(len(value))
    told = stamps <= share * stamps[-1]
    pose = Stream(stamps[told], value[told], np.array(boats.NOISE))
    log = RobotLog("boat", boats.TICK * np.arange(200), commands, {"pose": pose})
    return Evidence(boat, (RecordingLog("made", 100.0, (log,)),))


def test_a_block_that_alone_tells_a_number_is_foretold_as_by_a_fit_without_it(tmp_path: Path) -> None:
    """A turn foretold from the way straight ahead: with the file's yaw drag, and not by slopes at ten times of it."""
    whole = settled(first_fit(straight_then_turning(tmp_path)), 6)
    base = evaluated(replace(whole, unknowns=(), q=np.zeros(0), rows=whole.filled))
    gain = held_out_gain(base, whole).nats[-1]
    ahead = settled(first_fit(straight_then_turning(tmp_path, share=0.9)), 6)
    marks = whole.tracks[0].timeline.parts(HELD_OUT.blocks) == HELD_OUT.blocks - 1
    foretold = evaluated(replace(whole, q=ahead.q))
    block = Block(0, marks)
    assert gain == pytest.approx(block.nats(foretold) - block.nats(base), rel=0.1)
    assert gain < -1000.0
