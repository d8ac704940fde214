"""Held-out gains of some tracks of a fit alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import HELD_OUT
from cocorosim_ros.diagnosis.fitting.climbing import improved
from cocorosim_ros.diagnosis.fitting.held_out import held_out_gain
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
