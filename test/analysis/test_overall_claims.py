"""Claims that sum others up follow from their parts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from cocorosim_ros.analysis.overall_claims import overall_answers

BOIDS = ("Van", "BLT", "BLC", "NA")
TURBULENCE = ("T0", "T5e-4", "T5e-3")
Make = Callable[..., Any]


def verdicts(results: Any) -> dict[str, str]:
    """Claim to verdict."""
    return {answer.claim: answer.verdict for answer in overall_answers({results.about["design"]: results})}


@pytest.mark.parametrize(
    ("numbers", "s19", "s20"),
    [
        ({}, "reproduced", "not reproduced"),
        ({("BLT", "polarisation"): 1.0}, "reproduced", "not reproduced"),  # better is no detriment
        ({("BLC", "polarisation"): -1.0}, "not reproduced", "not reproduced"),
        ({("BLC", "lost"): 1.0}, "not reproduced", "not reproduced"),
        ({("BLC", "separation"): 1.0}, "reproduced", "not reproduced"),  # neither better nor worse
        ({("NA", "polarisation"): -1.0, ("NA", "shoal_speed"): -1.0, ("NA", "lost"): 1.0}, "reproduced", "reproduced"),
        (
            {("NA", "polarisation"): -1.0, ("NA", "shoal_speed"): 1.0, ("NA", "lost"): 1.0},
            "reproduced",
            "not reproduced",
        ),
    ],
)
def test_detriment(made_up: Make, numbers: dict[tuple[str, str], float], s19: str, s20: str) -> None:
    """S19 fails with one large effect for the worse in BLT or BLC; S20 needs three in NA."""
    assert verdicts(made_up("boids", BOIDS, numbers)) == {"S19": s19, "S20": s20}


def test_weak_turbulence_is_minor_and_tolerated(made_up: Make) -> None:
    """Medians of polarisation 0, -0.1, -1 and of speed 0, -0.1, -1; two metrics of six changed."""
    numbers = {(group, metric): size for group, size in (("T5e-4", -0.1), ("T5e-3", -1.0)) for metric in
               ("polarisation", "shoal_speed")}  # fmt: skip
    assert verdicts(made_up("turbulence", TURBULENCE, numbers)) == {"T4": "reproduced", "T5": "reproduced"}


def test_weak_turbulence_as_bad_as_strong(made_up: Make) -> None:
    """Three metrics of six changed, speed more than by strong turbulence."""
    numbers = {("T5e-4", "polarisation"): -0.1, ("T5e-3", "polarisation"): -1.0, ("T5e-4", "lost"): 1.0}
    numbers |= {("T5e-4", "shoal_speed"): -1.0, ("T5e-3", "shoal_speed"): -0.5}
    assert verdicts(made_up("turbulence", TURBULENCE, numbers)) == {"T4": "not reproduced", "T5": "not reproduced"}
