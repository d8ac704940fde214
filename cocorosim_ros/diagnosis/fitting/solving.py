"""Linear systems of the fits: singular ones, and steps of unknowns that stand at their bounds."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.foundation.arrays import Flags, Floats


def solve(matrix: Floats, right: Floats) -> Floats:
    """Solve matrix x = right for a symmetric matrix that may be singular: x is 0 in directions without information."""
    if not (np.isfinite(matrix).all() and np.isfinite(right).all()):
        return np.zeros_like(right)
    scale = 1.0 / np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    values, vectors = np.linalg.eigh(matrix * scale[:, None] * scale)
    inverse = np.where(values > STEPS.no_information, 1.0 / np.maximum(values, 1e-300), 0.0)
    shaped = right * (scale if right.ndim == 1 else scale[:, None])
    result = vectors @ ((vectors.T @ shaped).T * inverse).T
    return np.asarray(result * (scale if right.ndim == 1 else scale[:, None]))


def step_within(matrix: Floats, score: Floats, unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """Solve for a step (n,) = matrix^-1 score, unknowns held that stand at a bound and would be pushed beyond it.

    Were they not held, the others would move to make room for a step that is then cut off.
    """
    step, free = np.zeros(len(unknowns)), not_held(score, unknowns, q)
    step[free] = solve(matrix[np.ix_(free, free)], score[free])
    return step


def not_held(score: Floats, unknowns: Sequence[Unknown], q: Floats) -> Flags:
    """Flags (n,) of the unknowns but those that stand at a bound and are pushed beyond it by their score."""
    pushes = np.sign(score) * STEPS.least_push
    return np.array([unknown.clipped(number + push) != number or push == 0.0
                     for unknown, number, push in zip(unknowns, q, pushes, strict=True)], dtype=bool)  # fmt: skip


def clipped(unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """Clip q (n,) of the unknowns, each to its bounds."""
    return np.array([unknown.clipped(number) for unknown, number in zip(unknowns, q, strict=True)])
