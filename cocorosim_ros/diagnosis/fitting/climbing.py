"""Steps to the maximum of the likelihood: unknowns by Gauss-Newton, noise by Fisher scoring.

Each step is accepted by the full likelihood alone.
Source: Ljung, System Identification (1999), chapter 7; Kristensen, Madsen and Jorgensen, Automatica 40 (2004) 225.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import CONVERGENCE, STEPS
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, information
from cocorosim_ros.diagnosis.fitting.noise_information import noise_information
from cocorosim_ros.diagnosis.fitting.solving import clipped, step_within

STEP_HALVINGS = 4


def improved(fit: Fit, rounds: int) -> Fit:
    """Climb by at most `rounds` Gauss-Newton steps of the unknowns, noise held, until a step gains too little."""
    for _ in range(rounds):
        if not fit.unknowns:
            return fit
        better = _unknowns_step(fit)
        if better is None or better.objective - fit.objective < CONVERGENCE.least_gain:
            return better if better is not None else fit
        fit = better
    return fit


def _unknowns_step(fit: Fit) -> Fit | None:
    """Take a Gauss-Newton step, halved until the fit is better; None if no half of it is."""
    known = information(fit)
    step = step_within(known.matrix, known.score, fit.unknowns, fit.q)
    return _first_better(
        fit, (replace(fit, q=clipped(fit.unknowns, fit.q + step / 2.0**halving)) for halving in range(STEP_HALVINGS))
    )


def with_noise(fit: Fit, rounds: int, which: Sequence[str] | None = None) -> Fit:
    """Climb by at most `rounds` scoring steps of the noise, unknowns held; of the columns in `which`, None: of all."""
    chosen = [index for index, unknown in enumerate(fit.noise) if which is None or unknown.column in which]
    for _ in range(rounds):
        if not chosen:
            return fit
        better = _noise_step(fit, chosen)
        if better is None:
            return fit
        gain = better.objective - fit.objective
        fit = better
        if gain < CONVERGENCE.least_gain:
            return fit
    return fit


def _noise_step(fit: Fit, chosen: Sequence[int]) -> Fit | None:
    """Take a scoring step of the noise `chosen` by number, damped until the fit is better; None if no damping helps.

    Damping is Levenberg's: the more of it, the more the step follows the score alone. Far from the optimum, as where
    the water does not push at all, the curvature says little.
    """
    score, matrix = noise_information(fit, chosen)
    if not (np.isfinite(score).all() and np.isfinite(matrix).all()):
        return None  # a model that runs away tells nothing of its noise
    unknowns = [fit.noise[index] for index in chosen]

    def damped(damping: float) -> Fit:
        step = step_within(matrix + damping * np.diag(np.diag(matrix)), score, unknowns, fit.q_noise[chosen])
        q = fit.q_noise.copy()
        largest = STEPS.largest_noise_step
        q[chosen] = clipped(unknowns, q[chosen] + np.clip(step, -largest, largest))
        return replace(fit, q_noise=q)

    return _first_better(fit, map(damped, STEPS.dampings))


def _first_better(fit: Fit, trials: Iterable[Fit]) -> Fit | None:
    """Evaluate trials until one has a greater objective than `fit`, and return it; None if none has."""
    better = (trial for trial in map(evaluated, trials) if trial.objective > fit.objective)
    return next(better, None)


def settled(fit: Fit, rounds: int, which: Sequence[str] | None = None) -> Fit:
    """Climb by turns of noise and unknowns, at most `rounds` of them, until neither moves the other any more.

    That is so where a turn gains nearly nothing after its first step. Noise is that of the columns in `which`, None:
    all.
    """
    for _ in range(rounds):
        stepped = with_noise(fit, 1, which)
        noisy = with_noise(stepped, 1, which) if stepped.objective - fit.objective > CONVERGENCE.least_gain else stepped
        fit = improved(noisy, 3)
        if fit.objective - stepped.objective < CONVERGENCE.settled:
            break
    return fit
