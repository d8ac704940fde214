"""A picture of the evidence for each effect of the catalogue, and for laws outside it."""

from __future__ import annotations

import math
from typing import NamedTuple

from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect
from cocorosim_ros.diagnosis.report.figure_style import AFTER, BEFORE, INK, QUIET, Drawing, Margins, style_axes
from cocorosim_ros.foundation.units.quantity_text import plain_number
from cocorosim_ros.world.laws.law import is_law, subject_and_product


class Bar(NamedTuple):
    """Evidence [nats] of an effect or law. beside: it is what the found model would lose, for it was not screened."""

    id: str
    nats: float
    beside: bool = False


def bars_of(diagnosis: Diagnosis) -> list[Bar]:
    """List what is drawn, the strongest first: entries and laws that explain anything by themselves.

    Of the laws outside the catalogue, those that are told of as found, without a name or as rivals, and the best of the
    others.
    """
    told = {each.id for each in _told(diagnosis)} | _rivals(diagnosis)
    laws = sorted(diagnosis.screened_laws, key=lambda each: -_finite(each.nats))
    others = [each for each in laws if each.id not in told][: REPORT.most_laws]
    screened = [*diagnosis.screened, *(each for each in laws if each.id in told), *others]
    bars = [Bar(each.id, _finite(each.nats)) for each in screened]
    known = {bar.id for bar in bars}
    late = [each for each in _told(diagnosis) if is_law(each.id) and each.id not in known]
    bars += [Bar(each.id, _finite(each.nats), beside=True) for each in late]
    return sorted((bar for bar in bars if bar.nats >= REPORT.least_nats), key=lambda bar: -bar.nats)


def bars_of_nats(diagnosis: Diagnosis) -> Markup:
    """Draw a bar for each of `bars_of`, the strongest on top; colours: found, without a name, rival, other."""
    shown = bars_of(diagnosis)
    if not shown:
        return Markup("")
    with_laws = any(is_law(bar.id) for bar in shown)
    margins = Margins(left=2.7 if with_laws else 1.75, top=0.1)
    with Drawing(1, 1, 0.7 + 0.21 * len(shown), margins) as drawing:
        axes = drawing.axes[0, 0]
        for place, bar in enumerate(shown):
            _draw(axes, place, bar, diagnosis)
        style_axes(axes)
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(LogLocator())
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,g}"))
        axes.set_xlim(REPORT.least_nats, 4 * max(REPORT.three_digits, shown[0].nats))
        axes.set_yticks(range(len(shown)), [_label(bar.id) for bar in shown])
        axes.set_ylim(len(shown) - 0.4, -0.6)
        axes.grid(visible=False, axis="y")
        if math.isfinite(diagnosis.needed_nats):
            axes.axvline(diagnosis.needed_nats, color=INK, linewidth=0.9, linestyle="--")
        axes.set_xlabel("evidence [nats], by this effect alone over the recalibrated model")
    return drawing.svg


def without_bars(diagnosis: Diagnosis) -> list[str]:
    """The screened effects of the catalogue that explain too little for a bar."""
    return [each.id for each in diagnosis.screened if _finite(each.nats) < REPORT.least_nats]


def bars_words(diagnosis: Diagnosis) -> str:
    """Caption of the picture: what its bars, colours and lines mean, of those that it has."""
    bars = bars_of(diagnosis)
    drawn = {bar.id for bar in bars}
    said = ["Every effect of the catalogue by what it alone would explain beyond the recalibrated model."]
    if any(map(is_law, drawn)):
        said.append("Law: what a force or an error outside the catalogue is in proportion to.")
    if diagnosis.screened_laws:
        said.append(f"Of {len(diagnosis.screened_laws)} laws tried, those told of on this page and the best others.")
    if drawn & {each.id for each in diagnosis.effects}:
        said.append("Orange: found.")
    if drawn & {each.found.id for each in diagnosis.passed_over}:
        said.append("Orange outline: without a name.")
    if drawn & _rivals(diagnosis):
        said.append("Blue: rivals of what was found.")
    if any(bar.beside for bar in bars):
        said.append("Hatched: looked for beside other effects alone; what the found model would lose without it.")
    if math.isfinite(diagnosis.needed_nats):
        said.append("Dashed line: evidence from which an effect is reported.")
    said.append(
        "Effects are found one after the other: what stands high here and is not reported was explained by what was "
        "found before it, or makes free runs no better."
    )
    return " ".join(said)


def _told(diagnosis: Diagnosis) -> list[FoundEffect]:
    return [*diagnosis.effects, *(each.found for each in diagnosis.passed_over)]


def _rivals(diagnosis: Diagnosis) -> set[str]:
    return {rival.id for each in diagnosis.effects for rival in each.ambiguous_with}


def _draw(axes: Axes, place: int, bar: Bar, diagnosis: Diagnosis) -> None:
    found = bar.id in {each.id for each in diagnosis.effects}
    nameless = not found and bar.id in {each.found.id for each in diagnosis.passed_over}
    colour = BEFORE if found or nameless else AFTER if bar.id in _rivals(diagnosis) else QUIET
    axes.barh(
        place, bar.nats - REPORT.least_nats, left=REPORT.least_nats, height=0.7, color="none" if nameless else colour,
        edgecolor=INK if bar.beside and not nameless else colour, linewidth=1.2 if nameless else 0.0,
        hatch="//" if bar.beside else "",
    )  # fmt: skip
    words = plain_number(bar.nats, 3 if bar.nats >= REPORT.three_digits else 2)
    axes.annotate(words, (bar.nats, place), (4, 0), textcoords="offset points", va="center", fontsize=8)


def _label(identifier: str) -> str:
    if not is_law(identifier):
        return identifier.replace("_", " ")
    subject, product = subject_and_product(identifier)
    return f"law: {subject} \u223c {product.text}".replace("_", " ").replace("*", "\u00b7")


def _finite(nats: float) -> float:
    return nats if math.isfinite(nats) else 0.0
