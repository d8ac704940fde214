"""Shoaling statistics of one run or recording, with what was found on the way."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.card import Card, Shown, digits
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.read_only import read_only
from cocorosim_ros.scenario.reading.entry import nearest
from cocorosim_ros.study.metrics import COLUMN, METRICS, PAPER_METRICS
from cocorosim_ros.study.metrics.from_tracks import measure_samples
from cocorosim_ros.study.metrics.sampling import SampledTracks, Sampling
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True, eq=False, repr=False)
class ShoalStatistics(Shown):
    """All shoaling statistics of one run: over time, and summed up. What `cocorosim metrics` shows and writes."""

    name: str
    """What was measured: a recording's folder or a scenario."""
    digest: str | None
    """Of the recording; None where it has none, and for what is no recording."""
    robots: tuple[str, ...]
    """In alphabetical order."""
    stamp_ns: Integers
    """(t,) the moments at which the shoal was measured [ns]."""
    series: Floats
    """(t, metrics) values at each moment in SI units, NaN where undefined; columns in the order of `metrics`. Those of
    days lie in a temporary file, which the system reads where they are looked at."""
    findings: tuple[str, ...]
    """What was odd about recording or poses, in sentences."""
    summary: Mapping[str, Any]
    """Counts of moments and of absent robots; below `metrics` for each metric its unit, `value` (the mean, median or
    last value, as `summarised_by` says), mean, median, how many `ticks` it was defined at, and its formula in words.
    None where a metric was never defined."""

    @property
    def metrics(self) -> tuple[str, ...]:
        """The names of all metrics."""
        return tuple(METRICS)

    @property
    def time(self) -> Floats:
        """(t,) [s] since the first moment."""
        return read_only(np.asarray((self.stamp_ns - self.stamp_ns[0]) / NANOSECONDS))

    @property
    def values(self) -> dict[str, float]:
        """The number of each metric for the whole run in its SI unit, NaN where it was never defined."""
        numbers = {name: entry["value"] for name, entry in self.summary["metrics"].items()}
        return {name: float("nan") if value is None else value for name, value in numbers.items()}

    def __getitem__(self, metric: str) -> Floats:
        """(t,) one metric over time. Raises CocorosimError for a name that is none."""
        if metric not in self.metrics:
            raise CocorosimError(f"There is no metric {metric!r}{nearest(str(metric), METRICS)}.")
        return np.asarray(self.series[:, COLUMN[metric]])

    def tree(self) -> dict[str, Any]:
        """What `cocorosim metrics --json` writes: nested plain values, ready for JSON."""
        return {
            "recording": self.name,
            "digest": self.digest,
            "robots": list(self.robots),
            "start_ns": int(self.stamp_ns[0]),
            "end_ns": int(self.stamp_ns[-1]),
            "findings": list(self.findings),
            **self.summary,
        }

    def to_frame(self) -> pd.DataFrame:
        """One row a moment: `time` [s] since the first, then one column a metric in its SI unit."""
        return data_frame({"time": self.time, **{name: self[name] for name in METRICS}})

    def summary_frame(self) -> pd.DataFrame:
        """One row a metric: its name in `metric`, then what `summary` says of it, from `value` to `formula`."""
        keys = ("value", "unit", "mean", "median", "ticks", "summarised_by", "paper", "formula")
        entries = self.summary["metrics"]
        return data_frame({"metric": list(entries), **{key: [part[key] for part in entries.values()] for key in keys}})

    def card(self) -> Card:
        """The paper's six metrics of the whole run."""
        entries = {name: self.summary["metrics"][name] for name in PAPER_METRICS}
        rows = [
            (name, digits(entry["value"]), entry["unit"], entry["summarised_by"]) for name, entry in entries.items()
        ]
        facts = {"robots": str(len(self.robots)), "moments": str(len(self.stamp_ns))}
        title = f"shoaling statistics of {self.name}"
        return Card(title, facts, ("metric", "value", "unit", "value is the"), rows, self.findings)


def statistics_of(
    samples: SampledTracks | Sampling, name: str, digest: str | None = None, findings: Sequence[str] = ()
) -> ShoalStatistics:
    """The statistics of robots at common moments; `findings`: what was found before."""
    monitor = measure_samples(samples)
    summary = monitor.summary()
    return ShoalStatistics(
        name,
        digest,
        samples.names,
        read_only(monitor.stamps_ns),
        read_only(monitor.final_series()),
        (*findings, *samples.findings, *summary["notes"]),
        {key: value for key, value in summary.items() if key not in ("robots", "notes")},
    )
