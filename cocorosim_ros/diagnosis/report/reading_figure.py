"""Picture of a sensor's deviation from the readings that the model expects."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import ResidualReading
from cocorosim_ros.diagnosis.report.binned_means import binned_means
from cocorosim_ros.diagnosis.report.figure_style import (
    AFTER,
    BEFORE,
    QUIET,
    Drawing,
    Margins,
    labelled,
    largest,
    style_axes,
)
from cocorosim_ros.foundation.units.quantity_text import handy_scale


def reading_figure(reading: ResidualReading) -> Markup:
    """Draw the deviation of the readings over the quantity that it depends on, before and after."""
    y_scale = handy_scale(largest(reading.before), reading.unit)
    x_scale = handy_scale(largest(reading.against), reading.against_unit)
    x = reading.against * x_scale.factor
    every = max(1, len(x) // REPORT.most_dots)
    with Drawing(1, 1, 3.0, Margins(top=0.1)) as drawing:
        axes = drawing.axes[0, 0]
        for values, colour, label in (
            (reading.before, BEFORE, "recalibrated"),
            (reading.after, AFTER, "with the effects"),
        ):
            y = values * y_scale.factor
            if not np.isfinite(y).any():
                continue
            axes.scatter(x[::every], y[::every], s=5, color=colour, alpha=0.25, linewidths=0)
            means = binned_means(x, y)
            axes.plot(means.centre, means.mean, "o-", color=colour, markersize=3.5, linewidth=1.2, label=label)
        axes.axhline(0.0, color=QUIET, linewidth=0.8)
        axes.set(
            xlabel=labelled(reading.regressor.replace("*", "\u00b7"), x_scale),
            ylabel=labelled(f"{reading.topic}, deviation", y_scale),
        )
        style_axes(axes)
        axes.legend(loc="upper right")
    return drawing.svg
