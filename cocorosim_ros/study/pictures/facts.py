"""What a picture of a run has to know beside the tracks and the statistics."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.foundation.arrays import Floats, Integers


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
