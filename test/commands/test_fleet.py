"""`cocorosim diagnose --fleet`: recordings of a minute, broken ones among them, processes that are killed, Dask."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pyarrow.parquet as pq
import pytest

TESTS = Path(__file__).parents[1]
Command = Callable[..., SimpleNamespace]
Start = Callable[..., subprocess.Popen[str]]
ROBOTS, WEEKS = 2, 4


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two robots in four weeks, a minute each; one loses 5 % of its thrust a week. Among them what is no recording."""
    if str(TESTS) not in sys.path:
        sys.path.append(str(TESTS))
    from concealer.fleet import FleetPlan, make_fleet

    folder = tmp_path_factory.mktemp("made") / "fleet"
    plan = FleetPlan(20261123, ROBOTS, WEEKS, loser=1, loss=0.05, scatter=0.001, duration=60.0)
    assert len(list(make_fleet(plan, folder, range(ROBOTS * WEEKS)))) == ROBOTS * WEEKS
    (folder / "week_01" / "empty.mcap").write_bytes(b"")
    (folder / "week_01" / "notes.mcap").write_text("the battery was low", "utf-8")
    (folder / "old.db3").write_bytes(b"SQLite format 3\0")
    shutil.copytree(folder / "week_02" / "lily_001", folder / "week_02" / "lily_001_copy")
    whole = next((folder / "week_03" / "lily_001").glob("*.mcap")).read_bytes()
    (folder / "week_03" / "cut.mcap").write_bytes(whole[:200])
    return folder


BROKEN = {
    "old.db3": "SQLite storage",
    "week_01/empty.mcap": "",
    "week_01/notes.mcap": "",
    "week_02/lily_001_copy": "is a copy of week_02/lily_001, byte by byte",
    "week_03/cut.mcap": "",
}
"""By recording: words of its sentence."""


@pytest.fixture(scope="module")
def diagnosed(fleet: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What one process makes of the fleet without anything happening."""
    from cocorosim_ros.library.fleet import diagnose_fleet

    out = tmp_path_factory.mktemp("out") / "one"
    diagnose_fleet(fleet, "lily", out, workers=1)
    return out


def test_broken_recordings_among_good_ones(diagnosed: Path) -> None:
    """Each is a row with a sentence that names it, and every other one is diagnosed."""
    rows = pq.read_table(diagnosed / "fleet.parquet").to_pylist()
    problems = {row["recording"]: row["problem"] for row in rows if row["problem"]}
    assert problems.keys() == BROKEN.keys()
    page = (diagnosed / "fleet.html").read_text("utf-8")
    for name, words in BROKEN.items():
        assert words in problems[name] and Path(name).name in problems[name]
        assert problems[name].endswith(".") and f"<b>{name}</b>" in page
    good = [row for row in rows if not row["problem"]]
    assert len(good) == ROBOTS * WEEKS and all(row["thrust_gain"] and row["verdict"] for row in good)
    assert {row["robot"] for row in good} == {"lily_001", "lily_002"}
    assert [row["recording"] for row in rows] == sorted(row["recording"] for row in rows)


def test_the_table_has_what_single_diagnoses_say(diagnosed: Path, fleet: Path) -> None:
    """The numbers of one of them are those of `diagnose` of that recording."""
    import cocorosim_ros as cocorosim

    alone = cocorosim.diagnose(fleet / "week_00" / "lily_002", "lily")
    rows = pq.read_table(diagnosed / "fleet.parquet").to_pylist()
    (row,) = [each for each in rows if each["recording"] == "week_00/lily_002"]
    found = {each.parameter: each.estimate for each in alone.diagnosis.all_recalibrated}
    assert all((row[name], row[f"{name}_low"]) == (each.value, each.low) for name, each in found.items())
    assert (row["verdict"], row["sentence"]) == (alone.verdict, alone.sentence)
    tried = {each.id for each in alone.diagnosis.screened}
    assert "neighbour_wake" in alone.diagnosis.not_shown and "neighbour_wake" not in tried, "a single robot has none"
    assert row["not_shown"] == [name for name in alone.diagnosis.not_shown if name in tried] != []


def outcomes(out: Path) -> list[Path]:
    """Outcomes that are there."""
    return sorted((out / "outcomes").rglob("*.json"))


def words_for(fleet: Path, out: Path, *more: Any) -> tuple[Any, ...]:
    """The arguments of the command."""
    return ("diagnose", "--fleet", fleet, "--platform", "lily", "--out", out, *more)


def test_killed_on_the_way(diagnosed: Path, fleet: Path, start: Start, cocorosim: Command, tmp_path: Path) -> None:
    """A worker is killed, then the command: the same command goes on, and the table is the same."""
    out = tmp_path / "out"
    command = start(*words_for(fleet, out, "--workers", 2))
    wait_for(lambda: len(outcomes(out)) >= 2, command)
    os.kill(workers(command.pid)[0], signal.SIGKILL)
    there = len(outcomes(out))
    wait_for(lambda: len(outcomes(out)) >= there + 2, command)
    assert command.poll() is None
    command.kill()
    command.wait()
    kept = {path: path.stat().st_mtime_ns for path in outcomes(out)}
    assert not (out / "fleet.parquet").exists()
    done = cocorosim(*words_for(fleet, out, "--workers", 2, "--json", tmp_path / "fleet.json"))
    assert done.status == 0, done.err
    assert f"{len(kept)} of {ROBOTS * WEEKS + len(BROKEN)} recordings are there already" in done.out
    assert {path: path.stat().st_mtime_ns for path in kept} == kept
    assert (out / "fleet.parquet").read_bytes() == (diagnosed / "fleet.parquet").read_bytes()
    again = [each for each in map(json.loads, (path.read_text() for path in outcomes(out))) if each["attempts"] > 1]
    for each in again:  # none, if the worker was killed between two recordings
        assert f"The process that diagnosed {each['recording']} was killed by SIGKILL" in done.out
    tree = json.loads((tmp_path / "fleet.json").read_text())
    (thrust,) = [each for each in tree["drifts"] if (each["robot"], each["parameter"]) == ("lily_002", "thrust_gain")]
    low, high = thrust["per_week"]["ci95"]
    assert low < -0.05 < high < 0.0


def test_interrupted(diagnosed: Path, fleet: Path, start: Start, cocorosim: Command, tmp_path: Path) -> None:
    """Ctrl-C leaves table and page of what is there; then a changed recording and a new one are all that is done."""
    mine, out = tmp_path / "fleet", tmp_path / "out"
    shutil.copytree(fleet, mine)
    same = words_for(mine, out, "--workers", 1, "--markdown", tmp_path / "found.md", "--json", tmp_path / "found.json")
    command = start(*same)
    wait_for(lambda: len(outcomes(out)) >= 2, command)
    command.send_signal(signal.SIGINT)
    said, _ = command.communicate(timeout=120)
    assert command.returncode == 130 and "The same command goes on." in said, said
    part = pq.read_table(out / "fleet.parquet").num_rows
    assert 2 <= part < ROBOTS * WEEKS + len(BROKEN)
    assert "<b>Not finished:</b>" in (out / "fleet.html").read_text("utf-8")
    for path in outcomes(diagnosed):  # to be quick: what one process has made of copies of the same files
        there = json.loads(path.read_text("utf-8"))
        for file in there["files"]:
            file["changed_ns"] = (mine / file["name"]).stat().st_mtime_ns
        copy = out / path.relative_to(diagnosed)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(json.dumps(there), "utf-8")
    with (mine / "week_01" / "notes.mcap").open("a", encoding="utf-8") as notes:
        notes.write("; it was charged")
    (mine / "week_01" / "more.mcap").write_text("more notes", "utf-8")
    (mine / "old.db3").unlink()
    done = cocorosim(*same)
    assert done.status == 0, done.err
    assert f"{ROBOTS * WEEKS + 3} of {ROBOTS * WEEKS + 5} recordings are there already" in done.out
    assert "1 recording was changed since the last time, and diagnosed again: week_01/notes.mcap." in done.out
    assert "1 outcomes are of recordings that are no longer there" in done.out


@pytest.mark.filterwarnings("ignore")  # of clusters that are shut down
def test_on_a_cluster(diagnosed: Path, fleet: Path, cocorosim: Command, tmp_path: Path) -> None:
    """The table of `--dask` is the table of one process, byte by byte."""
    from dask.distributed import LocalCluster

    options = {"threads_per_worker": 1, "processes": True, "host": "127.0.0.1", "dashboard_address": None}
    with LocalCluster(n_workers=1, **options) as cluster:
        done = cocorosim(*words_for(fleet, tmp_path / "far", "--dask", cluster.scheduler_address))
    assert done.status == 0, done.err
    assert (tmp_path / "far" / "fleet.parquet").read_bytes() == (diagnosed / "fleet.parquet").read_bytes()


def test_a_changed_platform_is_said(diagnosed: Path, fleet: Path, cocorosim: Command) -> None:
    """Outcomes of two platforms are not mixed, and nothing is lost by asking."""
    before = (diagnosed / "fleet.parquet").read_bytes()
    done = cocorosim("diagnose", "--fleet", fleet, "--platform", "jeff", "--out", diagnosed)
    assert done.status == 2 and "with the platform 'lily', not with 'jeff'" in done.err and "--force" in done.err
    assert (diagnosed / "fleet.parquet").read_bytes() == before


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (("some_bag",), "and some_bag was given beside it; leave one of them out"),
        (("--against", "good"), "--against is about one diagnosis"),
        (("--fail-on", "mismatch"), "--fail-on is about one diagnosis"),
        (("--junit", "x.xml"), "--junit is about one diagnosis"),
        (("--workers", "0"), "--workers has 0; give 1 or more"),
        (("--workers", "2", "--dask", "tcp://x:1"), "leave one of them out"),
        (("--json", "no_such_folder/x.json"), "lies in a folder that does not exist"),
    ],
)
def test_options_that_say_nothing_together(
    fleet: Path, cocorosim: Command, tmp_path: Path, more: tuple[str, ...], words: str
) -> None:
    """Status 2, one sentence, and no folder."""
    done = cocorosim(*words_for(fleet, tmp_path / "out", *more))
    assert done.status == 2 and words in done.err and len(done.err.strip().splitlines()) == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("bag", "--workers", "2"), "--workers says what diagnoses the recordings of a fleet; give --fleet too"),
        (("bag", "--dask", "tcp://x:1"), "--dask says what diagnoses"),
        ((), "Missing argument 'BAG...'; give recordings, or a folder of many with --fleet"),
        (("--fleet", "no_such_fleet"), "no_such_fleet does not exist; give the folder that holds the recordings"),
    ],
)
def test_options_of_fleets_alone(cocorosim: Command, tmp_path: Path, arguments: tuple[str, ...], words: str) -> None:
    """They are refused with one recording, and a fleet that is none before anything is written."""
    done = cocorosim("diagnose", *arguments, "--platform", "lily", "--out", tmp_path / "out")
    assert done.status == 2 and words in done.err
    assert not (tmp_path / "out").exists()


def wait_for(happened: Callable[[], bool], process: subprocess.Popen[str]) -> None:
    """Wait for something that a process does."""
    deadline = time.monotonic() + 300
    while not happened():
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.02)


def workers(pid: int) -> list[int]:
    """Processes below one that work."""
    children = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    return [int(each) for each in children if "spawn_main" in Path(f"/proc/{each}/cmdline").read_text()]
