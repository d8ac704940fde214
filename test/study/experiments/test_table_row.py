"""`cocorosim experiment --row`: the run that is recorded is the row that the table has there."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pyarrow.parquet as pq
import pytest

Write = Callable[..., str]
Experiment = Callable[..., SimpleNamespace]


@pytest.fixture
def table(experiment: Experiment, design_file: Write, tmp_path: Path) -> Path:
    """A folder with the table of a design of four replicates, made with three: rows 0 to 5."""
    made = experiment(design_file(duration="5 s"), "--out", tmp_path / "table", "--replicates", 3, "--workers", 1)
    assert made.status == 0, made.err
    return tmp_path / "table"


@pytest.mark.parametrize("by", ["the folder", "the number"])
def test_the_row_is_that_of_the_table(
    by: str, experiment: Experiment, design_file: Write, table: Path, tmp_path: Path
) -> None:
    """Row 4 of three runs per group is run 1 of the second group; of four it would be run 0."""
    row = pq.read_table(table / "results.parquet").to_pylist()[4]
    how = ("--results", table) if by == "the folder" else ("--replicates", 3)
    ended = experiment(design_file(duration="5 s"), "--row", 4, *how, "--out", tmp_path / "bag")
    assert ended.status == 0 and "row 4: group deaf, paper numerics, replicate 1" in ended.out, ended.err
    shown = json.loads((tmp_path / "bag/metrics.json").read_text("utf-8"))["metrics"]["separation"]["value"]
    assert (row["group"], row["replicate"]) == ("deaf", 1) and shown == pytest.approx(row["separation"], rel=1e-9)


def test_which_table_is_meant_is_said(experiment: Experiment, design_file: Write, tmp_path: Path) -> None:
    """Without a folder and a number it is the table of the design as it stands, four runs in each group."""
    ended = experiment(design_file(duration="5 s"), "--row", 4, "--out", tmp_path / "bag")
    assert ended.status == 0 and "row 4: group deaf, paper numerics, replicate 0" in ended.out, ended.err
    assert "own 4 runs in each group" in ended.out and "--results" in ended.out


def test_a_table_of_one_group(experiment: Experiment, design_file: Write, tmp_path: Path) -> None:
    """The table knows that it has the second group alone."""
    path = design_file(duration="5 s")
    assert experiment(path, "--out", tmp_path / "one", "--group", "deaf", "--workers", 1).status == 0
    ended = experiment(path, "--row", 1, "--results", tmp_path / "one", "--out", tmp_path / "bag")
    assert "row 1: group deaf, paper numerics, replicate 1" in ended.out, ended.err


def test_other_code_is_said(experiment: Experiment, design_file: Write, table: Path, tmp_path: Path) -> None:
    """The run is recorded, and it is said that the row may be another one."""
    rows = pq.read_table(table / "results.parquet")
    place = rows.schema.get_field_index("version")
    pq.write_table(rows.set_column(place, "version", [["0.0.9+other"] * 6]), table / "results.parquet")
    ended = experiment(design_file(duration="5 s"), "--row", 0, "--results", table, "--out", tmp_path / "bag")
    assert ended.status == 0 and "Row 0 was made by version 0.0.9+other of the program" in ended.out


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (("--row", 6, "--results", "table"), "results.parquet has no row 6; choose from 0 to 5"),
        (("--row", -1, "--results", "table"), "has no row -1"),
        (("--row", 4, "--results", "table", "--replicates", 3), "leave out --replicates, --group and --numerics"),
        (("--row", 4, "--results", "nowhere"), "results.parquet does not exist"),
        (("--results", "table"), "give --row too"),
    ],
)
def test_rows_that_cannot_be_known(
    options: tuple[object, ...], told: str, experiment: Experiment, design_file: Write, table: Path, tmp_path: Path
) -> None:
    """One sentence, and nothing is recorded."""
    words = [tmp_path / str(word) if word in ("table", "nowhere") else word for word in options]
    ended = experiment(design_file(duration="5 s"), *words, "--out", tmp_path / "bag")
    assert ended.status == 2 and told in ended.err and ended.err.count("\n") == 1
    assert not (tmp_path / "bag").exists()


def test_a_table_of_another_design_and_one_that_is_not_finished(
    experiment: Experiment, design_file: Write, table: Path, tmp_path: Path
) -> None:
    """A design that was edited since is not the table's; parts have no numbers yet."""
    options = ("--row", 4, "--results", table, "--out", tmp_path / "bag")
    ended = experiment(design_file(duration="6 s"), *options)
    assert ended.status == 2 and "is of group 'deaf' in paper numerics of another design than 'little'" in ended.err
    (table / "results.parquet").unlink()
    ended = experiment(design_file(duration="5 s"), *options)
    assert ended.status == 2 and "holds no finished table yet" in ended.err
