"""Choices: each claim is asked of the groups under that choice."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from cocorosim_ros.study.claims.choices import choices_of

GROUPS = ("Van", "BLT", "BLC", "NA", "BLC, units", "BLT, view", "Van, view")


def test_who_is_compared_with_whom(made_up: Callable[..., Any]) -> None:
    """BLC under `units` with Van as it is; BLT under `view` with Van under it; others are left out."""
    numbers = {("BLC", "polarisation"): -1.0, ("BLC, units", "polarisation"): 1.0, ("Van, view", "polarisation"): -2.0}
    (table,) = choices_of(made_up("boids_choices", GROUPS, numbers))
    assert table.choices == ("as in the paper's design", "units", "view")
    rows = {(claim.name, claim.metric): findings for claim, findings in table.rows}
    before, units, view = rows["S2", "polarisation"]
    assert (before.effect.value, before.verdict) == (0.0, "not reproduced")
    assert (units.effect.value, units.verdict, units.claim.against) == (1.0, "reproduced", "Van")
    assert view is None  # nor does BLC know `view`, though Van does
    assert rows["S1", "polarisation"][1] is None  # BLT does not know `units` here
    view = rows["S1", "polarisation"][2]
    assert view.effect.value == 1.0 and (view.claim.group, view.claim.against) == ("BLT, view", "Van, view")
    assert rows["S21", "lost"][1].claim.against == "BLT"


def test_other_designs_have_none(made_up: Callable[..., Any]) -> None:
    """Only a name that ends in `_choices` asks for it."""
    assert choices_of(made_up("boids", GROUPS, {})) == []
