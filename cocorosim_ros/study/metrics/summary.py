"""What a run of values comes to: time mean, time median and the number that the metric's record asks for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel
from cocorosim_ros.foundation.mapped_table import columns_of, is_in_file
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.metrics.median import median_of_first

_MOST_IN_MEMORY = 1 << 23  # bytes of the values of a run that lie in a file


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
    bits. Values of days, in a file, pass through memory a few metrics at a time.
    """
    found = _empty(values.shape[1:])
    at_once = len(METRICS)
    if is_in_file(values) and values.nbytes > _MOST_IN_MEMORY:
        at_once = max(1, _MOST_IN_MEMORY * len(METRICS) // values.nbytes)
    for begin in range(0, len(METRICS), at_once):
        end = min(begin + at_once, len(METRICS))
        part = _of_columns(values if at_once == len(METRICS) else columns_of(values, begin, end))
        for whole, numbers in zip(found, part, strict=True):
            whole[:, begin:end] = numbers
    value = np.empty(values.shape[1:])
    for column, metric in enumerate(METRICS.values()):
        value[:, column] = getattr(found, metric.summary)[:, column]
    return Summary(value, found.mean, found.median, found.defined)


def summary_of(name: str, values: Floats) -> float:
    """What one metric of one run comes to, as `summarise` has it in `value`; values (ticks,) at each moment."""
    found = _of_columns(np.ascontiguousarray(values)[:, None, None])
    return float(getattr(found, METRICS[name].summary)[0, 0])


class _Numbers(NamedTuple):
    """Of each run and column, (runs, columns)."""

    mean: Floats
    median: Floats
    last: Floats
    defined: Integers


def _empty(shape: tuple[int, ...]) -> _Numbers:
    return _Numbers(np.empty(shape), np.empty(shape), np.empty(shape), np.empty(shape, np.int64))


def _of_columns(values: Floats) -> _Numbers:
    """The numbers of values (ticks, runs, columns)."""
    found = _empty(values.shape[1:])
    _summarise(values, *found)
    return found


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
