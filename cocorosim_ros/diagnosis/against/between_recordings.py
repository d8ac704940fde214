"""Intervals of differences, as wide as recordings of the sound vehicle differ among themselves.

A gyroscope has another bias on each dive. What differs between two sets of dives is then known no better than the mean
of biases of that spread, however sharply each dive tells its own: a variance between recordings is added to that of the
fit, once by the number of recordings on either side.
Source: DerSimonian and Laird, Controlled Clinical Trials 7 (1986) 177, equations 6 to 8.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.against.control import Alike
from cocorosim_ros.diagnosis.criteria.against import ALIKE
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Floats


def added_variances(candidate: Candidate, fit: Fit, alike: Alike) -> dict[str, float]:
    """Variance of q by column of an amplitude: that between recordings, over the number of them on each side.

    fit: the model with the difference that the candidate is; alike: recordings of the sound vehicle.
    """
    row = fit.filled[candidate.everybody[0]]
    shapes = {shape.column: float(row[COLUMN[shape.column]]) for shape in candidate.entry.shapes}
    told = alike.told_by_track(candidate, shapes).values()
    judged = len(candidate.everybody) / max(len(candidate.sharers), 1)
    found = {}
    for place, amplitude in enumerate(candidate.entry.amplitudes):
        seen = [each for each in told if each.matrix[place, place] > ALIKE.told]
        weight = np.array([each.matrix[place, place] for each in seen])
        score = np.array([each.score[place] for each in seen])
        if len(seen) > 1:
            found[amplitude.column] = variance_between(score / weight, weight) * (1.0 / len(seen) + 1.0 / judged)
    return found


def variance_between(value: Floats, weight: Floats) -> float:
    """Variance of what values (n,) of different recordings estimate; weight (n,): one over the variance of each.

    0 where they differ by no more than that.
    """
    mean = np.average(value, weights=weight)
    spread = float(weight @ np.square(value - mean)) - (len(value) - 1)
    return max(spread / float(weight.sum() - np.square(weight).sum() / weight.sum()), 0.0)
