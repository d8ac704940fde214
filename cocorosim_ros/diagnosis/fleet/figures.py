"""Pictures of a fleet: numbers that drift, each over the weeks, and the drifts of all robots beside each other."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from markupsafe import Markup
from matplotlib.axes import Axes

from cocorosim_ros.diagnosis.criteria.fleet import FLEET_PAGE
from cocorosim_ros.diagnosis.fitting.unknowns import Z95
from cocorosim_ros.diagnosis.fleet.drift import Drift
from cocorosim_ros.diagnosis.fleet.sentence import number_words
from cocorosim_ros.diagnosis.fleet.series import Series
from cocorosim_ros.diagnosis.report.figure_style import AFTER, BEFORE, INK, QUIET, Drawing, Margins, style_axes
from cocorosim_ros.foundation.arrays import Floats


def drift_pictures(drifts: Sequence[Drift]) -> Markup:
    """Draw each number over the weeks with its intervals, and the line through them with its 95 % band."""
    if not drifts:
        return Markup("")
    across = FLEET_PAGE.pictures_across
    down = math.ceil(len(drifts) / across)
    with Drawing(down, across, 0.55 + 2.2 * down, Margins(across=0.75, down=0.85)) as drawing:
        for place in range(across * down):
            axes = drawing.axes[place // across, place % across]
            if place < len(drifts):
                _draw(axes, drifts[place])
            else:
                axes.set_visible(False)
    return drawing.svg


def all_drifts(drifts: Sequence[Drift]) -> Markup:
    """Draw the drift of one number in each robot with its 95 % interval, the largest loss on top."""
    ordered = sorted(drifts, key=lambda each: each.per_week.value)
    if len(ordered) > FLEET_PAGE.most_robots:  # those in the middle are alike
        half = FLEET_PAGE.most_robots // 2
        ordered = [*ordered[:half], *ordered[-half:]]
    if not ordered:
        return Markup("")
    with Drawing(1, 1, 0.7 + 0.17 * len(ordered), Margins(left=1.4, top=0.1)) as drawing:
        axes = drawing.axes[0, 0]
        for place, each in enumerate(ordered):
            share = 100.0 if each.series.relative else 1.0
            low, value, high = (share * end for end in (each.per_week.low, each.per_week.value, each.per_week.high))
            colour = BEFORE if each.clear else QUIET
            axes.plot([low, high], [place, place], color=colour, linewidth=1.8)
            axes.plot([value], [place], "o", color=colour, markersize=4)
        style_axes(axes)
        axes.axvline(0.0, color=INK, linewidth=0.8)
        axes.set_yticks(range(len(ordered)), [each.series.robot for each in ordered], fontsize=8)
        axes.set_ylim(len(ordered) - 0.4, -0.6)
        axes.set_xlabel("gained a week [%]" if ordered[0].series.relative else f"a week [{ordered[0].series.unit}]")
    return drawing.svg


def _draw(axes: Axes, drift: Drift) -> None:
    series = drift.series
    weeks = np.linspace(series.weeks.min(), series.weeks.max(), FLEET_PAGE.points)
    mean, low, high = (_shown(series, each) for each in drift.course(weeks))
    value, least, most = (_shown(series, series.value + end * Z95 * series.spread) for end in (0.0, -1.0, 1.0))
    axes.fill_between(weeks, low, high, color=BEFORE, alpha=0.2, linewidth=0)
    axes.plot(weeks, mean, color=BEFORE, linewidth=1.6)
    axes.vlines(series.weeks, least, most, color=AFTER, linewidth=1.0)
    axes.plot(series.weeks, value, "o", markersize=3.2, color=AFTER)
    style_axes(axes)
    axes.set_title(f"{series.robot}, {number_words(series.parameter)}")
    axes.set_xlabel("weeks")
    axes.set_ylabel("off the platform's [%]" if series.relative else f"[{series.unit}]")


def _shown(series: Series, values: Floats) -> Floats:
    """Values of a series as they are drawn: in percent off the nominal value, or in their unit."""
    return 100.0 * np.expm1(values) if series.relative else values
