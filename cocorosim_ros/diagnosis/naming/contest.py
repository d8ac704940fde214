"""The contest: candidates fitted together with all other unknowns and ranked by the logarithm of their Bayes factor.

A candidate is begun with the noise held where it was, and refined with the noise fitted as well.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.naming import SEARCH
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.climbing import improved, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, information
from cocorosim_ros.diagnosis.fitting.screening import Screened
from cocorosim_ros.diagnosis.fitting.starts import best_start, by_softer_readings
from cocorosim_ros.diagnosis.fitting.unknowns import prior_precision
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE, WATER_RANDOM
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors.errors import SEEN_OTHERWISE
from cocorosim_ros.world.terms.search import Scene


@dataclass(frozen=True)
class Refined:
    """A candidate in a fit of all unknowns and the noise; `nats`: log Bayes factor over the model without it.

    usual: nats that were taken off because recordings that should be alike differ too.
    """

    candidate: Candidate
    fit: Fit
    nats: float
    usual: float = 0.0


@dataclass(frozen=True)
class Begun:
    """A candidate in a fit of all unknowns, noise held; `gain`: nats of its objective over the fit without it."""

    candidate: Candidate
    fit: Fit
    gain: float


def log_evidence(fit: Fit) -> float:
    """Logarithm of the evidence of a model [nats], by Laplace's approximation; minus infinity where the model ran away.

    objective + 1/2 sum(log prior precisions) - 1/2 log det(information): the objective at the fit plus the logarithm of
    the volume of the posterior over that of the prior. A constant that all models of the same noise share is left out.
    Each q has the prior of its Unknown; a flat prior would make evidence meaningless, so no prior is flat.
    Source: Kass and Raftery, JASA 90 (1995) 773, section 4.1.
    """
    if not fit.unknowns:
        return fit.objective
    matrix = information(fit).matrix
    precision = prior_precision(fit.unknowns)
    if not (np.isfinite(matrix).all() and math.isfinite(fit.objective)):
        return -math.inf
    with np.errstate(all="ignore"):  # a model that runs away has no evidence, whatever its determinant
        sign, log_matrix = np.linalg.slogdet(matrix)
    if not (sign > 0.0 and math.isfinite(log_matrix)):
        return -math.inf
    return fit.objective + 0.5 * float(np.sum(np.log(precision))) - 0.5 * float(log_matrix)


def _readings_of(candidate: Candidate) -> tuple[str, ...]:
    """Noise columns of readings to fit beside a candidate: all if it is a fault of a sensor, else none.

    Until the fault is in the model, the noise of any sensor that disagrees with the faulty one may stand for it.
    """
    return READING_NOISE if candidate.entry.topic else ()


def begin(fit: Fit, screened: Screened, scene: Scene) -> Begun:
    """Fit a candidate together with all unknowns of `fit`, noise held, from the values that the screening found."""
    candidate = screened.candidate
    rows = candidate.write(fit.rows, screened.values)
    new = [*candidate.amplitudes(), *candidate.shape_unknowns(screened.values, scene)]
    shapes = len(new) - len(screened.q)
    whole = replace(fit, rows=rows, unknowns=(*fit.unknowns, *new))

    def at(amplitudes: Floats) -> Fit:
        return evaluated(replace(whole, q=np.concatenate([fit.q, amplitudes, np.zeros(shapes)])))

    start, topic = best_start(at, screened.q, candidate), candidate.entry.topic
    if topic and any(each.column in SEEN_OTHERWISE for each in candidate.entry.amplitudes):
        softly = by_softer_readings(start, topic, len(fit.q), len(screened.q))
        start = max(start, at(softly), key=lambda each: each.objective)
    trial = improved(start, 3)
    return Begun(candidate, trial, trial.objective - fit.objective)


def refine(begun: Begun, base_evidence: float) -> Refined:
    """Go on with the fit of a candidate with the noise fitted too, and weigh it.

    base_evidence: logarithm of the evidence of the fit without the candidate [nats].
    """
    trial = improved(with_noise(begun.fit, 1, WATER_RANDOM), 3)
    gain, turns = trial.objective - begun.fit.objective + begun.gain, 0
    while gain > SEARCH.last_steps and turns < SEARCH.most_turns:
        before = trial.objective
        trial = improved(with_noise(trial, 2, (*WATER_RANDOM, *_readings_of(begun.candidate))), 2)
        gain, turns = trial.objective - before, turns + 1
    return Refined(begun.candidate, trial, log_evidence(trial) - base_evidence)
