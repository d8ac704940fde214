"""The paper's six metrics over time, one small panel each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.metrics.summary import summary_of
from cocorosim_ros.study.pictures.decimation import MOST_GROUPS, envelope
from cocorosim_ros.study.pictures.facts import BOUNDED, MetricSeries

_LINE, _BAND = "#0b5c8a", "#a9cfe3"


@dataclass(frozen=True)
class TimeAxis:
    """Times of all panels in a unit that suits the length of the run."""

    time: Floats
    unit: str


def time_axis(stamp_ns: Integers) -> TimeAxis:
    """Time since the first stamp, in s, min or h."""
    seconds = (stamp_ns - stamp_ns[0]) / 1e9
    length = float(seconds[-1])
    for unit, size, shortest in (("h", 3600.0, 3 * 3600.0), ("min", 60.0, 900.0)):
        if length >= shortest:
            return TimeAxis(seconds / size, unit)
    return TimeAxis(seconds, "s")


def moments_per_group(series: MetricSeries) -> int:
    """How many moments one drawn point stands for."""
    return max(1, -(-series.stamp_ns.size // MOST_GROUPS))


def draw_metric(axes: Axes, name: str, series: MetricSeries, axis: TimeAxis) -> None:
    """One metric over time, and its summary over the run in the title and as a dashed line."""
    metric, values = METRICS[name], series.column(name)
    groups = envelope(axis.time, values, MOST_GROUPS)
    counts = metric.unit == "1" and name not in BOUNDED
    steps: Literal["post"] | None = "post" if counts and groups.per_group == 1 else None
    if groups.per_group > 1:
        axes.fill_between(groups.time, groups.low, groups.high, color=_BAND, linewidth=0, step=steps)
    drawstyle = "default" if steps is None else "steps-post"
    axes.plot(groups.time, groups.mean, color=_LINE, linewidth=1.4, drawstyle=drawstyle)
    summary = summary_of(name, values)
    if np.isfinite(summary) and metric.summary != "last":
        axes.axhline(summary, color="black", linewidth=0.9, linestyle=(0, (4, 3)))
    unit = "" if metric.unit == "1" else f" [{metric.unit}]"
    axes.set_title(name.replace("_", " ").capitalize() + unit, loc="left", fontweight="bold")
    axes.set_title(_in_words(metric.summary, summary, metric.unit), loc="right", fontsize=10, color="#444444")
    _set_scale(axes, name, metric.unit, values)
    if axis.time[-1] > axis.time[0]:
        axes.set_xlim(axis.time[0], axis.time[-1])


def _set_scale(axes: Axes, name: str, unit: str, values: Floats) -> None:
    axes.grid(color="#dddddd", linewidth=0.7)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    if name in BOUNDED:
        axes.set_ylim(-0.02, 1.02)
        return
    highest = float(np.nanmax(values, initial=0.0))
    axes.set_ylim(0.0, 1.08 * highest if highest > 0.0 else 1.0)
    axes.yaxis.set_major_locator(MaxNLocator(nbins=5, integer=unit == "1"))


def _in_words(kind: str, summary: float, unit: str) -> str:
    if not np.isfinite(summary):
        return "never defined"
    shown = f"{summary:.0f}" if kind == "last" else f"{summary:.3g}"
    return f"{'total' if kind == 'last' else kind} {shown}{'' if unit == '1' else ' ' + unit}"
