"""One row a run: the columns of a result table and how chunks of runs become rows."""

from __future__ import annotations

import time
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import pyarrow as pa

from cocorosim_ros.study.experiments.batch import run_each, runs_that_fit
from cocorosim_ros.study.experiments.code_version import version
from cocorosim_ros.study.experiments.design import Design
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.world.checks.loading import parse_scenario

STATISTICS = ("", "_time_mean", "_time_median")
"""What follows a metric's name in a column: nothing for the value in which its own definition sums up a run."""

SCHEMA = pa.schema(
    [
        ("numerics", pa.string()),
        ("group", pa.string()),
        ("replicate", pa.int64()),
        ("seed", pa.int64()),
        ("ticks", pa.int64()),
        *((f"{name}{statistic}", pa.float64()) for name in METRICS for statistic in STATISTICS),
        ("wall_seconds", pa.float64()),
        ("version", pa.string()),
    ]
)


class RowKey(NamedTuple):
    """Which run of which cell a row is of."""

    numerics: str
    group: str
    replicate: int


@dataclass(frozen=True)
class Chunk:
    """Some runs of one cell, with everything that a worker elsewhere needs."""

    numerics: str
    group: str
    first: int
    count: int
    scenario: str  # YAML


def chunks(design: Design, done: Collection[RowKey], size: int | None = None) -> Iterator[Chunk]:
    """What is left to do, cut into chunks of at most `size` runs, or as many as are worth calculating at once."""
    for cell in design.cells:
        text, most = cell.scenario.to_yaml(), size or runs_that_fit(cell.scenario)
        left = [run for run in range(design.replicates) if RowKey(cell.numerics, cell.group, run) not in done]
        for first, count in stretches(left, most):
            yield Chunk(cell.numerics, cell.group, first, count, text)


def stretches(numbers: Sequence[int], most: int) -> Iterator[tuple[int, int]]:
    """First number and length of each stretch of consecutive ascending `numbers`, none longer than `most`."""
    start = 0
    for end in range(1, len(numbers) + 1):
        broken = end == len(numbers) or numbers[end] != numbers[end - 1] + 1
        if broken or end - start == most:
            yield numbers[start], end - start
            start = end


def run_chunk(chunk: Chunk) -> pa.Table:
    """The rows of a chunk; the wall time of a batch is shared evenly by its runs.

    The row of a run that ran away has no values, and the ticks that it made.
    """
    began = time.perf_counter()
    scenario = parse_scenario(chunk.scenario, f"group '{chunk.group}' in numerics '{chunk.numerics}'")
    made = run_each(scenario, chunk.first, chunk.count)
    summary, ticks = made.summary, made.ticks
    parts = dict(zip(STATISTICS, (summary.value, summary.mean, summary.median), strict=True))
    columns = {
        "numerics": [chunk.numerics] * chunk.count,
        "group": [chunk.group] * chunk.count,
        "replicate": np.arange(chunk.first, chunk.first + chunk.count),
        "seed": np.full(chunk.count, scenario.seed),
        "ticks": ticks,
        **{
            f"{name}{statistic}": values[:, column]
            for column, name in enumerate(METRICS)
            for statistic, values in parts.items()
        },
        "wall_seconds": np.full(chunk.count, (time.perf_counter() - began) / chunk.count),
        "version": [version()] * chunk.count,
    }
    return pa.table(columns, schema=SCHEMA)
