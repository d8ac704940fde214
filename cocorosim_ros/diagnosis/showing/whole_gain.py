"""Gain of all named effects together: free runs with all of them against free runs without any.

Each effect is judged when it is named, by the model as it is then. Together they may still foretell worse than the
platform's numbers alone, as where a dead band stands for a curve of the thrust that has another form.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUN_GAINS
from cocorosim_ros.diagnosis.foretelling.gains import gain
from cocorosim_ros.diagnosis.showing.beyond_the_floor import rows_of_motion
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of

FORETOLD_NO_BETTER = (
    "Free runs through data that no fit saw err more with all that is named than with the platform's fitted numbers "
    "alone."
)


def foretold_no_better(case: Case) -> Iterator[Objection]:
    """Object to effects of motion with all of which free runs against readings are worse than without any."""
    rows = rows_of_motion(case).values()
    errors = np.array([(row.recalibrated, row.augmented, row.noise_floor) for row in rows]).reshape(-1, 3) ** 2
    before, after, floor = errors.T
    if gain(before[None], after[None], floor).mean < -FREE_RUN_GAINS.material:
        for found, _ in effects_of(case):
            yield Objection(FORETOLD_NO_BETTER, effect=found)
