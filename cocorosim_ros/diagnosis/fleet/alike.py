"""Groups of recordings that look alike: the same confirmed effects, numbers no further apart than chance takes them.

The distance of two recordings of robots is the largest, over the numbers that both have, of

    |difference| / sqrt(its variance by both intervals + twice that by the usual scatter) / limit

The usual scatter of a number is that between recordings of one robot beyond their intervals and its drift, root mean
square over robots. The limit is the range of n values of one normal distribution, n the number of recordings, that is
passed with a probability of LIKENESS.apart over all numbers together (Tukey's studentized range, with as many degrees
of freedom as the scatter was taken from). Groups come from complete linkage, cut at 1: any two recordings of a group
are alike.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial.distance import squareform
from scipy.stats import studentized_range

from cocorosim_ros.diagnosis.criteria.fleet import LIKENESS
from cocorosim_ros.diagnosis.fleet.drift import Drift
from cocorosim_ros.diagnosis.fleet.rows import Row
from cocorosim_ros.diagnosis.fleet.series import Series
from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class Group:
    """Rows that are alike, with what they share."""

    rows: tuple[Row, ...]
    effects: tuple[str, ...]  # confirmed in all of them

    @property
    def robots(self) -> tuple[str, ...]:
        """Names of the robots in it."""
        return tuple(sorted({row.robot for row in self.rows}))


@dataclass(frozen=True)
class Groups:
    """Groups, the largest first; limit: difference [standard deviations] up to which recordings are alike.

    scatter: usual scatter of each number between recordings of a robot, where numbers are relative a share.
    not_compared: rows without any number, or all where there are too many for a matrix of pairs.
    """

    groups: tuple[Group, ...]
    limit: float
    scatter: dict[str, float]
    not_compared: int


def alike(rows: Sequence[Row], every: Sequence[Series], drifts: Sequence[Drift]) -> Groups:
    """Put rows into groups; series and drifts are those of the same rows."""
    parameters = sorted({each.parameter for each in every})
    scatter = {name: _usual_scatter(name, drifts) for name in parameters}
    places = {(row.recording, row.robot): place for place, row in enumerate(rows)}
    value, spread = np.full((2, len(rows), len(parameters)), math.nan)
    for each in every:
        column = parameters.index(each.parameter)
        mine = [places[name, each.robot] for name in each.recordings]
        value[mine, column], spread[mine, column] = each.value, each.spread
    told = [place for place in range(len(rows)) if np.isfinite(value[place]).any()]
    limit = _limit(len(told), len(parameters), _freedom(drifts))
    if not told or len(told) > LIKENESS.most_compared:
        return Groups((), limit, scatter, len(rows))
    chosen = [rows[place] for place in told]
    variance = np.square(spread[told]) + np.square(list(scatter.values()))
    distance = _apart(value[told], variance, [_confirmed(row) for row in chosen], limit)
    numbers = _clusters(distance)
    groups = [
        tuple(row for row, mine in zip(chosen, numbers, strict=True) if mine == number) for number in set(numbers)
    ]
    found = [Group(mine, _confirmed(mine[0])) for mine in groups]
    ordered = sorted(found, key=lambda each: (-len(each.rows), each.rows[0].recording, each.rows[0].robot))
    return Groups(tuple(ordered), limit, scatter, len(rows) - len(told))


def _confirmed(row: Row) -> tuple[str, ...]:
    return tuple(sorted({each.id for each in row.effects if each.tier == "confirmed"}))


def _usual_scatter(parameter: str, drifts: Sequence[Drift]) -> float:
    """Root mean square over robots; none where no robot has recordings enough."""
    mine = [each.scatter**2 for each in drifts if each.series.parameter == parameter]
    return math.sqrt(float(np.mean(mine))) if mine else 0.0


def _freedom(drifts: Sequence[Drift]) -> float:
    """Degrees of freedom of the scatter of the number that has fewest."""
    each: dict[str, int] = {}
    for drift in drifts:
        each[drift.series.parameter] = each.get(drift.series.parameter, 0) + drift.line.freedom
    return float(min(each.values(), default=0)) or math.inf


def _limit(rows: int, parameters: int, freedom: float) -> float:
    if rows < 2 or not parameters:
        return math.inf
    # The range of n values, each with the deviation s; a difference of two of them has sqrt(2) s.
    return float(studentized_range.ppf(1.0 - LIKENESS.apart / parameters, rows, freedom)) / math.sqrt(2.0)


def _apart(value: Floats, variance: Floats, effects: Sequence[tuple[str, ...]], limit: float) -> Floats:
    """(n, n) distances of n rows, from values and variances (n, parameters)."""
    kinds = {names: number for number, names in enumerate(sorted(set(effects)))}
    kind = np.array([kinds[names] for names in effects])
    distance = np.where(kind[:, None] == kind, 0.0, LIKENESS.far)
    for mine, its in zip(value.T, variance.T, strict=True):
        z = np.abs(mine[:, None] - mine) / np.sqrt(its[:, None] + its) / limit
        distance = np.fmax(distance, z)  # a number that one of both lacks says nothing
    np.fill_diagonal(distance, 0.0)
    return distance


def _clusters(distance: Floats) -> list[int]:
    if len(distance) < 2:
        return [1] * len(distance)
    numbers: list[int] = fcluster(linkage(squareform(distance, checks=False), "complete"), 1.0, "distance").tolist()
    return numbers
