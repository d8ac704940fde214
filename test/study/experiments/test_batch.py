"""How many runs are calculated at once."""

from __future__ import annotations


def test_water_in_patches_is_calculated_for_few_runs_at_once() -> None:
    """Forces on 50,000 patches are 1.2 MB a run, of which three stay below 4 MB; still water leaves room for dozens."""
    from cocorosim_ros.study.experiments.batch import runs_that_fit
    from cocorosim_ros.study.experiments.design import load_design

    assert {runs_that_fit(cell.scenario) for cell in load_design("turbulence").cells} == {3}
    assert all(20 < runs_that_fit(cell.scenario) <= 50 for cell in load_design("boids").cells)
