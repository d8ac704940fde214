"""`cocorosim claims` and `cocorosim report`: what they refuse, and a small study from end to end."""

from __future__ import annotations

import csv
import io
import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

Run = Callable[..., SimpleNamespace]


def test_nothing_to_hold_them_against(cocorosim: Run, tmp_path: Path) -> None:
    """Neither results nor --run, or both."""
    for arguments in ((), (tmp_path, "--run", tmp_path)):
        ended = cocorosim("claims", *arguments)
        assert ended.status == 2 and "either RESULTS" in ended.err


def test_pages_are_not_overwritten(cocorosim: Run, tmp_path: Path) -> None:
    """A page that is there stays as it is without --force."""
    page = tmp_path / "page.md"
    page.write_text("mine", "utf-8")
    assert "exists already" in cocorosim("claims", tmp_path, "--out", page).err
    assert page.read_text("utf-8") == "mine"


@pytest.mark.parametrize(
    ("page", "told"),
    [
        ("missing/page.md", "in a folder that does not exist"),
        ("file/page.md", "in a folder that does not exist"),
        ("folder", "is a folder; give the name of a file"),
    ],
)
def test_a_place_for_the_page_is_looked_for_first(cocorosim: Run, tmp_path: Path, page: str, told: str) -> None:
    """Before anything is run for it, also with --force."""
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").touch()
    ended = cocorosim("claims", "--run", tmp_path / "runs", "--out", tmp_path / page, "--replicates", 0, "--force")
    assert ended.status == 2 and told in ended.err and ended.err.count("\n") == 1
    assert not (tmp_path / "runs").exists()


@pytest.mark.parametrize("made", [False, True])
def test_a_report_of_no_experiment(cocorosim: Run, tmp_path: Path, made: bool) -> None:
    """It is the folder of results that is wrong, not the place of the page in it."""
    folder = tmp_path / "results"
    if made:
        folder.mkdir()
    ended = cocorosim("report", folder)
    assert ended.status == 2 and f"{folder} holds no experiment" in ended.err


def test_a_folder_that_is_not_mine(cocorosim: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A place where nothing may be written is said before anything is run."""
    monkeypatch.setattr("os.access", lambda *_: False)
    ended = cocorosim("claims", "--run", tmp_path / "runs", "--replicates", 0, "--out", tmp_path / "page.md")
    assert ended.status == 2 and "may not be written by you" in ended.err


def test_results_of_another_design(cocorosim: Run, tmp_path: Path) -> None:
    """Results of a design that no claim is about."""
    options = ("--replicates", 1, "--numerics", "paper", "--workers", 1)
    assert cocorosim("experiment", "smoke", "--out", tmp_path / "smoke", *options).status == 0
    ended = cocorosim("claims", tmp_path / "smoke")
    assert ended.status == 2 and "'smoke'" in ended.err
    report = cocorosim("report", tmp_path / "smoke", "--table", tmp_path / "smoke.csv")
    assert report.status == 0 and (tmp_path / "smoke.csv").read_text("utf-8").startswith("design,numerics,group")
    assert "exists already" in cocorosim("report", tmp_path / "smoke").err


@pytest.fixture
def short_studies(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[str, ...]:
    """The names of the two designs of the paper, which are found as copies of 20 ticks, calculated in this process."""
    from cocorosim_ros.library import design
    from cocorosim_ros.scenario.reading import config_files
    from cocorosim_ros.study.claims import all_claims

    studies = ("boids", "turbulence")
    folders = config_files.config_folders()
    (tmp_path / "config" / "designs").mkdir(parents=True)
    for name in studies:
        text, changes = re.subn(
            r"duration: \d+ s", "duration: 10 s", config_files.find_config("designs", name).read_text("utf-8")
        )
        assert changes == 1
        (tmp_path / "config" / "designs" / f"{name}.yaml").write_text(text, "utf-8")
    monkeypatch.setattr(config_files, "config_folders", lambda: [tmp_path / "config", *folders])
    monkeypatch.setattr(all_claims, "STUDIES", studies)
    monkeypatch.setattr(design, "processors", lambda: 1)
    return studies


def test_one_command_makes_the_page(cocorosim: Run, tmp_path: Path, short_studies: tuple[str, ...]) -> None:
    """With --run the designs run first, and every claim is asked of them: on the terminal and on the page."""
    page = tmp_path / "claims.md"
    ended = cocorosim("claims", "--run", tmp_path / "runs", "--replicates", 2, "--out", page, "--json", "-")
    assert ended.status == 0, ended.err
    text = page.read_text("utf-8")
    for name in short_studies:
        assert f"| `{name}` | 2 | accurate, paper | 20 |" in text
    rows = [line.strip("| ").split(" | ") for line in text.partition("\n## ")[0].splitlines() if "| " in line]
    claims = {cells[0]: cells for cells in rows}
    expected = [f"{letter}{number}" for letter, last in (("C", 5), ("S", 22), ("T", 5), ("M", 3)) for number in
                range(1, last + 1)]  # fmt: skip
    assert [name for name in dict.fromkeys(cells[0] for cells in rows) if name in expected] == expected
    assert all({claims[name][4], claims[name][6]} <= {"yes", "**no**", "open"} for name in expected)
    assert all(name in ended.err for name in expected)
    assert {answer["claim"] for answer in json.loads(ended.out)["answers"]} >= set(expected)
    a = share_of_wins(tmp_path / "runs" / "boids", "NA", "Van", "polarisation")
    assert f"A = {a:.3f} (" in claims["S3"][3]
    # Two runs decide nothing that needs an interval over runs.
    assert [claims[name][4] for name in ("T4", "M1", "S18")] == ["open"] * 3


def share_of_wins(folder: Path, group: str, other: str, column: str) -> float:
    """A by counting pairs of runs in the paper's numerics, a draw as a half."""
    rows = [row for row in pq.read_table(folder / "results.parquet").to_pylist() if row["numerics"] == "paper"]
    ours, theirs = ([row[column] for row in rows if row["group"] == name] for name in (group, other))
    assert len(ours) == len(theirs) == 2
    return sum((a > b) + (a == b) / 2 for a in ours for b in theirs) / 4


STUDIES = ("boids", "turbulence", "boids_choices", "turbulence_choices")


@pytest.fixture
def four_folders(tmp_path: Path) -> list[Path]:
    """Eight rows for each group of the four designs, without a simulation: polarisation tells design and group."""
    from cocorosim_ros.scenario.reading.config_files import find_config
    from cocorosim_ros.scenario.reading.yaml_file import load_yaml
    from cocorosim_ros.study.experiments.rows import SCHEMA

    for place, name in enumerate(STUDIES):
        design = load_yaml(find_config("designs", name)).mapping()
        groups = list(design["groups"].mapping())
        cells = [{"numerics": "accurate", "group": group, "description": "", "scenario": ""} for group in groups]
        note = {"design": name, "digest": "d", "description": name, "baseline": groups[0], "cells": cells}
        note |= {"replicates": 8, "metrics": ["polarisation", "lost"], "robots": 11, "tank": "", "ticks": 9, "tick": 1}
        note["version"] = "0.1.0+made"
        runs = 8 * len(groups)
        columns: dict[str, Any] = {
            field.name: ["accurate"] * runs if field.type == pa.string() else np.zeros(runs) for field in SCHEMA
        }
        columns |= {"group": np.repeat(groups, 8), "replicate": np.tile(np.arange(8), len(groups))}
        medians = [made_up_median(place, group) for group in range(len(groups))]
        columns["polarisation"] = np.add.outer(medians, np.arange(-3.5, 4) / 1e4).ravel()
        table = pa.table({key: pa.array(column, SCHEMA.field(key).type) for key, column in columns.items()})
        (tmp_path / name).mkdir()
        (tmp_path / name / "design.json").write_text(json.dumps(note), "utf-8")
        pq.write_table(table, tmp_path / name / "results.parquet")
    return [tmp_path / name for name in STUDIES]


def made_up_median(design: int, group: int) -> float:
    """Each group above the one before, but in the third design below."""
    return 0.1 * (design + 1) + (0.002 if design != 2 else -0.002) * group


def test_groups_of_the_same_name_in_four_designs(cocorosim: Run, four_folders: list[Path], tmp_path: Path) -> None:
    """Van, BLT, T0 and others are in two designs: medians and effects are those of each design's own runs."""
    page, table = tmp_path / "all.html", tmp_path / "all.csv"
    ended = cocorosim("report", *four_folders, "--out", page, "--table", table)
    assert ended.status == 0, ended.err
    lines = {
        (line["design"], line["group"]): line
        for line in csv.DictReader(io.StringIO(table.read_text("utf-8")))
        if (line["numerics"], line["metric"], line["over time"]) == ("accurate", "polarisation", "own definition")
    }
    for place, name in enumerate(STUDIES):
        groups = [group for design, group in lines if design == name]
        found = [float(lines[name, group]["median"]) for group in groups]
        assert found == pytest.approx([made_up_median(place, group) for group in range(len(groups))])
        assert {lines[name, group]["runs"] for group in groups} == {"8"}
    assert {key[0] for key in lines if key[1] == "T5e-4"} == {"turbulence", "turbulence_choices"}
    told = [lines[key][column] for key in (("boids", "BLT"), ("boids_choices", "BLT")) for column in
            ("baseline", "A against baseline")]  # fmt: skip
    assert told == ["Van", "1", "Van", "0"]
    assert lines["turbulence_choices", "T5e-4, lever"]["baseline"] == "T0, lever"
    assert lines["boids_choices", "BLC, units"]["baseline"] == "Van"
    chapters = page.read_text("utf-8").split("<h1 ")
    assert [name in chapter for name, chapter in zip(STUDIES, chapters[1:], strict=True)] == [True] * 4
    assert all(f'href="#design-{number}"' in chapters[0] for number in range(1, 5))
    shown = [re.search(r"<tr><th>BLT</th><td>Van</td>.*?<span class=\"large\">(.)", chapters[part]) for part in (1, 3)]
    assert [match and match[1] for match in shown] == ["\u25b2", "\u25bc"]
    assert "<td>T0, lever</td>" in chapters[4] and "<td>T0, lever</td>" not in chapters[2]


@pytest.mark.parametrize("command", ["report", "claims"])
def test_two_folders_of_one_design(cocorosim: Run, four_folders: list[Path], tmp_path: Path, command: str) -> None:
    """Which of the two a row is of could not be told, and claims would be held against the last alone."""
    (tmp_path / "copy").mkdir()
    for name in ("design.json", "results.parquet"):
        shutil.copy(four_folders[0] / name, tmp_path / "copy" / name)
    ended = cocorosim(command, *four_folders, tmp_path / "copy", "--out", tmp_path / "page")
    assert ended.status == 2 and "both hold results of a design 'boids'" in ended.err
    assert not (tmp_path / "page").exists()
