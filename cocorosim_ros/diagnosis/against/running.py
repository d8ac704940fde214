"""Learned vehicles that can be run through the recordings to be judged.

A law that was learned from one part of a vehicle's states may be unstable in others. With readings out of reach for a
moment, as of a camera that has lost the vehicle, such a model runs away from them: its slopes grow without bounds, and
every candidate would look as if these recordings did not show it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.against.learning import learned_effects, without_last
from cocorosim_ros.diagnosis.criteria.against import COMPARISON
from cocorosim_ros.diagnosis.fitting.fit import Fit, finite, information


class Running(NamedTuple):
    """A learned vehicle, its joint fit, and what it was learned with but could not be run with, last learned first."""

    learned: Fit
    joint: Fit
    taken_back: tuple[str, ...]


def runnable(learned: Fit, joined: Callable[[Fit], Fit]) -> Running:
    """Take back what was learned last until the joint fit follows its recordings, or nothing learned is left.

    joined: makes the joint fit of a learned vehicle.
    """
    taken: tuple[str, ...] = ()
    joint = joined(learned)
    while runs_away(joint) and (names := learned_effects(learned)):
        learned, taken = without_last(learned), (*taken, names[-1])
        joint = joined(learned)
    return Running(learned, joint, taken)


def runs_away(fit: Fit) -> bool:
    """Tell whether a model does not follow its recordings: no likelihood, or slopes beyond all bounds."""
    if not finite(fit):
        return True
    known = information(fit)
    return not all(
        np.isfinite(felt.slopes).all()
        and (np.abs(felt.slopes) <= COMPARISON.runaway * np.sqrt(passed.variance)[:, None]).all()
        for felt, passed in zip(known.own, fit.passes, strict=True)
    )
