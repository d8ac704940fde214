"""Means of a residual in classes of another quantity, with intervals that count separate visits alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.foundation.arrays import Flags, Floats


class BinnedMeans(NamedTuple):
    """Means of abscissa and values by class, and the half width of their 95 % interval (NaN: too few visits)."""

    centre: Floats
    mean: Floats
    half_width: Floats


@dataclass(frozen=True)
class CellEdges:
    """Edges of the cells of a map seen from above, along x and along y [m; world], ascending."""

    x: Floats
    y: Floats


def binned_means(abscissa: Floats, values: Floats, classes: int = 12) -> BinnedMeans:
    """The means in classes of about equal numbers of samples.

    Neighbouring samples of a smoothed residual are not independent: the interval is that of the mean over the separate
    visits of the robot to a class.
    """
    good = np.isfinite(abscissa) & np.isfinite(values)
    abscissa, values = abscissa[good], values[good]
    if not len(values):
        return BinnedMeans(*(np.empty(0) for _ in range(3)))
    edges = np.unique(np.quantile(abscissa, np.linspace(0.0, 1.0, classes + 1)))
    number = np.clip(np.searchsorted(edges, abscissa, side="right") - 1, 0, max(len(edges) - 2, 0))
    rows = [_class_mean(abscissa, values, number == each) for each in np.unique(number)]
    return BinnedMeans(*np.array(rows).T)


def _class_mean(abscissa: Floats, values: Floats, inside: Flags) -> tuple[float, float, float]:
    starts = np.flatnonzero(np.diff(inside.astype(np.int8), prepend=0) == 1)
    visits = np.searchsorted(starts, np.flatnonzero(inside), side="right") - 1
    counts = np.bincount(visits)
    means = np.bincount(visits, weights=values[inside]) / counts
    mean = float(values[inside].mean())
    if len(starts) < REPORT.fewest_visits:
        return float(abscissa[inside].mean()), mean, float("nan")
    # Long visits weigh more in the mean, and therefore in its error.
    weights = counts / counts.sum()
    error = float(np.sqrt(np.sum(weights**2 * (means - mean) ** 2) * len(starts) / (len(starts) - 1)))
    return float(abscissa[inside].mean()), mean, 1.96 * error


def mean_map(place: Floats, values: Floats, edges: CellEdges, least: int = 1) -> Floats:
    """Means (rows along y, columns along x, ...) of values (n, ...) in a grid of places (n, 2) [m; world].

    NaN in cells with fewer than `least` samples.
    """
    x, y = place.T
    columns = np.digitize(x, edges.x) - 1
    rows = np.digitize(y, edges.y) - 1
    shape = (len(edges.y) - 1, len(edges.x) - 1)
    inside = (columns >= 0) & (columns < shape[1]) & (rows >= 0) & (rows < shape[0])
    total = np.zeros((*shape, *values.shape[1:]))
    count = np.zeros(shape)
    np.add.at(total, (rows[inside], columns[inside]), values[inside])
    np.add.at(count, (rows[inside], columns[inside]), 1.0)
    count[count < least] = np.nan
    return total / count.reshape(*shape, *[1] * (values.ndim - 1))
