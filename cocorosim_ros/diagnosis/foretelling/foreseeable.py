"""Held-out parts with free runs over which a heading can be foretold.

A heading that is not known at all errs by pi / sqrt(3) = 1.81 rad. Where free runs last so long that even the model of
the noise floor, which has a learnt force, errs by half of that, right models and wrong ones err alike: such runs choose
by chance. Shorter ones are taken instead.
"""

from __future__ import annotations

import math
from collections.abc import Collection

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUNS
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.foretelling.gains import FreeRuns
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen, unseen_parts

_TURNED = "heading"  # channel of free runs


def foreseeable_parts(base: Fit, seconds: float | None = None, among: Collection[int] | None = None) -> Unseen:
    """Hold out parts as `unseen_parts` does, with shorter free runs where a heading is not foretold over those wanted.

    seconds: the longest length of free runs [s]; None: that of a vehicle that moves as `base` does. Where no length is
    short enough, as for a compass that shows no heading at all, the length stays.
    """
    wanted = unseen_parts(base, seconds, among)
    if _foretells(wanted):
        return wanted
    shorter = (length for length in reversed(FREE_RUNS.lengths) if length < wanted.seconds)
    parts = (unseen_parts(base, length, among) for length in shorter)
    return next((each for each in parts if _has_windows(each) and _foretells(each)), wanted)


def _foretells(unseen: Unseen) -> bool:
    """Tell whether the noise floor's heading errs by less than FREE_RUNS.lost, or no reading shows a heading."""
    runs = FreeRuns(unseen, unseen.rows)
    if _TURNED not in runs.channels:
        return True
    return math.sqrt(runs.floor[runs.channels.index(_TURNED)]) < FREE_RUNS.lost


def _has_windows(unseen: Unseen) -> bool:
    return any(True for _ in unseen.windows())
