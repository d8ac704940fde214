"""Free runs of each model through held-out stretches of the recording, from one state, beside the readings."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup
from matplotlib.axes import Axes

from cocorosim_ros.diagnosis.findings import FreeRun
from cocorosim_ros.diagnosis.report.figure_style import (
    AFTER,
    BEFORE,
    MEASURED,
    NOMINAL,
    Drawing,
    Margins,
    labelled,
    largest,
    style_axes,
)
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.units.quantity_text import handy_scale
from cocorosim_ros.world.state.state import YAW, X, Y, Z

CHANNEL_UNITS = {"position": "m", "heading": "rad", "depth": "m"}


@dataclass(frozen=True)
class DrawnModel:
    """A model in the pictures: its name among the paths of a free run, its colour and its label."""

    name: str
    colour: str
    label: str


DRAWN_MODELS = (
    DrawnModel("nominal", NOMINAL, "platform file"),
    DrawnModel("recalibrated", BEFORE, "recalibrated"),
    DrawnModel("augmented", AFTER, "with the effects"),
)


def free_runs_figure(runs: Sequence[FreeRun], channels: Iterable[str], *, augmented: bool) -> Markup:
    """Draw a row per stretch: the paths from above, and the error of every channel that the recording shows."""
    shown = [name for name in CHANNEL_UNITS if name in channels]
    if not runs or not shown:
        return Markup("")
    models = DRAWN_MODELS if augmented else DRAWN_MODELS[:2]
    above = "position" in shown
    with Drawing(len(runs), len(shown) + above, 0.75 + 2.6 * len(runs), Margins(top=0.62)) as drawing:
        for row, run in zip(drawing.axes, runs, strict=True):
            if above:
                _from_above(row[0], run, models)
            for axes, channel in zip(row[above:], shown, strict=True):
                _over_time(axes, run, models, channel)
        for axes in drawing.axes[-1]:
            axes.set_xlabel("time [s]")
        if above:
            drawing.axes[-1, 0].set_xlabel("x [m]")
        drawing.legend()
    return drawing.svg


def _from_above(axes: Axes, run: FreeRun, models: Sequence[DrawnModel]) -> None:
    seen = np.isfinite(run.measured[:, X:Z]).all(axis=1)
    axes.plot(*run.measured[seen, X:Z].T, ".", color=MEASURED, markersize=4, alpha=0.6, label="measured")
    for model in models:
        path = getattr(run, model.name)
        axes.plot(path[:, X], path[:, Y], color=model.colour, linewidth=1.3, label=model.label)
        axes.plot(path[-1:, X], path[-1:, Y], "o", color=model.colour, markersize=3.5)
    axes.plot(run.nominal[:1, X], run.nominal[:1, Y], "o", color=MEASURED, markersize=5, fillstyle="none")
    style_axes(axes, ticks=4)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set(ylabel="y [m]", title=f"{run.robot}, from {run.time[0]:.0f} s")


def _over_time(axes: Axes, run: FreeRun, models: Sequence[DrawnModel], channel: str) -> None:
    errors = {name: _error(getattr(run, name), run.measured, channel) for name in (model.name for model in models)}
    scale = handy_scale(max(largest(error) for error in errors.values()), CHANNEL_UNITS[channel])
    for model in models:
        read = np.isfinite(errors[model.name])
        error = errors[model.name][read] * scale.factor
        axes.plot(run.time[read], error, color=model.colour, linewidth=1.3, label=model.label)
    style_axes(axes, ticks=4)
    axes.set_title(labelled(f"error of {channel}", scale))
    axes.margins(x=0.01)


def _error(path: Floats, measured: Floats, channel: str) -> Floats:
    if channel == "position":
        return np.asarray(np.hypot(*(path[:, X:Z] - measured[:, X:Z]).T))
    if channel == "depth":
        return np.asarray(np.abs(path[:, Z] - measured[:, Z]))
    return np.asarray(np.abs(np.mod(path[:, YAW] - measured[:, YAW] + np.pi, 2 * np.pi) - np.pi))
