"""The records that describe a metric and the family that computes it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal


@dataclass(frozen=True)
class Metric:
    """What one column of the metrics table means."""

    name: str
    unit: str
    """SI unit, "1" for none."""
    formula: str
    """The definition in words, of the value at one moment."""
    source: str
    summary: Literal["mean", "median", "last"] = "mean"
    """How the values of a run become one number: over time, leaving out moments at which it is undefined."""
    paper: bool = False
    """True for the six metrics of the paper in the reading that this project takes as its default."""
    frame_free: bool = True
    """False where turning the world's axes changes the value (a coordinate-wise median)."""


@dataclass(frozen=True)
class Family:
    """Metrics that are computed together because they share their work."""

    metrics: tuple[Metric, ...]
    measure: Callable[..., Any]
    """Compiled `(swarms, values, column) -> next column`: writes one column per metric, in the order of
    `metrics`.
    """


COUZIN = "Couzin et al. 2002, J. Theor. Biol. 218:1-11"
READ = "Read et al., Profiling Underwater Swarm Robotic Shoaling Performance using Simulation, section 5"
