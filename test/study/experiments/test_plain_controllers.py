"""Plain Python controllers in experiments: rows are those of single runs, and belong to one version of the file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pyarrow as pa
import pytest

from cocorosim_ros.foundation.errors import CocorosimError

WANDER = """
class Wander:
    def __init__(self, random, speed=0.4):
        self.random, self.speed = random, speed
    def __call__(self, sensed):
        turn = self.random.normal(0.0, 0.2) + 0.1 * len(sensed.heard)
        return {"left": self.speed - turn if abs(turn) < 0.5 else 0.0, "right": self.speed}
"""
DESIGN = """
name: wandering
description: for tests
scenario: five_lilys
numerics: [paper]
seed: 5
replicates: 3
change: {duration: 10 s, swarm: {controller: own/wander.py:Wander}}
baseline: usual
groups:
  usual: {description: as it is}
  slow: {description: slower, change: {swarm: {overrides: {speed: 0.1}}}}
"""


@pytest.fixture
def design(tmp_path: Path) -> Path:
    """A design of a plain controller in a folder beside it."""
    (tmp_path / "own").mkdir()
    (tmp_path / "own/wander.py").write_text(WANDER, "utf-8")
    path = tmp_path / "wandering.yaml"
    path.write_text(DESIGN, "utf-8")
    return path


def rows_of(design: Path, size: int) -> Any:
    """The rows of a design without their wall time, calculated in chunks of a size."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.rows import chunks, run_chunk

    tables = [run_chunk(chunk) for chunk in chunks(load_design(design), set(), size)]
    return pa.concat_tables(tables).drop_columns(["wall_seconds"]).to_pylist()


def test_a_batch_gives_what_single_runs_give(design: Path) -> None:
    """One run at a time and three give the same rows, bit for bit; runs and groups differ."""
    one = rows_of(design, 1)
    assert one == rows_of(design, 3)
    assert len({row["separation"] for row in one}) == 6


def test_a_row_can_be_recorded(design: Path, cocorosim: Callable[..., SimpleNamespace], tmp_path: Path) -> None:
    """The table, a row of it as a bag, and that run's statistics are those of the row."""
    import json

    done = cocorosim("experiment", design, "--out", tmp_path / "results", "--workers", 1)
    assert done.status == 0, done.err
    recorded = cocorosim(
        *("experiment", design, "--row", 4, "--results", tmp_path / "results", "--out", tmp_path / "row")
    )
    assert recorded.status == 0, recorded.err
    found = json.loads((tmp_path / "row/metrics.json").read_text("utf-8"))["metrics"]["separation"]["value"]
    assert found == pytest.approx(rows_of(design, 1)[4]["separation"], rel=1e-12)


def test_results_belong_to_one_version_of_the_file(design: Path, tmp_path: Path) -> None:
    """After an edit the folder is refused in a sentence that names the file, and so are chunks of before."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.rows import chunks, run_chunk
    from cocorosim_ros.study.experiments.store import Store

    before = load_design(design)
    Store(tmp_path / "results", before)
    Store(tmp_path / "results", before)
    file = tmp_path / "own/wander.py"
    file.write_text(WANDER.replace("0.2)", "0.3)"), "utf-8")
    with pytest.raises(CocorosimError, match=r"holds results of another version of .*wander\.py \(SHA-256"):
        Store(tmp_path / "results", load_design(design))
    with pytest.raises(
        CocorosimError, match=r"wander\.py has changed since group 'usual' in numerics 'paper' was made"
    ):
        run_chunk(next(chunks(before, set(), 1)))
    file.write_text(WANDER, "utf-8")
    Store(tmp_path / "results", load_design(design))


def test_designs_of_compiled_controllers_have_no_such_files(design_file: Callable[..., str]) -> None:
    """Their folders are the same to the byte as before there were plain controllers."""
    from cocorosim_ros.study.experiments.design import load_design

    assert "controller_files" not in load_design(design_file()).summary()


def test_the_option_replaces_the_controllers_of_every_group(design_file: Callable[..., str], design: Path) -> None:
    """As in `cocorosim run`: what was overridden goes with the controller that it belonged to."""
    from cocorosim_ros.study.experiments.design import load_design

    own = f"{design.parent / 'own/wander.py'}:Wander"
    cells = load_design(design_file(), controller=own).cells
    assert {robot.controller.name for cell in cells for robot in cell.scenario.robots} == {"Wander"}


@pytest.mark.parametrize("workers", [1, 2])
def test_an_exception_ends_the_experiment(
    design: Path, cocorosim: Callable[..., SimpleNamespace], tmp_path: Path, workers: int
) -> None:
    """Status 1 and the sentence, with the number of the run, from this process and from a worker."""
    failing = WANDER.replace("turn = ", "turn = 1 / (sensed.time - 2.0) + ")
    (tmp_path / "own/wander.py").write_text(failing, "utf-8")
    done = cocorosim("experiment", design, "--out", tmp_path / "results", "--workers", workers)
    assert done.status == 1, done.out
    assert "wander.py:6: ZeroDivisionError: " in done.err
    assert "; this ended 'Wander' of lily_01 at tick 4 (2 s). What is finished is in" in done.err


def test_a_class_that_cannot_be_made_is_refused_first(
    design: Path, cocorosim: Callable[..., SimpleNamespace], tmp_path: Path
) -> None:
    """Status 2, and no folder of results."""
    design.write_text(DESIGN.replace("{speed: 0.1}", "{sped: 0.1}"), "utf-8")
    done = cocorosim("experiment", design, "--out", tmp_path / "results")
    assert done.status == 2 and "takes no 'sped'" in done.err and "did you mean 'speed'?" in done.err
    assert not (tmp_path / "results").exists()
