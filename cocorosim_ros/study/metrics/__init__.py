"""Shoaling statistics: the paper's six metrics and their named variants, each defined once.

`METRICS` is the table of what exists, in the order of the columns of every array of values. To add a
metric: one file with a `FAMILY`, one line in `FAMILIES`; test/study/metrics/test_every_metric.py then runs on it.

Names are systematic: a plain name is the default reading of the paper; `_largest` takes the robots of the
largest shoal instead of all; `_travel` the direction of travel instead of the heading; `_median_centre` the
coordinate-wise median instead of the mean as centre; `_raw` distances in patches of 0.1 m instead of unit
vectors. The cost of one moment grows with the square of the number of robots (all pairs are measured).
"""

from __future__ import annotations

from cocorosim_ros.study.metrics import angular_momentum, lost, polarisation, separation, shoal_speed, shoals
from cocorosim_ros.study.metrics.metric import Family, Metric

FAMILIES: tuple[Family, ...] = (
    polarisation.FAMILY,
    angular_momentum.FAMILY,
    shoal_speed.FAMILY,
    separation.FAMILY,
    lost.FAMILY,
    shoals.FAMILY,
)

METRICS: dict[str, Metric] = {metric.name: metric for family in FAMILIES for metric in family.metrics}
"""Name of the metric -> its record; the position in the table is the metric's column."""

PAPER_METRICS: tuple[str, ...] = tuple(name for name, metric in METRICS.items() if metric.paper)
"""The six metrics of the paper, in the reading that this project takes as its default."""

COLUMN: dict[str, int] = {name: column for column, name in enumerate(METRICS)}
"""Name of the metric -> its column in arrays of values."""
