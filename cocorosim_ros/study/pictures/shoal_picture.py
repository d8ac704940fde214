"""One picture of a run: tracks from above and from the side, and the six metrics over time."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file
from cocorosim_ros.study.metrics import PAPER_METRICS
from cocorosim_ros.study.pictures.colours import robot_colours
from cocorosim_ros.study.pictures.extent import Extent, extent
from cocorosim_ros.study.pictures.facts import MetricSeries, ScenarioFacts
from cocorosim_ros.study.pictures.metric_panels import draw_metric, moments_per_group, time_axis
from cocorosim_ros.study.pictures.track_views import MOST_POSES, draw_from_above, draw_from_the_side
from cocorosim_ros.world.state.pose_track import Poses

_SIZE_INCHES, _DOTS_PER_INCH = (16.0, 10.0), 125
_STRONG_NS = 60_000_000_000
_MOST_IN_LEGEND = 16
_STYLE: Any = {"font.size": 11, "axes.titlesize": 12, "axes.labelsize": 11, "axes.edgecolor": "#777777"}


def draw_shoal(
    path: Path,
    tracks: Mapping[str, Poses],
    series: MetricSeries,
    scenario_facts: ScenarioFacts,
    force: bool = False,
) -> None:
    """The picture of the run is in the file `path`, a PNG of 2000 x 1250 pixels.

    tracks: poses per robot; robots without any are left out. An existing file is replaced only if `force`.
    Raises CocorosimError if there is nothing to draw, or if the file exists or cannot be written.
    """
    check_file(path, force=force)
    seen = {name: track for name, track in sorted(tracks.items()) if track.stamp_ns.size}
    if not seen or not series.stamp_ns.size:
        raise CocorosimError(f"{path} is not drawn: the run has no poses.")
    with matplotlib.rc_context(_STYLE):
        figure = _figure(seen, series, scenario_facts)
        try:
            FigureCanvasAgg(figure)
            figure.savefig(path, format="png")
        except OSError as error:
            with contextlib.suppress(OSError):
                path.unlink()
            raise CocorosimError(f"{path} cannot be written: {error.strerror}. Is there room?") from error


def _figure(tracks: Mapping[str, Poses], series: MetricSeries, facts: ScenarioFacts) -> Figure:
    figure = Figure(figsize=_SIZE_INCHES, dpi=_DOTS_PER_INCH, facecolor="white")
    view = extent(tracks, facts)
    above, side, panels = _axes(figure, view)
    last_ns = max(int(track.stamp_ns[-1]) for track in tracks.values())
    draw_from_above(above, tracks, facts, view, last_ns - _STRONG_NS)
    draw_from_the_side(side, tracks, facts, view, last_ns - _STRONG_NS)
    axis = time_axis(series.stamp_ns)
    for axes, name in zip(panels, PAPER_METRICS, strict=True):
        draw_metric(axes, name, series, axis)
    for axes in panels[-2:]:
        axes.set_xlabel(f"time [{axis.unit}]")
    _write_title(figure, tracks, series, facts)
    _write_legend(figure, tracks)
    figure.text(0.985, 0.012, _caption(tracks, series), ha="right", va="bottom", fontsize=9, color="#555555")
    return figure


def _axes(figure: Figure, view: Extent) -> tuple[Axes, Axes, list[Axes]]:
    """Axes from above, from the side, and of the six panels in two columns."""
    _, depth, height = (view.high - view.low).tolist()
    # A flat or a tall tank must leave room for the other view.
    share = min(max(height / (height + depth), 0.2), 0.5)
    left = figure.add_gridspec(
        2, 1, height_ratios=(1.0 - share, share), left=0.06, right=0.425, top=0.9, bottom=0.115, hspace=0.16
    )
    right = figure.add_gridspec(3, 2, left=0.485, right=0.985, top=0.9, bottom=0.115, hspace=0.3, wspace=0.16)
    above = figure.add_subplot(left[0])
    side = figure.add_subplot(left[1], sharex=above)
    panels = [figure.add_subplot(right[number]) for number in range(6)]
    return above, side, panels


def _write_title(figure: Figure, tracks: Mapping[str, Poses], series: MetricSeries, facts: ScenarioFacts) -> None:
    duration = (int(series.stamp_ns[-1]) - int(series.stamp_ns[0])) / 1e9
    robots = "1 robot" if len(tracks) == 1 else f"{len(tracks)} robots"
    parts = [robots, f"{duration:,.6g} s"] + ([] if facts.seed is None else [f"seed {facts.seed}"])
    figure.text(0.06, 0.962, facts.name, fontsize=19, fontweight="bold", va="center")
    figure.text(0.985, 0.962, "   ·   ".join(parts), fontsize=14, ha="right", va="center", color="#333333")


def _write_legend(figure: Figure, tracks: Mapping[str, Poses]) -> None:
    if len(tracks) > _MOST_IN_LEGEND:
        return
    handles = [Line2D([], [], color=colour, linewidth=4) for colour in robot_colours(list(tracks)).values()]
    figure.legend(
        handles,
        list(tracks),
        loc="lower left",
        bbox_to_anchor=(0.052, 0.0),
        ncols=min(len(tracks), 6),
        frameon=False,
        fontsize=10,
        handlelength=1.2,
        columnspacing=1.4,
    )


def _caption(tracks: Mapping[str, Poses], series: MetricSeries) -> str:
    """What the signs mean, and below what was drawn instead of everything, in words."""
    first_ns = min(int(track.stamp_ns[0]) for track in tracks.values())
    last_ns = max(int(track.stamp_ns[-1]) for track in tracks.values())
    signs = ["ring: start, disc: end, arrow: final heading", "dashed: mean or median of the run"]
    sentences = ["strong: the last 60 s"] if last_ns - first_ns > _STRONG_NS else []
    step = max(-(-track.stamp_ns.size // MOST_POSES) for track in tracks.values())
    if step > 1:
        sentences.append(f"pale: one pose in {step}")
    group = moments_per_group(series)
    if group > 1:
        sentences.append(f"lines: mean of {group} moments, bands: their range")
    return "; ".join(signs) + "\n" + "; ".join(sentences)
