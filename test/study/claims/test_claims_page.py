"""The page of the claims and the table of all numbers."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from typing import Any

import numpy as np

from cocorosim_ros.study.claims.answers import Answer
from cocorosim_ros.study.claims.claims_page import claims_page
from cocorosim_ros.study.experiments.rows import STATISTICS
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.results.summary_table import summary_csv

GROUPS = ("Van", "BLT", "BLC", "NA")


def test_one_row_a_claim(made_up: Callable[..., Any]) -> None:
    """Claims stand in the paper's order, both numerics in one row; S10 does not come before S9."""
    answers = [
        Answer("S10", "x", "lower", "paper", "as said", "reproduced"),
        Answer("S9", "y", "lower", "paper", "otherwise", "not reproduced"),
        Answer("S9", "y", "lower", "accurate", "perhaps", "not decidable"),
        Answer("C1", "z", "1.78", "both", "1.778", "reproduced"),
    ]
    page = claims_page(answers, {"boids": made_up("boids", GROUPS, {("BLT", "polarisation_time_mean"): 1.0})})
    rows = [line for line in page.splitlines() if line.startswith(("| C", "| S9 ", "| S10 | x"))]
    assert rows[0] == "| C1 | z | 1.78 | 1.778 | yes | 1.778 | yes |"
    assert rows[1] == "| S9 | y | lower | otherwise | **no** | perhaps | open |"
    assert rows[2] == "| S10 | x | lower | as said | yes |  |  |"
    assert "| S1 | BLT against Van: polarisation | 1 of 8 |  |" in page
    assert "2 reproduced, 1 not reproduced" in page


def test_all_numbers(made_up: Callable[..., Any]) -> None:
    """One line for each group, metric and statistic; quartiles of 0 ... 39 thousandths above 2 are 2.00975 ..."""
    results = made_up("boids", GROUPS, {("NA", "shoals"): 2.0})
    lines = list(csv.DictReader(io.StringIO(summary_csv([results]))))
    assert len(lines) == len(GROUPS) * len(METRICS) * len(STATISTICS)
    (line,) = [
        row for row in lines if (row["group"], row["metric"], row["over time"]) == ("NA", "shoals", "own definition")
    ]
    shown = [float(line[name]) for name in ("lower quartile", "median", "upper quartile", "A against baseline")]
    np.testing.assert_allclose(shown, [2.00975, 2.0195, 2.02925, 1.0])
    assert line["runs"] == "40"
    assert all(row["A against baseline"] == "" for row in lines if row["group"] == "Van")
