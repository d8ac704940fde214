"""Pictures of what a model lacks are drawn for every recording, without a word of the library that draws them."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import replace

from cocorosim_ros.diagnosis.findings import Diagnosis
from cocorosim_ros.diagnosis.report.residual_figures import Pair, against_regressor


def test_a_residual_of_nothing_is_drawn_quietly(example: Callable[[str], Diagnosis]) -> None:
    """Where a model has no random force along an axis, nothing is left there; there is a picture, and no warning."""
    diagnosis = example("mismatch")
    residual = diagnosis.residual_before[0]
    located = next(each for each in diagnosis.mismatch if residual.robot in each.robots)
    nothing = replace(residual, force=0.0 * residual.force)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        drawn = against_regressor(Pair(nothing, None), located)
    assert "<svg" in drawn
