"""Nats of a candidate that errors of numbers of the platform's file may explain as well.

Added mass has one form, so that of an effect of inertia in the file only its numbers may be off. A candidate that acts
much as they do then explains their errors. With the numbers free beside all unknowns, within the tolerance of published
ones, a Gauss-Newton step tells where the candidate goes, and the inverse of the information how well it is known there.
What it is worth there, half the square of its amplitudes over their variance, is left to it.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit, information, slopes
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.foundation.arrays import Floats


def nats_of_declared_errors(fit: Fit, candidate: Candidate, declared: Candidate) -> float:
    """Nats of a candidate that a fit has which errors of a declared effect may explain; the fit holds its numbers."""
    known, matrix_score = information(fit), _with_declared(fit, declared)
    if matrix_score is None:
        return 0.0
    matrix, score = matrix_score
    names = {amplitude.name for amplitude in candidate.entry.amplitudes}
    places = [place for place in candidate.places_among(fit.unknowns) if fit.unknowns[place].owner.parameter in names]
    moved = fit.q + solve(matrix, score)[: len(fit.q)]
    return max(0.0, _worth(known.matrix, fit.q, places) - _worth(matrix, moved, places))


def _worth(matrix: Floats, q: Floats, places: list[int]) -> float:
    """Half the square of some q over their covariance [nats], all other unknowns of an information matrix free."""
    covariance = solve(matrix, np.eye(len(matrix)))[np.ix_(places, places)]
    return 0.5 * float(q[places] @ solve(covariance, q[places]))


def _with_declared(fit: Fit, declared: Candidate) -> tuple[Floats, Floats] | None:
    """Information and score of the unknowns of a fit and then of the declared numbers; None where all are neutral."""
    numbers = [each for each in declared.amplitudes() if each.value(0.0) != 0.0]
    if not numbers:
        return None
    known, count, more = information(fit), len(fit.unknowns), len(numbers)
    size = count + more
    matrix, score = np.zeros((size, size)), np.concatenate([known.score, np.zeros(more)])
    matrix[:count, :count] = known.matrix
    tolerances = np.array([NAMING.declared_off * abs(each.value(0.0) / each.slope(0.0)) for each in numbers])
    matrix[count:, count:] = np.diag(tolerances**-2)
    theirs = slopes(fit, numbers, np.zeros(more))
    for own, its, passed in zip(known.slopes, theirs, fit.passes, strict=True):
        shared = weighted_products(own, its, passed.variance)
        matrix[:count, count:] += shared
        matrix[count:, :count] += shared.T
        matrix[count:, count:] += weighted_products(its, its, passed.variance)
        score[count:] -= weighted_products(its, passed.innovation[:, None], passed.variance).ravel()
    return matrix, score
