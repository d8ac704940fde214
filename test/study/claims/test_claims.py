"""Claims: all of the paper's comparisons are there, and verdicts are those of the thresholds."""

from __future__ import annotations

import pytest

from cocorosim_ros.study.claims.claims import CLAIMS, verdict_of
from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.study.results.effect_size import Effect


def test_every_box_of_figure_4_is_claimed_once() -> None:
    """Three groups against Van and two against T0, in each of the six metrics."""
    boxes = [(claim.group, claim.metric) for claim in CLAIMS if claim.against in ("Van", "T0")]
    groups = ("BLT", "BLC", "NA", "T5e-4", "T5e-3")
    assert sorted(boxes) == sorted((group, metric) for group in groups for metric in PAPER_METRICS)
    assert all(claim.metric in METRICS for claim in CLAIMS)


@pytest.mark.parametrize(
    ("paper", "interval", "verdict"),
    [
        ("higher", (0.80, 0.75, 0.85), "reproduced"),
        ("higher", (0.73, 0.70, 0.76), "not decidable"),
        ("higher", (0.60, 0.55, 0.65), "not reproduced"),
        ("higher", (0.10, 0.05, 0.15), "not reproduced"),
        ("lower", (0.10, 0.05, 0.15), "reproduced"),
        ("lower", (0.30, 0.27, 0.33), "not decidable"),
        ("lower", (0.90, 0.85, 0.95), "not reproduced"),
        ("not large", (0.50, 0.45, 0.55), "reproduced"),
        ("not large", (0.70, 0.67, 0.73), "not decidable"),
        ("not large", (0.80, 0.75, 0.85), "not reproduced"),
        ("not large", (float("nan"),) * 3, "no runs"),
    ],
)
def test_verdicts(paper: str, interval: tuple[float, float, float], verdict: str) -> None:
    """The right side of the threshold, the wrong one, and an interval that contains it."""
    assert verdict_of(paper, Effect(*interval)) == verdict
