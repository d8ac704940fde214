"""Box plots after figure 4 of the paper: black the baseline, red a large effect against it, blue none."""

from __future__ import annotations

import base64
import io

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.results.results import Results

COLOURS = {"baseline": "#222222", "large": "#c1272d", "other": "#1f5fa8"}
_WIDTH = 10.8  # inches of all panels beside each other
_CROWDED = 6  # groups, of more than which the names do not fit beside each other


def figure_of(results: Results, numerics: str, metrics: list[str]) -> str:
    """One panel per metric, a box per group, as SVG text for a page."""
    crowded = len(results.groups) > _CROWDED
    columns, height = (2, 4.4) if crowded else (3, 3.1)
    rows = -(-len(metrics) // columns)
    figure = Figure(figsize=(_WIDTH, height * rows), layout=ConstrainedLayoutEngine(h_pad=0.09, w_pad=0.09))
    for index, metric in enumerate(metrics):
        axes = figure.add_subplot(rows, columns, index + 1)
        _panel(axes, results, numerics, metric)
        if crowded:
            axes.tick_params(axis="x", labelrotation=90, labelsize=8)
    stream = io.BytesIO()
    figure.savefig(stream, format="svg", metadata={"Date": None})
    encoded = base64.b64encode(stream.getvalue()).decode("ascii")
    return f"data:image/svg+xml;base64,{encoded}"


def _panel(axes: Axes, results: Results, numerics: str, metric: str) -> None:
    groups = [group for group in results.groups if _known(results, numerics, group, metric).size]
    for place, group in enumerate(groups, start=1):
        colour = COLOURS[_kind(results, numerics, group, metric)]
        line = {"color": colour, "linewidth": 1.2}
        axes.boxplot(
            _known(results, numerics, group, metric),
            positions=[place],
            widths=0.55,
            patch_artist=True,
            boxprops={"edgecolor": colour, "facecolor": f"{colour}22", "linewidth": 1.2},
            medianprops={**line, "linewidth": 2.2},
            whiskerprops=line,
            capprops=line,
            flierprops={"marker": ".", "markersize": 2.5, "markerfacecolor": colour, "markeredgecolor": "none"},
        )
    marks = {"baseline": "", "large": " *", "other": " \u2212"}
    names = [f"{group}{marks[_kind(results, numerics, group, metric)]}" for group in groups]
    axes.set_xticks(range(1, len(groups) + 1), names)
    unit = METRICS[metric].unit
    axes.set_title(metric.replace("_", " ") + ("" if unit == "1" else f" [{unit}]"), fontsize=10.5, loc="left")
    axes.grid(axis="y", color="#dddddd", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def _known(results: Results, numerics: str, group: str, metric: str) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    values = results.values(numerics, group, metric)
    return values[~np.isnan(values)]


def _kind(results: Results, numerics: str, group: str, metric: str) -> str:
    if group == results.baseline:
        return "baseline"
    return "large" if results.effect(numerics, group, metric).size == "large" else "other"
