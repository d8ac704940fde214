"""What a picture of a run has to know beside the tracks and the statistics."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.mapped_table import columns_of
from cocorosim_ros.study.metrics import COLUMN

BOUNDED = ("polarisation", "angular_momentum")
"""Metrics that lie between 0 and 1."""


@dataclass(frozen=True)
class ScenarioFacts:
    """The facts for titles and walls."""

    name: str
    seed: int | None = None
    """None for recordings of real robots."""
    low_corner: tuple[float, float, float] | None = None
    """Lowest x, y, z of the tank [m; world]; None where it is not known."""
    high_corner: tuple[float, float, float] | None = None
    """Highest x, y, z of the tank [m; world]: its water surface is at the highest z."""
    spheres: tuple[tuple[float, ...], ...] = ()
    """Centre x, y, z and radius of each solid ball [m; world]."""
    boxes: tuple[tuple[float, ...], ...] = ()
    """Lowest x, y, z, then highest x, y, z of each solid box [m; world]."""


@dataclass(frozen=True)
class MetricSeries:
    """All metrics over time."""

    stamp_ns: Integers
    """(t,) moments [ns]."""
    values: Floats
    """(t, len(METRICS)) in the order of the metrics table, NaN where undefined."""

    def column(self, name: str) -> Floats:
        """(t,) a copy of one metric over time; of values in a file nothing else stays in memory."""
        return np.asarray(columns_of(self.values, COLUMN[name], COLUMN[name] + 1)[:, 0])
