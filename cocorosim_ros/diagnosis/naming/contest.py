"""The contest: candidates refined with everything else let loose, ranked by evidence, added one by one, pruned."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import Scene
from cocorosim_ros.diagnosis.criteria.naming import SEARCH
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.climbing import improved, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, information
from cocorosim_ros.diagnosis.fitting.screening import Screened
from cocorosim_ros.diagnosis.fitting.starts import best_start
from cocorosim_ros.diagnosis.fitting.unknowns import prior_precision
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE, WATER_NOISE
from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class Refined:
    """A candidate in a fit of everything; `nats`: logarithm of the Bayes factor over the model without it."""

    candidate: Candidate
    fit: Fit
    nats: float


@dataclass(frozen=True)
class Begun:
    """A candidate in a fit of all unknowns; `gain`: nats of its objective over the fit without it."""

    candidate: Candidate
    fit: Fit
    gain: float


def log_evidence(fit: Fit) -> float:
    """Laplace's approximation of the logarithm of the evidence, up to what all models of the same noise share.

    Each q has the prior of its Unknown; a flat one would make evidence meaningless, so none is flat.
    """
    if not fit.unknowns:
        return fit.objective
    matrix = information(fit).matrix
    precision = prior_precision(fit.unknowns)
    if not (np.isfinite(matrix).all() and math.isfinite(fit.objective)):
        return -math.inf
    with np.errstate(all="ignore"):  # a model that runs away is no evidence, whatever its determinant
        sign, log_matrix = np.linalg.slogdet(matrix)
    if not (sign > 0.0 and math.isfinite(log_matrix)):
        return -math.inf
    return fit.objective + 0.5 * float(np.sum(np.log(precision))) - 0.5 * float(log_matrix)


def _readings_of(candidate: Candidate) -> tuple[str, ...]:
    """The noise that a fault of a sensor may have been taken for: that of others, too, which disagree with it."""
    return READING_NOISE if candidate.entry.topic else ()


def begin(fit: Fit, screened: Screened, scene: Scene) -> Begun:
    """The candidate let loose together with all unknowns, from where the screening saw it; noise stays as it is."""
    candidate = screened.candidate
    rows = candidate.write(fit.rows, screened.values)
    new = [*candidate.amplitudes(), *candidate.shape_unknowns(screened.values, scene)]
    shapes = len(new) - len(screened.q)
    whole = replace(fit, rows=rows, unknowns=(*fit.unknowns, *new))

    def at(amplitudes: Floats) -> Fit:
        return evaluated(replace(whole, q=np.concatenate([fit.q, amplitudes, np.zeros(shapes)])))

    trial = improved(best_start(at, screened.q, candidate), 3)
    return Begun(candidate, trial, trial.objective - fit.objective)


def refine(begun: Begun, base_evidence: float) -> Refined:
    """The candidate with noise let loose as well."""
    trial = improved(with_noise(begun.fit, 1, WATER_NOISE), 3)
    if trial.objective - begun.fit.objective + begun.gain > SEARCH.last_steps:
        trial = improved(with_noise(trial, 2, (*WATER_NOISE, *_readings_of(begun.candidate))), 2)
    return Refined(begun.candidate, trial, log_evidence(trial) - base_evidence)
