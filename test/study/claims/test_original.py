"""The original's figures beside made-up runs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from cocorosim_ros.study.claims.claims_page import claims_page
from cocorosim_ros.study.claims.original import DESIGN, FIGURES, Comparison, Figure, comparisons
from cocorosim_ros.study.results.results import Spread

GROUPS = ("Van", "BLT", "BLC", "NA")


def test_a_figure_agrees_when_medians_of_four_of_our_runs_can_be_like_it(made_up: Callable[..., Any]) -> None:
    """40 runs evenly from 0.230 to 0.269 m: medians of four lie about 0.2495, so 0.249 agrees; from 0.5 m it does not.

    The middle 95 % of medians of four out of 40 even steps is narrower than all of them and wider than a fifth.
    """
    for lowest, agrees in ((0.23, True), (0.5, False)):
        results = made_up(DESIGN, GROUPS, {("BLT", "separation_time_median"): lowest})
        (found,) = [
            each
            for each in comparisons(results, "paper")
            if (each.figure.group, each.figure.column) == ("BLT", "separation_time_median")
        ]
        assert found.agrees == agrees
        assert found.ours.median == pytest.approx(lowest + 0.0195)
        assert lowest < found.low < lowest + 0.0155 and lowest + 0.0235 < found.high < lowest + 0.039


def test_a_figure_is_as_exact_as_its_digits() -> None:
    """0.02367 may be anything from 0.023665 to 0.023675, 6 from 5.5 to 6.5, 2.05 from 2.045 to 2.055."""
    for text, half in (("0.02367", 0.000005), ("6", 0.5), ("2.05", 0.005)):
        figure = Figure("BLT", "separation", text)
        assert (figure.value, figure.rounding) == (float(text), pytest.approx(half))
    ours = Spread(40, 5.0, 4.0, 5.2)
    assert Comparison(Figure("Van", "lost", "6"), ours, 0.0, 5.6).agrees
    assert not Comparison(Figure("Van", "lost", "6"), ours, 0.0, 5.4).agrees
    assert not Comparison(Figure("Van", "lost", "6"), ours, 6.6, 9.0).agrees


def test_every_figure_is_a_column(made_up: Callable[..., Any]) -> None:
    """No figure of the original names a group or column that the table does not have; draws are the same each time."""
    results = made_up(DESIGN, GROUPS, {})
    found = list(comparisons(results, "paper"))
    assert [each.figure for each in found] == list(FIGURES)
    assert found == list(comparisons(results, "paper"))


def test_the_page_has_them_only_for_the_released_design(made_up: Callable[..., Any]) -> None:
    """Figures and claims stand under a heading of their own; other designs have none."""
    numbers = {("BLT", "shoals_time_mean"): 1.1605, ("BLT", "polarisation"): 1.0}
    page = claims_page([], {DESIGN: made_up(DESIGN, GROUPS, numbers)})
    part = page.partition(f"## The released reading: `{DESIGN}`")[2]
    assert "| BLT | `shoals_time_mean` | 1.18 | 1.18 | 1.17 to 1.19 |" in part
    assert "| S1 | BLT against Van: polarisation | higher, large | higher, large; A = 1.000" in part
    assert "released reading" not in claims_page([], {"boids": made_up("boids", GROUPS, numbers)})


def test_the_released_reading_in_currents_has_the_claims_on_turbulence(made_up: Callable[..., Any]) -> None:
    """Without figures of the original, which are not known there."""
    results = made_up("turbulence_released", ("T0", "T5e-4", "T5e-3"), {("T5e-3", "polarisation"): -1.0})
    part = claims_page([], {"turbulence_released": results}).partition(
        "## The released reading: `turbulence_released`"
    )[2]
    assert "| T3 | T5e-3 against T0: polarisation | lower, large | lower, large; A = 0.000" in part
    assert "the original |" not in part
