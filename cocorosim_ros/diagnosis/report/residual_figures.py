"""Pictures of the missing force: over time, against regressors, and by heading, speed, depth and command."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup
from matplotlib.axes import Axes

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import Diagnosis, Located, ResidualForce
from cocorosim_ros.diagnosis.report.binned_means import binned_means
from cocorosim_ros.diagnosis.report.figure_style import (
    AFTER,
    BEFORE,
    INK,
    QUIET,
    Drawing,
    Margins,
    labelled,
    largest,
    style_axes,
    thinned,
)
from cocorosim_ros.diagnosis.report.regressors import (
    OF_BODY,
    Along,
    Missing,
    SaidLaw,
    followed_by,
    regressor_of,
    residual_of,
    said_law,
)
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.units.quantity_text import Scale, handy_scale
from cocorosim_ros.world.terms.equations import EQUATION
from cocorosim_ros.world.terms.regressors import REGRESSOR

_CONDITIONS = ("yaw", "speed", "z", "thrust", "yaw_command", "pump")


@dataclass(frozen=True)
class Shown:
    """A residual force in a picture: its colour and its label."""

    residual: ResidualForce
    colour: str
    label: str


@dataclass(frozen=True)
class Points:
    """Values to draw, rightwards and upwards."""

    along: Along
    missing: Missing


@dataclass(frozen=True)
class Pair:
    """The residual of one robot, of the recalibrated model and of the model with the effects (None: no effects)."""

    before: ResidualForce
    after: ResidualForce | None

    @property
    def both(self) -> tuple[Shown, ...]:
        """Both residuals as they are drawn; one without effects."""
        first = Shown(self.before, BEFORE, "recalibrated model")
        if self.after is None:
            return (first,)
        return first, Shown(self.after, AFTER, "with the effects")


def pairs_of(diagnosis: Diagnosis) -> list[Pair]:
    """The residuals before and after, robot by robot; those with a finding come first."""
    after = list(diagnosis.residual_after)
    with_findings = {robot for located in diagnosis.mismatch for robot in located.robots}
    with_findings |= {robot for effect in diagnosis.effects for robot in effect.robots}
    pairs = []
    for before in diagnosis.residual_before:
        match = next((each for each in after if each.robot == before.robot), None)
        after = [each for each in after if each is not match]
        pairs.append(Pair(before, match))
    return sorted(pairs, key=lambda pair: pair.before.robot not in with_findings)


def over_time(pair: Pair) -> Markup:
    """A panel per degree of freedom that the recording shows: the residual with its 95 % band."""
    shown = [name for column, name in enumerate(OF_BODY) if largest(pair.before.force[:, column]) > 0.0]
    if not shown:
        return Markup("")
    with Drawing(len(shown), 1, 0.86 + 1.3 * len(shown), Margins(down=0.22)) as drawing:
        for axes, name in zip(drawing.axes[:, 0], shown, strict=True):
            _panel_over_time(axes, pair, name)
        for axes in drawing.axes[:-1, 0]:
            axes.tick_params(labelbottom=False)
        drawing.axes[-1, 0].set_xlabel("time [s]")
        drawing.legend()
    return drawing.svg


def _panel_over_time(axes: Axes, pair: Pair, equation: str) -> None:
    column, unit = OF_BODY.index(equation), EQUATION[equation].unit
    scale = handy_scale(largest(thinned(pair.before.force[:, column])), unit)
    for shown in pair.both:
        force, deviation = shown.residual.force[:, column], shown.residual.spread[:, column]
        time, middle, spread = (
            thinned(part) for part in (shown.residual.time, force * scale.factor, deviation * scale.factor)
        )
        low, high = middle - 1.96 * spread, middle + 1.96 * spread
        axes.fill_between(time, low, high, color=shown.colour, alpha=0.22, linewidth=0)
        axes.plot(time, middle, color=shown.colour, linewidth=1.0, label=shown.label)
    axes.axhline(0.0, color=INK, linewidth=0.7)
    axes.set_ylabel(labelled(equation, scale, between="\n"))
    style_axes(axes)
    axes.margins(x=0.01)


def against_regressor(pair: Pair, located: Located) -> Markup:
    """The residual of an equation over what it is proportional to; empty where `why_not_drawn` says why."""
    if why_not_drawn(pair, located):
        return Markup("")
    with Drawing(1, len(pair.both), 3.2, Margins(across=0.85)) as drawing:
        top = 0.0
        for axes, shown in zip(drawing.axes[0], pair.both, strict=True):
            points = _points(shown.residual, located)
            if points is not None:
                top = max(top, _scatter(axes, points, said_law(located), shown.colour))
            axes.set_title(shown.label)
        for axes in drawing.axes[0]:
            axes.set_ylim(-(top or 1.0), top or 1.0)  # nothing is left where a model has no random force
    return drawing.svg


def why_not_drawn(pair: Pair, located: Located) -> str:
    """A sentence where there is no picture of this residual over what it is proportional to; empty if there is one."""
    if _points(pair.before, located) is not None:
        return ""
    said = said_law(located)
    equation, regressor = said.equation.replace("_", " "), said.regressor.replace("_", " ")
    subject = f"There is no picture of {equation} against {regressor}"
    if residual_of(said.equation, pair.before) is None:
        return f"{subject}: it is of readings, which are drawn where an effect of them was found."
    if followed_by(located, pair.before) is None:
        return f"{subject}: that is no product of what a recording shows."
    return f"{subject}: in this recording it has no value."


def _points(residual: ResidualForce, located: Located) -> Points | None:
    """Values to draw rightwards and upwards, where both are finite; None if there are none, or no such picture."""
    missing, along = residual_of(said_law(located).equation, residual), followed_by(located, residual)
    if missing is None or along is None:
        return None
    good = np.isfinite(missing.values) & np.isfinite(along.values)
    if not good.any():
        return None
    return Points(
        Along(along.values[good], along.unit), Missing(missing.values[good], missing.spread[good], missing.unit)
    )


def _scatter(axes: Axes, points: Points, law: SaidLaw, colour: str) -> float:
    """Draws a cloud, its means in classes, and gives the height that both panels need."""
    along, missing = points.along, points.missing
    x_scale = _scale_along(law.regressor, along.values, along.unit)
    y_scale = handy_scale(_size(missing.values), missing.unit)
    x, y = along.values * x_scale.factor, missing.values * y_scale.factor
    every = max(1, len(x) // REPORT.most_dots)
    axes.scatter(x[::every], y[::every], s=5, color=colour, alpha=0.3, linewidths=0, rasterized=False)
    _draw_means(axes, x, y, INK)
    axes.axhline(0.0, color=QUIET, linewidth=0.8)
    name = "time" if law.regressor == "1" else law.regressor.replace("*", "\u00b7")
    axes.set_xlabel(labelled(name, x_scale))
    axes.set_ylabel(labelled(f"{law.equation.replace('_', ' ')}, missing", y_scale))
    style_axes(axes)
    return 1.15 * _size(missing.values) * y_scale.factor


def by_conditions(pair: Pair, equations: Sequence[str]) -> Markup:
    """Draw the mean residual of some equations by heading, speed, height and command, as far as these vary."""
    columns = _varying(pair)
    rows = [name for name in dict.fromkeys(equations) if residual_of(name, pair.before) is not None]
    if not rows or not columns:
        return Markup("")
    with Drawing(len(rows), len(columns), 0.4 + 2.15 * len(rows), Margins(bottom=0.66, down=0.72)) as drawing:
        for row, equation in zip(drawing.axes, rows, strict=True):
            for axes, condition in zip(row, columns, strict=True):
                _condition_panel(axes, pair, equation, condition)
            row[0].set_ylabel(_equation_label(pair, equation))
            low, high = min(axes.get_ylim()[0] for axes in row), max(axes.get_ylim()[1] for axes in row)
            for axes in row:
                axes.set_ylim(low, high)
        drawing.legend()
    return drawing.svg


def condition_words(pair: Pair) -> str:
    """Words for the conditions by which means are drawn, such as 'heading, speed and thrust command'; '' if none."""
    *others, last = [REGRESSOR[name].label or name for name in _varying(pair)] or [""]
    return f"{', '.join(others)} and {last}" if others else last


def _varying(pair: Pair) -> list[str]:
    return [name for name in _CONDITIONS if _varies(pair.before, name)]


def _condition_panel(axes: Axes, pair: Pair, equation: str, condition: str) -> None:
    first = residual_of(equation, pair.before)
    factor = handy_scale(_size(first.values), first.unit).factor if first else 1.0
    scale = None
    for shown in pair.both:
        missing, along = residual_of(equation, shown.residual), regressor_of(condition, shown.residual)
        if missing is not None:
            values = np.mod(along.values + np.pi, 2 * np.pi) - np.pi if condition == "yaw" else along.values
            scale = scale or _scale_along(condition, values, along.unit)
            _draw_means(axes, values * scale.factor, missing.values * factor, shown.colour, shown.label)
    axes.axhline(0.0, color=QUIET, linewidth=0.8)
    if scale is not None:
        axes.set_xlabel(labelled(REGRESSOR[condition].label or condition, scale, between="\n"))
    style_axes(axes, ticks=3)


def _equation_label(pair: Pair, equation: str) -> str:
    missing = residual_of(equation, pair.before)
    name = equation.replace("_", " ")
    return labelled(name, handy_scale(_size(missing.values), missing.unit), between="\n") if missing else name


def _draw_means(axes: Axes, x: Floats, y: Floats, colour: str, label: str | None = None) -> None:
    means = binned_means(x, y)
    bars = np.nan_to_num(means.half_width, nan=0.0)
    axes.plot(means.centre, means.mean, "o-", color=colour, markersize=3.5, linewidth=1.0, label=label)
    axes.vlines(means.centre, means.mean - bars, means.mean + bars, color=colour, linewidth=1.0)


def _scale_along(regressor: str, values: Floats, unit: str) -> Scale:
    """The unit along an axis: metres for places on every picture, a handy unit for all else."""
    return Scale(1.0, unit) if regressor in ("x", "y", "z") else handy_scale(largest(values), unit)


def _varies(residual: ResidualForce, condition: str) -> bool:
    return float(np.ptp(regressor_of(condition, residual).values)) > 0.0


def _size(values: Floats) -> float:
    """Magnitude below which 99.5 % of the values stay."""
    finite = np.abs(values[np.isfinite(values)])
    return float(np.quantile(finite, 0.995)) if finite.size else 0.0
