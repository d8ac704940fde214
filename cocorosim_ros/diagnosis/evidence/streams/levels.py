"""Levels of readings: the different values that they have, and the steps between these."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import NOISE
from cocorosim_ros.foundation.arrays import Floats


def steps_between(value: Floats, rounding: float, turn: float = 0.0) -> Floats:
    """Steps (m,) [unit of value] between neighbouring levels of readings (n,), but for those that rounding makes.

    turn: a full turn [unit of value] of angles, which are counted on from turn to turn, and 0 for what is none. An
    instrument's digits seldom divide a turn, so that a few steps of angles, at the ends of turns, are short ones: the
    shortest few are left out.
    """
    steps = np.diff(np.unique(value))
    steps = steps[steps > max(rounding, NOISE.finest_of_turn * turn)]
    if turn and steps.size:
        steps = steps[steps >= np.quantile(steps, NOISE.ends_of_turns)]
    return np.asarray(steps)
