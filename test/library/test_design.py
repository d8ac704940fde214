"""Designs: the rows of the command, resumed where they were left."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import cocorosim_ros as library

DESIGN = """
name: little
description: for tests
scenario: five_lilys
numerics: [paper]
seed: 5
replicates: 3
change: {duration: 10 s}
baseline: BLT
groups:
  BLT: {description: as it is}
  deaf: {description: hears nothing, change: {swarm: {overrides: {alignment_weight: 0}}}}
"""
TIMED = ["wall_seconds"]


@pytest.fixture
def design(tmp_path: Path) -> Path:
    """Two groups of three short runs."""
    file = tmp_path / "little.yaml"
    file.write_text(DESIGN, "utf-8")
    return file


def test_rows_are_those_of_the_command(design: Path, cocorosim: Callable[..., SimpleNamespace], tmp_path: Path) -> None:
    """All columns but the time that it took; the command prints the sentences of these results."""
    results = library.run_design(design, tmp_path / "mine", workers=1)
    ended = cocorosim("experiment", design, "--out", tmp_path / "its", "--workers", 1)
    assert ended.status == 0, ended.err
    assert f"{tmp_path / 'its' / 'results.parquet'}: 6 rows, " in ended.out.replace("\n", "")
    theirs = library.run_design(design, tmp_path / "its")
    assert results.table.drop(TIMED).equals(theirs.table.drop(TIMED))
    assert (results.missing, results.findings, results.file.is_file()) == (0, (), True)


def test_it_goes_on_where_it_was_left(design: Path, tmp_path: Path) -> None:
    """An end that is asked for keeps what is done; the same call does the rest, and then nothing."""
    told: list[tuple[int, int]] = []
    ended = library.Watch(lambda done, runs: told.append((done, runs)), lambda: not told or told[-1][0] < 3)
    half = library.run_design(design, tmp_path / "out", workers=1, watch=ended)
    assert (half.missing, half.table.num_rows, half.file.exists()) == (3, 3, False)
    assert told == [(0, 6), (3, 6)]
    told.clear()
    whole = library.run_design(design, tmp_path / "out", workers=1, watch=library.Watch(lambda *n: told.append(n)))
    assert (whole.missing, whole.table.num_rows, told) == (0, 6, [(3, 6), (6, 6)])
    told.clear()
    library.run_design(design, tmp_path / "out", watch=library.Watch(lambda *n: told.append(n)))
    assert told == [(6, 6)]


def test_groups_are_chosen_by_the_design(design: Path, tmp_path: Path) -> None:
    """A loaded design has the groups that it was loaded with; the number of runs may be another."""
    loaded = library.load_design(design, groups=["deaf"])
    results = library.run_design(loaded, tmp_path / "out", replicates=2, workers=1)
    assert results.table["group"].to_pylist() == ["deaf", "deaf"]
    assert results.design.replicates == 2


def test_frame_and_card(design: Path, tmp_path: Path, parse: Callable[[str], Any]) -> None:
    """The frame is the table; the card has the median of each group."""
    results = library.run_design(design, tmp_path / "out", workers=1)
    frame = results.to_frame()
    assert frame["replicate"].tolist() == [0, 1, 2, 0, 1, 2]
    assert list(frame.columns) == results.table.column_names
    page = parse(results._repr_html_())
    median = np.median(results.table["separation"].to_numpy()[:3])
    assert {"BLT", "deaf", "median separation", f"{median:.4g}"} <= set(page.cells)
    assert "runs 6 of 6" in repr(results)


def test_what_cannot_be_meant(design: Path, tmp_path: Path) -> None:
    """One sentence each, and no folder."""
    with pytest.raises(library.CocorosimError, match="'workers' has 0; give a whole number from 1 on"):
        library.run_design(design, tmp_path / "out", workers=0)
    with pytest.raises(library.CocorosimError, match="no design"):
        library.run_design("smok", tmp_path / "out")
    assert not (tmp_path / "out").exists()
