"""Joint fits that are torn: a large difference has drawn the shared numbers away from what was learned.

Numbers that the recordings of --against and the judged ones share settle between both, or go over to the judged ones,
where these differ by much. From there a climb may not lead back, and a likely difference is named in the place of the
true one. So what differs is looked for a second time, from the numbers as they were learned.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.against import COMPARISON
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import climbed
from cocorosim_ros.diagnosis.naming.named_effect import Naming


def is_torn(learned: Fit, joint: Fit) -> bool:
    """Tell whether a shared number is far from what was learned, by how well the learned vehicle knows it."""
    spread = np.sqrt(np.diag(covariance(learned)))
    return bool((np.abs(joint.q - learned.q) > COMPARISON.torn * spread).any())


def as_learned(learned: Fit, joint: Fit) -> Fit:
    """Put the shared numbers of a joint fit back to what was learned, and fit the noise alone."""
    numbers = replace(joint, rows=replace(joint, q=learned.q).filled, unknowns=(), q=np.zeros(0))
    noise = climbed(evaluated(numbers))
    return evaluated(replace(joint, q=learned.q, noise=noise.noise, q_noise=noise.q_noise))


def surer(first: Naming, again: Naming) -> Naming:
    """Choose between what was named on a torn fit, `first`, and from the numbers as learned, `again`.

    The latter has to be ahead of the former, and of the torn fit without any name by enough evidence for all its names.
    """
    needed = NAMING.threshold * sum(effect.candidate.spread for effect in again.named)
    ahead = again.fit.objective - first.base.objective
    return again if again.named and ahead > needed and again.fit.objective > first.fit.objective else first
