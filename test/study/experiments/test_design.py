"""Designs: what they make, and one clear sentence for each that cannot be meant."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError

Write = Callable[..., str]


def test_cells_are_groups_in_numerics(design_file: Write) -> None:
    """Two groups in two numerics are four cells; changes reach every group of robots; seeds belong to groups."""
    from cocorosim_ros.study.experiments.design import load_design

    design = load_design(design_file(numerics="accurate, paper"))
    cells = [(cell.numerics, cell.group) for cell in design.cells]
    assert cells == [("accurate", "BLT"), ("accurate", "deaf"), ("paper", "BLT"), ("paper", "deaf")]
    assert design.runs == 16
    integrators = [cell.scenario.integrator.name for cell in design.cells]
    assert integrators == ["rk4", "rk4", "semi_implicit_euler", "semi_implicit_euler"]
    assert [cell.scenario.robots[0].platform.name for cell in design.cells] == ["lily"] * 2 + ["lily_paper"] * 2
    weights = [cell.scenario.robots[10].controller.values["alignment_weight"] for cell in design.cells]
    assert weights == [10, 0, 10, 0]
    seeds = [cell.scenario.seed for cell in design.cells]
    assert seeds[:2] == seeds[2:] and seeds[0] != seeds[1]
    assert design.cell_of_row(7) == (design.cells[1], 3)
    assert {cell.scenario.ticks for cell in design.cells} == {40}


def test_another_group_changes_no_seed(design_file: Write) -> None:
    """Rows of a group stay what they are when groups are left out."""
    from cocorosim_ros.study.experiments.design import load_design

    path = design_file()
    (alone,) = load_design(path, groups=["deaf"]).cells
    assert alone == load_design(path).cells[1]


def test_the_digest_tells_designs_apart_and_lets_replicates_grow(design_file: Write) -> None:
    """More replicates are the same design; another duration, seed or numerics is another."""
    from cocorosim_ros.study.experiments.design import load_design

    digest = load_design(design_file()).digest()
    assert load_design(design_file(replicates=400)).digest() == digest
    for other in ({"seed": 6}, {"duration": "21 s"}, {"numerics": "accurate"}):
        assert load_design(design_file(**other)).digest() != digest


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ({"replicates": 0}, "'replicates' has '0'; write a whole number from 1"),
        ({"replicates": 1_000_000_000}, "makes 2,000,000,000 runs, more than the 1,000,000"),
        ({"numerics": ""}, "so that there would be no run"),
        ({"numerics": "papre"}, "no preset of numerics; did you mean 'paper'?"),
        ({"duration": "20"}, "has no unit"),
        ({"seed": -1}, "'seed' has '-1'"),
    ],
)
def test_a_design_that_cannot_be_meant(design_file: Write, words: dict[str, object], told: str) -> None:
    """One sentence that names the file and the place."""
    from cocorosim_ros.study.experiments.design import load_design

    with pytest.raises(CocorosimError) as error:
        load_design(design_file(**words))
    assert told in str(error.value) and "little.yaml" in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("baseline: BLT", "baseline: BTL", "'baseline' has 'BTL'; did you mean 'BLT'?"),
        ("baseline: BLT", "baseline: BLT\nmetrics: [polarization]", "did you mean 'polarisation'?"),
        ("alignment_weight", "alinement_weight", "is no parameter of controller 'boids_blt'"),
        ("change: {swarm", "chnage: {swarm", "is not a known key; did you mean 'change'?"),
    ],
)
def test_a_mistake_in_the_file(design_file: Write, old: str, new: str, told: str) -> None:
    """Unknown group, metric, parameter and key are named, with the nearest that exists."""
    from cocorosim_ros.study.experiments.design import load_design

    path = Path(design_file())
    path.write_text(path.read_text("utf-8").replace(old, new), "utf-8")
    with pytest.raises(CocorosimError, match=r"little\.yaml line") as error:
        load_design(path)
    assert told in str(error.value)


def test_an_unknown_group_on_the_command_line(design_file: Write) -> None:
    """A group that the design does not have is named, with those that it has."""
    from cocorosim_ros.study.experiments.design import load_design

    with pytest.raises(CocorosimError, match="has no group 'Van'; allowed: BLT, deaf"):
        load_design(design_file(), groups=["Van"])


def test_the_smoke_design_ships() -> None:
    """It is found by its name."""
    from cocorosim_ros.study.experiments.design import load_design

    assert load_design("smoke").groups == ("BLT", "deaf")


@pytest.mark.parametrize(
    ("name", "groups"), [("boids", ("Van", "BLT", "BLC", "NA")), ("turbulence", ("T0", "T5e-4", "T5e-3"))]
)
def test_the_designs_of_the_paper_ship(name: str, groups: tuple[str, ...]) -> None:
    """400 runs of each of the paper's groups in both numerics, as long as the paper's."""
    from cocorosim_ros.scenario.scenario import Scenario
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.world.controllers import CONTROLLERS

    if "boids_na" not in CONTROLLERS or "water" not in Scenario.__dataclass_fields__:
        pytest.skip("needs controllers and currents that this tree does not have yet")
    design = load_design(name)
    assert design.groups == groups and design.replicates == 400
    assert {cell.numerics for cell in design.cells} == {"accurate", "paper"}
    ticks, size = {"boids": (25_000, (6, 6, 2)), "turbulence": (5_000, (5, 5, 2))}[name]
    assert {cell.scenario.ticks for cell in design.cells} == {ticks}
    assert {cell.scenario.tank.size for cell in design.cells} == {size}
    assert {len(cell.scenario.robots) for cell in design.cells} == {11}
