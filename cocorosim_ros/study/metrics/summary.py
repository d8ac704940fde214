"""What a run of values comes to: time mean, time median and the number that the metric's record asks for."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.metrics.median import median_of_first


@dataclass(frozen=True)
class Summary:
    """Numbers of whole runs, each (runs, len(METRICS)); moments at which a metric is undefined are left
    out.
    """

    value: Floats
    """The mean, median or last value, as the metric's `summary` says; NaN if it was never defined."""
    mean: Floats
    median: Floats
    defined: Integers
    """Number of moments at which the metric was defined."""


def summarise(values: Floats) -> Summary:
    """Summary of values (ticks, runs, len(METRICS)); the same run alone or among others gives the same
    bits.
    """
    shape = values.shape[1:]
    mean, median, last = np.empty(shape), np.empty(shape), np.empty(shape)
    defined = np.empty(shape, np.int64)
    _summarise(values, mean, median, last, defined)
    by_kind = {"mean": mean, "median": median, "last": last}
    value = np.empty(shape)
    for column, metric in enumerate(METRICS.values()):
        value[:, column] = by_kind[metric.summary][:, column]
    return Summary(value, mean, median, defined)


@allocating_kernel
def _summarise(
    values: Floats,
    mean: Floats,
    median: Floats,
    last: Floats,
    defined: Integers,
) -> None:
    series = np.empty(values.shape[0] + 1)
    for run in range(values.shape[1]):
        for column in range(values.shape[2]):
            total, count = 0.0, 0
            for tick in range(values.shape[0]):
                value = values[tick, run, column]
                if not np.isnan(value):
                    series[count] = value
                    total += value
                    count += 1
            defined[run, column] = count
            mean[run, column] = total / count if count > 0 else np.nan
            last[run, column] = series[count - 1] if count > 0 else np.nan
            median[run, column] = median_of_first(series, count)
