"""What each choice does, as parts of the page: main effects of the screening."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.study.claims.markdown import markdown_table
from cocorosim_ros.study.experiments.factorial import Factorial
from cocorosim_ros.study.figure4.main_effects import MainEffects, main_effects
from cocorosim_ros.study.figure4.published import Box, Number, PublishedFigure
from cocorosim_ros.study.figure4.scores import common_columns, scores
from cocorosim_ros.study.figure4.search import Done
from cocorosim_ros.study.metrics import PAPER_METRICS


def choices_part(factorial: Factorial, figure: PublishedFigure, screening: Done) -> list[str]:
    """The factors, and their main effects on the distance, on every box and on every number."""
    columns = common_columns(factorial, figure, screening.stage, screening.results)
    found = scores(factorial, figure, screening.stage, screening.results, columns)
    responses = np.array([one.responses for one in found]).T  # (shown, settings)
    distances = np.array([one.distances for one in screening.scores]).T
    heads = [_short(each.name) for each in figure.shown]
    used = ", ".join(f"`{column}`" for column in columns.values())
    boxes = [place for place, each in enumerate(figure.shown) if isinstance(each, Box)]
    numbers = [place for place, each in enumerate(figure.shown) if isinstance(each, Number)]
    parts = [
        "### The effect of each choice",
        markdown_table(
            ("choice", "upper level, else lower level", "groups"),
            [(f.name, f.description, ", ".join(f.groups)) for f in factorial.factors],
        ),
        "Main effects on the distance: its mean at the upper level less that at the lower one, so that what is "
        "negative brings the figure nearer. Bold is beyond Lenth's margin for single effects, which stands in the last "
        "line: of effects that are none, one in twenty is beyond it too. An effect on a group that does not know the "
        "choice is chance, or an interaction of three other choices.",
        _table(
            factorial, ["all of it", *(name.replace("_", " ") for name in PAPER_METRICS)], _by_metric(figure, distances)
        ),
        "Main effects on A of each box, in the readings of the metrics that are nearest on average over all settings "
        f"({used}); the figure's side is below each name.",
        _table(factorial, [f"{heads[at]} ({figure.shown[at].told})" for at in boxes], responses[boxes]),
    ]
    if numbers:
        parts += [
            "Main effects on the medians whose numbers are known.",
            _table(factorial, [f"{heads[at]} ({figure.shown[at].told})" for at in numbers], responses[numbers]),
        ]
    return parts


def _by_metric(figure: PublishedFigure, distances: Floats) -> Floats:
    """Mean distances (1 + metrics, settings) of `distances` (shown, settings): of everything, and metric by metric."""
    owners = [each.metric for each in figure.shown]
    each = [distances[[owner == metric for owner in owners]].mean(axis=0) for metric in PAPER_METRICS]
    return np.vstack([distances.mean(axis=0), *each])


def _table(factorial: Factorial, heads: list[str], responses: Floats) -> str:
    found = [main_effects(row, len(factorial.factors)) for row in responses]
    rows = [
        (factor.name, *(_cell(effects, place) for effects in found)) for place, factor in enumerate(factorial.factors)
    ]
    means = ("mean of all settings", *(f"{np.nanmean(row):.3g}" for row in responses))
    margins = ("margin", *(f"{effects.margin:.2g}" for effects in found))
    return markdown_table(("choice", *heads), [*rows, means, margins])


def _cell(effects: MainEffects, place: int) -> str:
    text = f"{effects.effects[place]:+.2g}"
    return f"**{text}**" if effects.beyond(place) else text


def _short(name: str) -> str:
    return name.removesuffix(", median")
