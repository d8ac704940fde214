"""Rows: the same seed gives the same row, however the work is cut, and the row is what a recording shows."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest

Write = Callable[..., str]


def rows_of(path: str, size: int | None) -> Any:
    """The finished rows of a design without their wall time, calculated in chunks of a size."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.rows import chunks, run_chunk

    tables = [run_chunk(chunk) for chunk in chunks(load_design(path), set(), size)]
    return pa.concat_tables(tables).drop_columns(["wall_seconds"]).to_pylist()


@pytest.mark.parametrize(
    ("numbers", "most", "expected"),
    [
        ([], 3, []),
        ([0, 1, 2, 3, 4], 2, [(0, 2), (2, 2), (4, 1)]),
        ([0, 1, 3, 4, 5, 9], 8, [(0, 2), (3, 3), (9, 1)]),
        ([7], 1, [(7, 1)]),
    ],
)
def test_stretches(numbers: list[int], most: int, expected: list[tuple[int, int]]) -> None:
    """Consecutive numbers stay together, up to the most; gaps divide."""
    from cocorosim_ros.study.experiments.rows import stretches

    assert list(stretches(numbers, most)) == expected


def test_a_row_does_not_depend_on_its_chunk(design_file: Write) -> None:
    """One run at a time, three, and all at once give the same rows, bit for bit; replicates differ."""
    path = design_file()
    one = rows_of(path, 1)
    assert one == rows_of(path, 3) == rows_of(path, None)
    assert len({row["separation"] for row in one}) == 8
    assert [row["replicate"] for row in one] == [0, 1, 2, 3] * 2


def test_a_row_is_what_the_recording_of_its_run_shows(design_file: Write, tmp_path: Path) -> None:
    """Every statistic of a row comes out of the bag of that run again; yaw goes through a quaternion there."""
    from cocorosim_ros.graph.runs.in_process import run_in_process
    from cocorosim_ros.graph.runs.run_record import RunRecord
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.metrics import METRICS
    from cocorosim_ros.wire.topics.body import describe_body

    path = design_file()
    row = rows_of(path, None)[6]
    cell, replicate = load_design(path).cell_of_row(6)
    record = RunRecord(tmp_path / "bag", [describe_body(robot) for robot in cell.scenario.robots], {})
    run_in_process(cell.scenario, record, run=replicate)
    record.close()
    recorded = record.summary()["metrics"]
    for name in METRICS:
        shown = [recorded[name][key] for key in ("value", "mean", "median")]
        assert shown == pytest.approx([row[name], row[f"{name}_time_mean"], row[f"{name}_time_median"]], rel=1e-9)
