"""Claims that sum others up follow from their parts."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pyarrow.compute as pc
import pytest

from cocorosim_ros.study.claims.overall_claims import further, overall_answers, spared
from cocorosim_ros.study.metrics import PAPER_METRICS
from cocorosim_ros.study.results.effect_size import Effect

BOIDS = ("Van", "BLT", "BLC", "NA")
TURBULENCE = ("T0", "T5e-4", "T5e-3")
Make = Callable[..., Any]
EDGE = 0.0095
"""So much higher than 0, 1, ... 39 thousandths are 40 numbers with A = 0.71, which may or may not be large."""
NA_WORSE = {("NA", "polarisation"): -1.0, ("NA", "shoal_speed"): -1.0, ("NA", "lost"): 1.0}


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


def test_open_parts_leave_sums_open(made_up: Make) -> None:
    """A = 0.71 or 0.29 in one metric: whether BLC is a detriment, and whether NA is, nobody can tell."""
    (s19, s20) = overall_answers({"boids": made_up("boids", BOIDS, {("BLC", "lost"): EDGE, **NA_WORSE})})
    assert (s19.verdict, s20.verdict) == ("not decidable", "reproduced")
    assert re.search(r"^open: BLC lost higher, A = 0\.7\d\d \(0\.[56]\d\d to 0\.8\d\d\)$", s19.ours)
    open_ = {**NA_WORSE, ("NA", "lost"): EDGE, ("BLT", "shoals"): 1.0, ("BLC", "lost"): EDGE}
    (s19, s20) = overall_answers({"boids": made_up("boids", BOIDS, open_)})
    assert (s19.verdict, s20.verdict) == ("not reproduced", "not decidable")
    assert re.search(r"^detriment: BLT shoals higher, A = 1\.000 \(.*\); open: BLC lost", s19.ours)
    assert re.search(r"lost higher, A = 0\.7\d\d \(0\.[56]\d\d to 0\.8\d\d\)$", s20.ours)


def test_a_wide_interval_is_no_proof_of_sparing(made_up: Make) -> None:
    """Of three runs, A a little on the good side may still be a large detriment."""
    assert spared("higher", Effect(0.48, 0.20, 0.77)) == "not decidable"
    assert spared("higher", Effect(0.20, 0.10, 0.40)) == "reproduced"  # large, but for the better
    assert spared("lower", Effect(0.20, 0.10, 0.28)) == "not reproduced"
    (s19, _) = overall_answers({"boids": made_up("boids", BOIDS, {("BLC", "shoals"): 0.002})})
    assert re.search(r"no large detriment; nearest to one is BLC shoals higher, A = 0\.5\d\d \(", s19.ours)


@pytest.mark.parametrize(
    ("large", "open_", "verdict", "words"),
    [
        (2, 0, "reproduced", "large in 2 of 6; large: "),
        (1, 1, "reproduced", "large in 1 to 2 of 6; large: "),
        (2, 1, "not decidable", "large in 2 to 3 of 6; large: "),
        (0, 6, "not decidable", "large in 0 to 6 of 6; open: "),
        (3, 3, "not reproduced", "large in 3 to 6 of 6; large: "),
        (0, 0, "reproduced", "large in 0 of 6"),
    ],
)
def test_tolerance_counts_what_intervals_allow(made_up: Make, large: int, open_: int, verdict: str, words: str) -> None:
    """At most two large effects of six: both the least and the largest number that the intervals allow must agree."""
    sizes = [1.0] * large + [EDGE] * open_
    numbers = {("T5e-4", metric): size for metric, size in zip(PAPER_METRICS, sizes, strict=False)}
    found = {
        answer.claim: answer for answer in overall_answers({"turbulence": made_up("turbulence", TURBULENCE, numbers)})
    }
    assert found["T5"].verdict == verdict and found["T5"].ours.startswith(words)
    assert found["T5"].ours.count(" to 0.8") == open_


def test_medians_that_hardly_differ_leave_it_open(made_up: Make) -> None:
    """Weak and strong turbulence are equally far off within the spread of 40 runs, in polarisation alone."""
    numbers = {("T5e-4", "polarisation"): -0.050, ("T5e-3", "polarisation"): -0.051, ("T5e-3", "shoal_speed"): -1.0}
    (t4, _) = overall_answers({"turbulence": made_up("turbulence", TURBULENCE, numbers)})
    assert t4.verdict == "not decidable"
    assert re.search(
        r"polarisation 0\.0195, -0\.0305, -0\.0315, T5e-3 further off by 0\.001 \(-0\.\d+ to 0\.\d+\)", t4.ours
    )


def test_the_gap_of_medians() -> None:
    """|1 - 4| - |1 - 3| = 1, in each of several draws; further in either direction."""
    still, weak, strong = np.array([[1.0]]), np.array([[3.0]]), np.array([[4.0]])
    assert further(still, weak, strong).tolist() == [1.0] and further(still, strong, weak).tolist() == [-1.0]
    assert further(still, weak, 2 - strong).tolist() == [1.0]


def test_too_few_runs_leave_it_open(made_up: Make) -> None:
    """Five runs of each group have no interval of medians; without any run of a group there is nothing to say."""
    results = made_up("turbulence", TURBULENCE, {("T5e-3", "polarisation"): -1.0})
    few = replace(results, table=results.table.filter(pc.less(results.table["replicate"], 5)))
    (t4, _) = overall_answers({"turbulence": few})
    assert t4.verdict == "not decidable" and "unknown below 6 runs" in t4.ours
    none = replace(results, table=results.table.filter(pc.not_equal(results.table["group"], "T5e-4")))
    assert [answer.verdict for answer in overall_answers({"turbulence": none})] == ["no runs", "no runs"]
