"""Evidence for a number beyond the bound at which its fit stands."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

from cocorosim_ros.diagnosis.criteria.fitting import RECALIBRATION
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, information
from cocorosim_ros.diagnosis.fitting.solving import not_held


class Beyond(NamedTuple):
    """Value of a number that is let through its bound [its unit], and the nats that the fit gains by it."""

    value: float
    nats: float


def beyond_a_bound(fit: Fit, place: int) -> Beyond:
    """Let the number at a place among the unknowns of a fit through the bound at which it stands.

    Everything is fitted anew, since the random force has taken on what the number is not allowed: by slopes at the
    bound, a weight that is far out of its range has hardly any evidence. The number stays where the readings do not
    push it outwards.
    """
    unknown, push = fit.unknowns[place], float(information(fit).score[place])
    if not_held(information(fit).score, fit.unknowns, fit.q)[place]:
        return Beyond(unknown.value(float(fit.q[place])), 0.0)
    low, high = unknown.bounds
    ends = (low, math.inf) if push > 0.0 else (-math.inf, high)
    unknowns = tuple(replace(each, bounds=ends) if each is unknown else each for each in fit.unknowns)
    free = settled(evaluated(replace(fit, unknowns=unknowns)), RECALIBRATION.most_rounds)
    return Beyond(unknown.value(float(free.q[place])), free.objective - fit.objective)
