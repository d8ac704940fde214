"""One run whose motion runs away costs its own row, not the experiment."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pyarrow.parquet as pq
import pytest

Write = Callable[..., str]
Experiment = Callable[..., SimpleNamespace]


def table(experiment: Experiment, design: str, folder: Path) -> tuple[list[dict[str, Any]], str]:
    """The rows of an experiment without their wall time, and what was said."""
    ended = experiment(design, "--out", folder, "--workers", 1)
    assert ended.status == 0, ended.err
    return pq.read_table(folder / "results.parquet").drop_columns(["wall_seconds"]).to_pylist(), ended.out


@pytest.fixture
def run_2_runs_away(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Function after which run 2 of every group is no number any more after three ticks."""
    from cocorosim_ros.world.state.state import SURGE
    from cocorosim_ros.world.tick.simulation import Simulation

    decide = Simulation.decide

    def decide_and_break(self: Simulation) -> None:
        decide(self)
        run = 2 - self.world.first_run
        if self.tick == 3 and 0 <= run < len(self.state):
            self.state[run, 0, SURGE] = math.nan

    return lambda: monkeypatch.setattr(Simulation, "decide", decide_and_break)


def test_the_other_rows_stay_as_they_are(
    experiment: Experiment, design_file: Write, tmp_path: Path, run_2_runs_away: Callable[[], None]
) -> None:
    """Bit for bit, though they were calculated with it; its own has no values, and it is said of both groups."""
    design = design_file()
    whole, said = table(experiment, design, tmp_path / "whole")
    assert "ran away" not in said
    run_2_runs_away()
    broken, said = table(experiment, design, tmp_path / "broken")
    for before, after in zip(whole, broken, strict=True):
        if after["replicate"] == 2:
            assert math.isnan(after["polarisation"]) and math.isnan(after["lost_time_mean"])
            assert (after["seed"], after["ticks"]) == (before["seed"], 3)
        else:
            assert after == before
    told = " ".join(said.split())
    for group in ("BLT", "deaf"):
        assert f"1 of 4 runs of the group '{group}', paper numerics, ran away" in told


def test_it_is_no_run_of_a_report(
    experiment: Experiment, design_file: Write, tmp_path: Path, run_2_runs_away: Callable[[], None]
) -> None:
    """Medians, quartiles and effects are those of the runs that there are, three in each group."""
    from cocorosim_ros.study.results.report import render_report
    from cocorosim_ros.study.results.results import load_results

    run_2_runs_away()
    table(experiment, design_file(), tmp_path / "broken")
    results = load_results(tmp_path / "broken")
    assert results.spread("paper", "deaf", "polarisation").runs == 3
    assert 0.0 <= results.effect("paper", "deaf", "polarisation").value <= 1.0
    assert "nan" not in render_report([results]).lower().partition("<svg")[0]
