"""Gain of all named effects together: free runs with all of them against free runs without any.

Each effect is judged when it is named, by the model as it is then. Together they may still foretell worse than the
platform's numbers alone, as where a dead band stands for a curve of the thrust that has another form.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUN_GAINS
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.exactness import is_beyond_steps, is_exact
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of

FORETOLD_NO_BETTER = (
    "Free runs through data that no fit saw err more with all that is named than with the platform's fitted numbers "
    "alone."
)


def foretold_no_better(case: Case) -> Iterator[Objection]:
    """Object to effects of motion with all of which free runs against readings are worse than without any.

    None beside a named error of readings: free runs begin with it, unless other readings show the same.
    """
    if is_exact(case.table) or not all(moves(effect.candidate) for effect in case.named):
        return
    if whole_gain(case.table) < -FREE_RUN_GAINS.material:
        for found, _ in effects_of(case):
            yield Objection(FORETOLD_NO_BETTER, effect=found)


def whole_gain(table: Mapping[str, HeldOut]) -> float:
    """Gain [logarithm of the error] of the model with the effects over the one without, by channels against readings.

    By the measure of `foretelling.gains`, with the errors of all windows together.
    """
    return sum(
        math.log(math.hypot(row.recalibrated, row.noise_floor) / math.hypot(row.augmented, row.noise_floor))
        for channel, row in table.items()
        if channel in CHANNELS and row.against == "readings" and is_beyond_steps(channel, row.augmented)
    )
