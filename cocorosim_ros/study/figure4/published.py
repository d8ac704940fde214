"""What figure 4 shows: boxes that are large effects in a direction, or none, and a few numbers.

How far a result is from a box: by how much A lies on the wrong side of its threshold, in units of the way from no
effect to a large one (0.5 to 0.71): 0 where the claim holds, 1 where a large effect is claimed and none is there. How
far it is from a number: the logarithm of their ratio to base 2, 1 for a factor of two, at most 3. Both units are
chosen: the width of the figure's boxes, which would be a better one, is not known.
Source: Read et al. 2013, figure 4; config/published/figure4.yaml says how the numbers were come by.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.config_files import shipped_file
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.yaml_file import load_yaml
from cocorosim_ros.study.claims.claims import CLAIMS, HIGHER, LOWER, Claim
from cocorosim_ros.study.claims.readings import columns_of
from cocorosim_ros.study.metrics import PAPER_METRICS
from cocorosim_ros.study.results.effect_size import LARGE, vargha_delaney

Values = Callable[[str, str], Floats]
"""The runs' numbers of a group in a column of the table of results; NaN where undefined."""
MOST_OCTAVES = 3.0


@dataclass(frozen=True)
class Box:
    """One box of the figure, by its colour and side."""

    claim: Claim

    @property
    def name(self) -> str:
        """Which it is, in words."""
        return f"{self.claim.group} {self.claim.metric.replace('_', ' ')}"

    @property
    def metric(self) -> str:
        """That of the paper."""
        return self.claim.metric

    @property
    def told(self) -> str:
        """What the figure shows, in words."""
        return self.claim.paper

    def response(self, values: Values, column: str) -> float:
        """A against the group that it is compared with; NaN without runs."""
        return vargha_delaney(_known(values(self.claim.group, column)), _known(values(self.claim.against, column)))

    def distance(self, a: float) -> float:
        """How far A is from what the figure shows."""
        if math.isnan(a):
            return MOST_OCTAVES
        short = {HIGHER: LARGE - a, LOWER: a - (1.0 - LARGE)}.get(self.claim.paper, max(a, 1.0 - a) - LARGE)
        return max(0.0, round(short, 12)) / (LARGE - 0.5)


@dataclass(frozen=True)
class Number:
    """The median of one box of the figure, as it was read off its axis."""

    group: str
    metric: str
    value: float
    digit: float
    """One unit of its last digit."""

    @property
    def name(self) -> str:
        """Which it is, in words."""
        return f"{self.group} {self.metric.replace('_', ' ')}, median"

    @property
    def told(self) -> str:
        """The number in words."""
        return f"{self.value:g}"

    def response(self, values: Values, column: str) -> float:
        """The median of the group's runs; NaN without any."""
        known = _known(values(self.group, column))
        return float(np.median(known)) if known.size else math.nan

    def distance(self, median: float) -> float:
        """How many factors of two the median is away, at most three."""
        if not median > 0.0:  # NaN too
            return MOST_OCTAVES
        return min(MOST_OCTAVES, abs(math.log2(median / self.value)))


Shown = Box | Number


@dataclass(frozen=True)
class PublishedFigure:
    """One half of figure 4."""

    name: str
    shown: tuple[Shown, ...]
    columns: dict[str, tuple[str, ...]]
    """The readings of each metric that can be meant."""

    @property
    def boxes(self) -> int:
        """How many boxes there are."""
        return sum(isinstance(each, Box) for each in self.shown)


def published_figure(name: str) -> PublishedFigure:
    """The half of figure 4 that the design of that name is about."""
    boxes = tuple(Box(claim) for claim in CLAIMS if claim.design == name and claim.name != "S21")
    columns = {metric: tuple(columns_of(metric)) for metric in PAPER_METRICS}
    numbers = []
    for entry in load_yaml(shipped_file("published/figure4.yaml")).section(("numbers",))["numbers"].items():
        section = entry.section(("figure", "group", "metric", "value", "digit"), ("columns",))
        if section["figure"].text() == name:
            metric = section["metric"].choice(PAPER_METRICS)
            numbers.append(Number(section["group"].text(), metric, _float(section["value"]), _float(section["digit"])))
            if "columns" in section:
                columns[metric] = tuple(part.choice(columns[metric]) for part in section["columns"].items())
    return PublishedFigure(name, (*boxes, *numbers), columns)


def _float(entry: Entry) -> float:
    return float(entry.value)


def _known(values: Floats) -> Floats:
    return values[~np.isnan(values)]
