"""A factorial becomes designs: its two ends are the readings that this project has already, to the last bit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.experiments.batch import run_batch
from cocorosim_ros.study.experiments.design import load_design
from cocorosim_ros.study.experiments.factorial import Factorial, Stage, digits, load_factorial

TICKS = 120
RELEASED = {  # the choices in which the released model differs from what is taken for the paper's text
    *("obstacles", "aperture", "lag", "drag", "alone", "halt", "view", "cone", "units", "hearing", "noise", "depth")
}
Write = Callable[[str], str]


def one_setting(factorial: Factorial, upper: set[str]) -> dict[str, Scenario]:
    """The scenarios of all groups under the setting with these factors at their upper levels."""
    setting = tuple(factor.name in upper for factor in factorial.factors)
    return {cell.group: cell.scenario for cell in factorial.design(Stage("test", (setting,), 1)).cells}


def shortly(scenario: Scenario, seed: int) -> Scenario:
    """The scenario for a minute, with that seed."""
    return replace(scenario, seed=seed, duration_ns=TICKS * scenario.tick_ns)


@pytest.mark.parametrize(
    ("design", "numerics", "upper"), [("boids", "paper", set()), ("boids_released", "released", RELEASED)]
)
def test_the_ends_are_the_readings_that_are_there(design: str, numerics: str, upper: set[str]) -> None:
    """The same seed gives the same statistics as the group of the shipped design, of all four variants.

    But for the noise of ranges, which is drawn for each sensor: one that looks down for the floor alone is more here.
    """
    found = one_setting(load_factorial("figure4_boids"), upper)
    cells = [cell for cell in load_design(design, numerics=[numerics]).cells]
    assert list(found) == [cell.group for cell in cells]
    for cell in cells:
        ours, theirs = (
            run_batch(replace(shortly(each, 7), corruption=()), 0, 2) for each in (found[cell.group], cell.scenario)
        )
        np.testing.assert_array_equal(ours.mean, theirs.mean, err_msg=cell.group)


def test_the_lower_end_of_turbulence_is_the_papers() -> None:
    """The groups of turbulence.yaml differ from it by the names and sources of the controller alone."""
    found = one_setting(load_factorial("figure4_turbulence"), set())
    for cell in load_design("turbulence", numerics=["paper"]).cells:
        ours, theirs = found[cell.group], cell.scenario
        assert (ours.water, ours.tank, ours.integrator) == (theirs.water, theirs.tank, theirs.integrator)
        assert ours.swarm[0].platform == replace(theirs.swarm[0].platform, origin=ours.swarm[0].platform.origin)


@pytest.mark.parametrize("name", ["figure4_boids", "figure4_turbulence"])
def test_every_factor_changes_the_groups_that_it_names_and_no_other(name: str) -> None:
    """But for seeds, which are each setting's own."""
    factorial = load_factorial(name)
    base = one_setting(factorial, set())
    for factor in factorial.factors:
        under = one_setting(factorial, {factor.name})
        touched = [group for group in base if shortly(under[group], 1).to_yaml() != shortly(base[group], 1).to_yaml()]
        assert touched == [group for group in factorial.groups if group in factor.groups], factor.name


FILE = """
name: little
description: for tests
figure: boids
scenario: eleven_lilys
numerics: paper
seed: 5
screening: {{runs: 1}}
refining: {refining}
choosing: {{settings: 1, runs: 2}}
confirming: {{runs: 2}}
baseline: {baseline}
groups: {{Van: {{description: as it is}}}}
factors:
  deaf: {{description: "nothing counts, else all", {change}: {{swarm: {{overrides: {{alignment_weight: 0}}}}}}}}
"""


@pytest.fixture
def written(tmp_path: Path) -> Callable[..., Path]:
    """Function of what is to be otherwise: path of a factorial."""

    def write(**words: str) -> Path:
        usual = {"refining": "{runs: 1, rounds: 1}", "baseline": "Van", "change": "change"}
        path = tmp_path / "little.yaml"
        path.write_text(FILE.format(**{**usual, **words}), "utf-8")
        return path

    return write


def test_seeds_differ_between_stages_and_settings(written: Callable[..., Path]) -> None:
    """What is confirmed has seeds that chose nothing; the same stage has the same ones again."""
    factorial = load_factorial(written())
    stages = [Stage("screening", ((False,), (True,)), 1), Stage("confirming", ((True,),), 1)]
    seeds = [[cell.scenario.seed for cell in factorial.design(stage).cells] for stage in stages]
    assert len({*seeds[0], *seeds[1]}) == 3
    assert seeds[0] == [cell.scenario.seed for cell in factorial.design(stages[0]).cells]
    assert factorial.design(stages[0]).groups == ("Van, 0", "Van, 1")
    assert factorial.design(stages[1]).groups == ("Van",)
    assert digits((True, False)) == "10"


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ({"baseline": "BLT"}, "'baseline' has 'BLT'"),
        ({"refining": "{runs: 1}"}, "lacks 'rounds'"),
        ({"change": "changes"}, "'factors.deaf.changes' is not a known key"),
    ],
)
def test_what_is_wrong_is_told(written: Callable[..., Path], words: dict[str, str], told: str) -> None:
    """One sentence with file, line and key."""
    with pytest.raises(CocorosimError, match=told) as raised:
        load_factorial(written(**words))
    assert "little.yaml line" in str(raised.value)
