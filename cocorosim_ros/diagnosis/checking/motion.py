"""Motions of one message compared with each other, both averaged over the same short times."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.checking import CHECKING
from cocorosim_ros.foundation.arrays import Floats


def rate_of(time: Floats, value: Floats) -> Floats:
    """(n - lag,) mean rates of change over a short time, of values (n,) at times (n,) [s]."""
    lag = _lag(time)
    return np.asarray((value[lag:] - value[:-lag]) / np.maximum(time[lag:] - time[:-lag], CHECKING.shortest_step))


def averaged(time: Floats, value: Floats) -> Floats:
    """(n - lag,) means over the same times, by the trapezoidal rule."""
    lag = _lag(time)
    steps = np.append(0.0, np.cumsum(0.5 * (value[1:] + value[:-1]) * np.diff(time)))
    return np.asarray((steps[lag:] - steps[:-lag]) / np.maximum(time[lag:] - time[:-lag], CHECKING.shortest_step))


def rates_of(time: Floats, vectors: Floats) -> Floats:
    """(n - lag, axes) mean rates of change, as `rate_of`, of vectors (n, axes)."""
    return np.column_stack([rate_of(time, column) for column in vectors.T])


def averages_of(time: Floats, vectors: Floats) -> Floats:
    """(n - lag, axes) means over the same times, as `averaged`, of vectors (n, axes)."""
    return np.column_stack([averaged(time, column) for column in vectors.T])


def turned(vector: Floats, angle: Floats) -> Floats:
    """(n, 2) vectors turned counter-clockwise by angles (n,) [rad]."""
    cosine, sine = np.cos(angle), np.sin(angle)
    x, y = vector.T
    return np.column_stack([cosine * x - sine * y, sine * x + cosine * y])


def slope_and_correlation(one: Floats, other: Floats) -> tuple[float, float]:
    """Regression of the other on the one through the means, and correlation; zeros where one stands still."""
    good = np.isfinite(one) & np.isfinite(other)
    if np.count_nonzero(good) < CHECKING.fewest // 2:
        return 0.0, 0.0
    x, y = one[good] - one[good].mean(), other[good] - other[good].mean()
    spread, both = float(x @ x), float(np.sqrt((x @ x) * (y @ y)))
    return (float(x @ y) / spread, float(x @ y) / both) if both > 0.0 else (0.0, 0.0)


def _lag(time: Floats) -> int:
    usual = float(np.median(np.diff(time)))
    return max(1, min(round(CHECKING.over / usual) if usual > 0.0 else 1, len(time) // 2))
