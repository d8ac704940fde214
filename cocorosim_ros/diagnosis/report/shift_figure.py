"""A picture of the shifts of the platform's numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence

from markupsafe import Markup

from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.findings import Recalibrated
from cocorosim_ros.diagnosis.report.believable import told_ends
from cocorosim_ros.diagnosis.report.figure_style import BEFORE, INK, QUIET, Drawing, Margins, style_axes


def shifts(parameters: Sequence[Recalibrated]) -> Markup:
    """Draw each parameter's fitted value and 95 % interval, where that is told, as percentages of its nominal value."""
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
            colour = BEFORE if min(low, high) > 0.0 or max(low, high) < 0.0 else QUIET
            # An end that is not told would leave no room for the others.
            ends = zip((low, high), told_ends(each.estimate), strict=True)
            told = [end for end, known in ends if not math.isinf(known)]
            axes.plot([*told, value], [place] * (len(told) + 1), color=colour, linewidth=2.0)
            axes.plot([value], [place], "o", color=colour, markersize=5)
        style_axes(axes)
        axes.axvline(0.0, color=INK, linewidth=0.8)
        axes.set_yticks(range(len(shown)), [_parameter_label(each, shown) for each in shown])
        axes.set_ylim(len(shown) - 0.4, -0.6)
        axes.set_xlabel("difference from the platform file [%]")
    return drawing.svg


def _parameter_label(found: Recalibrated, everything: Sequence[Recalibrated]) -> str:
    name = parameter_words(found.parameter)
    alone = sum(each.parameter == found.parameter for each in everything) == 1
    return name if alone else f"{name}, {', '.join(found.robots)}"
