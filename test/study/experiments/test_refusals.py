"""Designs that cannot be meant, given to the command: one sentence, status 2, and the output folder as it was."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray

Write = Callable[..., str]
Experiment = Callable[..., SimpleNamespace]
GROUPS = """groups:
  BLT: {description: as it is}
  deaf: {description: hears nothing, change: {swarm: {overrides: {alignment_weight: 0}}}}
"""
DRY, WET = "duration: 20 s", "duration: 20 s, water: {%s}"
# What stands in the design file, what stands there instead, options, and what the sentence says.
REFUSED = {
    "no replicate": ("replicates: 4", "replicates: 0", (), "'replicates' has '0'; write a whole number from 1"),
    "no group": (GROUPS, "groups: {}\n", (), "has no group, so that there would be no run"),
    "no numerics": (
        "numerics: [paper]",
        "numerics: []",
        (),
        "names no kind of numerics, so that there would be no run",
    ),
    "a billion": (
        *("replicates: 4", "replicates: 500000000", ()),
        "makes 1,000,000,000 runs, more than the 1,000,000 whose table, about 1 kB a run, fits in memory; choose fewer",
    ),
    "a billion by option": ("", "", ("--replicates", "500000000"), "--replicates makes 1,000,0"),
    "no replicate by option": ("", "", ("--replicates", "0"), "--replicates has 0"),
    "group": ("", "", ("--group", "def"), "has no group 'def'; did you mean 'deaf'?"),
    "numerics": ("", "", ("--numerics", "papre"), "has no kind of numerics 'papre'"),
    "preset": ("numerics: [paper]", "numerics: [papre]", (), "no preset of numerics; did you mean 'paper'?"),
    "metric": ("seed: 5", "seed: 5\nmetrics: [polarization]", (), "did you mean 'polarisation'?"),
    "patch": (DRY, WET % "force_currents: {patch: 0.7 m}", (), "0.7 m, which do not divide the tank's x of 6 m"),
    "step": (
        *(DRY, "duration: 30 s, tick: 1.5 s, integrator: {step: 1.5 s}", ()),
        "step of 1.5 s, beyond the 1.05 s up to which 'semi_implicit_euler' is stable for the platform 'lily_paper'",
    ),
    "netCDF": (DRY, WET % "currents: [{kind: gridded, file: bay.nc}]", (), "bay.nc', which lacks 'v' (it has u)"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_it_is_refused_before_anything_is_written(
    case: str, design_file: Write, experiment: Experiment, tmp_path: Path
) -> None:
    """A new folder is not made, and one with results is left as it is, --force or not."""
    axes = {"t": [0.0], "z": [-1.0], "y": [0.0, 1.0], "x": [0.0, 1.0]}
    field = xarray.Dataset({"u": (tuple(axes), np.zeros((1, 1, 2, 2)))}, coords=axes)
    field.to_netcdf(tmp_path / "bay.nc", engine="scipy")
    path = Path(design_file())
    old, new, options, told = REFUSED[case]
    assert old in path.read_text("utf-8")
    path.write_text(path.read_text("utf-8").replace(old, new), "utf-8")
    kept = tmp_path / "kept"
    (kept / "parts").mkdir(parents=True)
    for name in ("design.json", "results.parquet", "parts/rows.parquet"):
        (kept / name).write_text(name, "utf-8")
    for folder, force in ((tmp_path / "new", ()), (kept, ()), (kept, ("--force",))):
        ended = experiment(path, "--out", folder, *options, *force)
        assert ended.status == 2
        assert told in ended.err and ended.err.count("\n") == 1, ended.err
    assert not (tmp_path / "new").exists()
    left = {str(part.relative_to(kept)): part.read_text("utf-8") for part in kept.rglob("*") if part.is_file()}
    assert left == {name: name for name in ("design.json", "results.parquet", "parts/rows.parquet")}


def test_the_most_that_is_allowed_is_allowed(design_file: Write) -> None:
    """Half a million runs of each of two groups are a million, and a million of the one that is chosen."""
    from cocorosim_ros.foundation.errors import CocorosimError
    from cocorosim_ros.study.experiments.design import MOST_RUNS, load_design

    assert load_design(design_file(replicates=MOST_RUNS // 2)).runs == MOST_RUNS
    assert load_design(design_file(), replicates=MOST_RUNS, groups=["BLT"]).runs == MOST_RUNS
    with pytest.raises(CocorosimError, match=r"makes 1,000,002 runs"):
        load_design(design_file(replicates=MOST_RUNS // 2 + 1))


def test_a_row_of_a_table_takes_a_kilobyte() -> None:
    """The reason that the sentence gives: a million rows are about a gigabyte in memory."""
    from cocorosim_ros.study.experiments.rows import SCHEMA

    assert 500 < 8 * len(SCHEMA.names) < 1500
