"""Share of a candidate's nats that errors of numbers of the platform's file may explain as well.

Added mass has one form, so that of an effect of inertia in the file only its numbers may be off. A candidate that acts
much as they do then explains their errors. With the numbers free beside all unknowns, within the tolerance of published
ones, a Gauss-Newton step tells where the candidate goes, and the inverse of the information how well it is known there.
What it is worth there, half the square of its amplitudes over their variance, is left to it, as a share of what it is
worth without them. A share, since where a candidate leaves hardly any random force over, its amplitudes are known far
better than its nats say: these grow with the logarithm of the force that it takes away.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit, information, slopes
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.foundation.arrays import Floats


def share_of_declared_errors(fit: Fit, candidate: Candidate, declared: Candidate) -> float:
    """Share (0 to 1) of the nats of a candidate of a fit that errors of a declared effect, which it holds, explain."""
    known, matrix_score = information(fit), _with_declared(fit, declared)
    if matrix_score is None:
        return 0.0
    matrix, score = matrix_score
    names = {amplitude.name for amplitude in candidate.entry.amplitudes}
    places = [place for place in candidate.places_among(fit.unknowns) if fit.unknowns[place].owner.parameter in names]
    moved = fit.q + solve(matrix, score)[: len(fit.q)]
    alone, beside = _worth(known.matrix, fit.q, places), _worth(matrix, moved, places)
    return float(np.clip(1.0 - beside / alone, 0.0, 1.0)) if alone > 0.0 else 0.0


def _worth(matrix: Floats, q: Floats, places: list[int]) -> float:
    """Half the square of some q over their covariance [nats], all other unknowns of an information matrix free."""
    covariance = solve(matrix, np.eye(len(matrix)))[np.ix_(places, places)]
    return 0.5 * float(q[places] @ solve(covariance, q[places]))


def _with_declared(fit: Fit, declared: Candidate) -> tuple[Floats, Floats] | None:
    """Information and score of the unknowns of a fit and then of the declared numbers; None where all are neutral."""
    numbers = [each for each in declared.amplitudes() if each.value(0.0) != 0.0]
    if not numbers:
        return None
    known, count = information(fit), len(fit.unknowns)
    shared, own, score = products_of_held(fit, numbers)
    tolerances = np.array([NAMING.declared_off * abs(each.value(0.0) / each.slope(0.0)) for each in numbers])
    matrix = np.zeros((count + len(numbers), count + len(numbers)))
    matrix[:count, :count], matrix[:count, count:], matrix[count:, :count] = known.matrix, shared, shared.T
    matrix[count:, count:] = own + np.diag(tolerances**-2)
    return matrix, np.concatenate([known.score, score])


def products_of_held(fit: Fit, numbers: Sequence[Unknown]) -> tuple[Floats, Floats, Floats]:
    """Products of slopes by numbers that a fit holds, with those of its unknowns and with each other; and their score.

    Shapes: (unknowns, numbers), (numbers, numbers) and (numbers,), without priors.
    """
    count = len(numbers)
    shared, own, score = np.zeros((len(fit.unknowns), count)), np.zeros((count, count)), np.zeros(count)
    theirs = slopes(fit, numbers, np.zeros(count))
    for mine, its, passed in zip(information(fit).slopes, theirs, fit.passes, strict=True):
        shared += weighted_products(mine, its, passed.variance)
        own += weighted_products(its, its, passed.variance)
        score -= weighted_products(its, passed.innovation[:, None], passed.variance).ravel()
    return shared, own, score
