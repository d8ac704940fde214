"""Readings of a metric: all named variants, each over time in the ways that mean something."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from cocorosim_ros.study.claims.readings import columns_of, readings_of
from cocorosim_ros.study.experiments.rows import SCHEMA


def test_columns() -> None:
    """Time mean and median of the four variants of polarisation; the three counts of lost robots once each."""
    assert len(columns_of("polarisation")) == 8 and len(columns_of("angular_momentum")) == 32
    assert columns_of("lost") == ["lost", "lost_blss", "lost_blss_no_back"]
    assert all(name in SCHEMA.names for metric in ("polarisation", "lost", "shoals") for name in columns_of(metric))


def test_how_many_agree(made_up: Callable[..., Any]) -> None:
    """Only the time mean over all robots is higher: one of eight."""
    results = made_up("boids", ("Van", "BLT", "BLC", "NA"), {("BLT", "polarisation_time_mean"): 1.0})
    found = {(one.claim.name, one.claim.metric): one for one in readings_of({"boids": results})}
    assert found["S1", "polarisation"].reproduced == ("polarisation_time_mean",)
    assert len(found["S1", "polarisation"].asked) == 8
