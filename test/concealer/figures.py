"""Rates with Wilson intervals, and the size at which a trial's answers become right."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
from scipy.optimize import minimize

Z95 = 1.959963984540054


def wilson(hits: int, of: int) -> tuple[float, float]:
    """95 % interval of a rate (Wilson 1927); (0, 1) where nothing was tried."""
    if of == 0:
        return 0.0, 1.0
    share, square = hits / of, Z95 * Z95 / of
    middle = (share + 0.5 * square) / (1.0 + square)
    half = Z95 / (1.0 + square) * math.sqrt(share * (1.0 - share) / of + square / (4.0 * of))
    return max(middle - half, 0.0), min(middle + half, 1.0)


def percent(share: float) -> str:
    """A share in percent, with as many digits as it has: 1%, 0.5%."""
    return f"{100.0 * share:g}%"


def rate(answers: Iterable[bool]) -> dict[str, float | int | None]:
    """Hits, trials, rate and its interval."""
    found = [bool(answer) for answer in answers]
    low, high = wilson(sum(found), len(found))
    share = sum(found) / len(found) if found else None
    return {"hits": sum(found), "of": len(found), "rate": share, "low": low, "high": high}


def spread(values: Sequence[float]) -> dict[str, float | int | None]:
    """Count, median and quartiles."""
    if not len(values):
        return {"of": 0, "median": None, "lower": None, "upper": None}
    lower, median, upper = np.percentile(values, [25.0, 50.0, 75.0])
    return {"of": len(values), "median": float(median), "lower": float(lower), "upper": float(upper)}


def power_curve(sizes: Sequence[float], right: Sequence[bool]) -> dict[str, float | int | None]:
    """Sizes at which half and nine tenths are right: a logistic curve over log size, weakly held to a usual slope.

    Both are None where fewer than five answers, or answers all of one kind, leave the curve open; `smallest_right` and
    `largest_wrong` say what there was.
    """
    out: dict[str, float | int | None] = {"of": len(sizes), "half": None, "nine_tenths": None}
    out["smallest_right"] = min((s for s, good in zip(sizes, right, strict=True) if good), default=None)
    out["largest_wrong"] = max((s for s, good in zip(sizes, right, strict=True) if not good), default=None)
    if len(sizes) < 5 or all(right) or not any(right):
        return out
    x, y = np.log(np.asarray(sizes)), np.asarray(right, dtype=float)

    def cost(theta: np.ndarray) -> float:
        score = (x - theta[0]) * math.exp(theta[1])
        fit = np.sum(np.logaddexp(0.0, score) - y * score)
        return float(fit + 0.5 * ((theta[0] + 1.5) / 1.5) ** 2 + 0.5 * ((theta[1] - 1.0) / 0.7) ** 2)

    middle, slope = minimize(cost, np.array([-1.5, 1.0]), method="Nelder-Mead").x
    return out | {
        "half": float(math.exp(middle)),
        "nine_tenths": float(math.exp(middle + math.log(9.0) / math.exp(slope))),
    }
