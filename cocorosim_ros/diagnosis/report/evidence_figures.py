"""Pictures of the evidence for each effect of the catalogue, and of the shifts of the platform's numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence

from markupsafe import Markup
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import Diagnosis, Recalibrated, ScreenedEffect
from cocorosim_ros.diagnosis.report.figure_style import AFTER, BEFORE, INK, QUIET, Drawing, Margins, style_axes
from cocorosim_ros.diagnosis.report.number_text import plain_number


def bars_of_nats(diagnosis: Diagnosis) -> Markup:
    """Draw a bar per screened effect that explains anything, the strongest on top; colours: found, rival, other."""
    explaining = [each for each in diagnosis.screened if _nats(each) >= REPORT.least_nats]
    shown = sorted(explaining, key=lambda each: -_nats(each))
    if not shown:
        return Markup("")
    found = {each.id for each in diagnosis.effects}
    rivals = {rival.id for each in diagnosis.effects for rival in each.ambiguous_with}
    with Drawing(1, 1, 0.7 + 0.21 * len(shown), Margins(left=1.75, top=0.1)) as drawing:
        axes = drawing.axes[0, 0]
        for place, each in enumerate(shown):
            nats = _nats(each)
            colour = BEFORE if each.id in found else AFTER if each.id in rivals else QUIET
            axes.barh(place, nats - REPORT.least_nats, left=REPORT.least_nats, color=colour, height=0.7)
            words = plain_number(nats, 3 if nats >= REPORT.three_digits else 2)
            axes.annotate(words, (nats, place), (4, 0), textcoords="offset points", va="center", fontsize=8)
        style_axes(axes)
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(LogLocator())
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,g}"))
        axes.set_xlim(REPORT.least_nats, 4 * max(REPORT.three_digits, *(_nats(each) for each in shown)))
        axes.set_yticks(range(len(shown)), [each.id.replace("_", " ") for each in shown])
        axes.set_ylim(len(shown) - 0.4, -0.6)
        axes.grid(visible=False, axis="y")
        if math.isfinite(diagnosis.needed_nats):
            axes.axvline(diagnosis.needed_nats, color=INK, linewidth=0.9, linestyle="--")
        axes.set_xlabel("evidence [nats], by this effect alone over the recalibrated model")
    return drawing.svg


def without_bars(diagnosis: Diagnosis) -> list[str]:
    """The screened effects that explain too little for a bar."""
    return [each.id for each in diagnosis.screened if _nats(each) < REPORT.least_nats]


def shifts(parameters: Sequence[Recalibrated]) -> Markup:
    """Draw each parameter's fitted value and 95 % interval as a percentage of its nominal value."""
    shown = [each for each in parameters if each.nominal and math.isfinite(each.nominal)]
    if not shown:
        return Markup("")
    with Drawing(1, 1, 0.7 + 0.3 * len(shown), Margins(left=1.75, top=0.1)) as drawing:
        axes = drawing.axes[0, 0]
        for place, each in enumerate(shown):
            value, low, high = (
                100.0 * (end / each.nominal - 1.0)
                for end in (each.estimate.value, each.estimate.low, each.estimate.high)
            )
            low, high = min(low, high), max(low, high)
            colour = BEFORE if low > 0.0 or high < 0.0 else QUIET
            axes.plot([low, high], [place, place], color=colour, linewidth=2.0)
            axes.plot([value], [place], "o", color=colour, markersize=5)
        style_axes(axes)
        axes.axvline(0.0, color=INK, linewidth=0.8)
        axes.set_yticks(range(len(shown)), [_parameter_label(each, shown) for each in shown])
        axes.set_ylim(len(shown) - 0.4, -0.6)
        axes.set_xlabel("difference from the platform file [%]")
    return drawing.svg


def _parameter_label(found: Recalibrated, everything: Sequence[Recalibrated]) -> str:
    name = found.parameter.replace("_", " ")
    alone = sum(each.parameter == found.parameter for each in everything) == 1
    return name if alone else f"{name}, {', '.join(found.robots)}"


def _nats(screened: ScreenedEffect) -> float:
    return screened.nats if math.isfinite(screened.nats) else 0.0
