"""How far the runs of one setting are from the figure, in the readings of the metrics that bring them nearest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.study.experiments.factorial import Factorial, Stage
from cocorosim_ros.study.experiments.fraction import Setting
from cocorosim_ros.study.figure4.published import PublishedFigure, Shown, Values
from cocorosim_ros.study.results.results import Results


@dataclass(frozen=True)
class Score:
    """What one setting gives back of the figure."""

    setting: Setting
    columns: Mapping[str, str]
    """The reading of each metric."""
    responses: tuple[float, ...]
    """A of boxes and medians of numbers, in the order of the figure."""
    distances: tuple[float, ...]

    @property
    def total(self) -> float:
        """The mean distance of all that the figure shows."""
        return float(np.mean(self.distances))

    @property
    def given_back(self) -> int:
        """How many boxes are on the figure's side; a number is never at distance 0 but by chance."""
        return sum(distance == 0.0 for distance in self.distances)


def values_of(factorial: Factorial, stage: Stage, results: Results, setting: Setting) -> Values:
    """The runs of a setting, by the groups' plain names."""
    numerics = results.numerics[0]

    def values(group: str, column: str) -> Floats:
        return results.values(numerics, factorial.group_name(stage, group, setting), column)

    return values


def distances_by_column(figure: PublishedFigure, values: Values) -> dict[str, Floats]:
    """For each metric, the summed distance (columns,) of its boxes and numbers in each of its readings."""
    return {
        metric: np.array(
            [
                sum(each.distance(each.response(values, column)) for each in figure.shown if each.metric == metric)
                for column in columns
            ]
        )
        for metric, columns in figure.columns.items()
    }


def nearest_columns(figure: PublishedFigure, summed: Mapping[str, Floats]) -> dict[str, str]:
    """The reading of each metric with the smallest of the `summed` distances; the first of equal ones."""
    return {metric: columns[int(np.argmin(summed[metric]))] for metric, columns in figure.columns.items()}


def score(figure: PublishedFigure, values: Values, setting: Setting, columns: Mapping[str, str] | None = None) -> Score:
    """What a setting gives back, in the given readings of the metrics or in those that are nearest."""
    if columns is None:
        columns = nearest_columns(figure, distances_by_column(figure, values))
    responses = tuple(each.response(values, columns[each.metric]) for each in figure.shown)
    return Score(setting, columns, responses, _distances(figure.shown, responses))


def _distances(shown: Sequence[Shown], responses: Sequence[float]) -> tuple[float, ...]:
    return tuple(each.distance(response) for each, response in zip(shown, responses, strict=True))


def scores(
    factorial: Factorial,
    figure: PublishedFigure,
    stage: Stage,
    results: Results,
    columns: Mapping[str, str] | None = None,
) -> list[Score]:
    """Every setting of a stage."""
    return [
        score(figure, values_of(factorial, stage, results, setting), setting, columns) for setting in stage.settings
    ]


def common_columns(factorial: Factorial, figure: PublishedFigure, stage: Stage, results: Results) -> dict[str, str]:
    """The one reading of each metric that is nearest to the figure on average over a stage's settings."""
    each = [distances_by_column(figure, values_of(factorial, stage, results, one)) for one in stage.settings]
    return nearest_columns(figure, {metric: np.sum([one[metric] for one in each], axis=0) for metric in figure.columns})
