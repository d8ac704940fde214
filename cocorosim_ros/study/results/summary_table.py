"""Every column of every group in numbers: runs, quartiles, and A against its baseline, which is named, as CSV."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Iterator
from typing import Any

from cocorosim_ros.study.experiments.rows import STATISTICS
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.results.results import Results

HEADING = (
    *("design", "numerics", "group", "metric", "unit", "over time", "runs", "lower quartile", "median"),
    *("upper quartile", "baseline", "A against baseline", "A from", "A to"),
)
_TEXTS = ("design", "numerics", "group", "metric", "unit", "over time", "baseline")
_WORDS = {"": "own definition", "_time_mean": "mean", "_time_median": "median"}


def summary_csv(experiments: Iterable[Results]) -> str:
    """The table as text, one line for each group, kind of numerics, metric and way of summing up over time."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(HEADING)
    for results in experiments:
        writer.writerows(_lines(results))
    return stream.getvalue()


def summary_rows(experiments: Iterable[Results]) -> list[dict[str, Any]]:
    """The same for programs, a dict a line: numbers as such, None where a line of the text is empty."""
    lines = (dict(zip(HEADING, line, strict=True)) for results in experiments for line in _lines(results))
    return [{name: _plain(name, word) for name, word in line.items()} for line in lines]


def _plain(name: str, word: str) -> str | float | None:
    if not word:
        return None
    return word if name in _TEXTS else float(word)


def _lines(results: Results) -> Iterator[tuple[str, ...]]:
    for numerics in results.numerics:
        for group in results.groups:
            for name, metric in METRICS.items():
                for statistic in STATISTICS:
                    words = (str(results.about["design"]), numerics, group, name, metric.unit, _WORDS[statistic])
                    yield *words, *_numbers(results, numerics, group, f"{name}{statistic}")


def _numbers(results: Results, numerics: str, group: str, column: str) -> tuple[str, ...]:
    spread = results.spread(numerics, group, column)
    quartiles = (spread.lower, spread.median, spread.upper)
    found = results.effect(numerics, group, column)
    against: tuple[str, ...] = ("",) * 4
    if group != results.baseline:
        against = (results.baseline_of(group), *map(_digits, (found.value, found.low, found.high)))
    return (str(spread.runs), *map(_digits, quartiles), *against)


def _digits(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.6g}"
