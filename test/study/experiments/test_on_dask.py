"""A Dask cluster gives the rows that one process gives, also when a worker is killed in the middle."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pyarrow.parquet as pq
import pytest

from cocorosim_ros.foundation.errors import CocorosimError

Write = Callable[..., str]
Experiment = Callable[..., SimpleNamespace]
pytestmark = pytest.mark.filterwarnings("ignore")  # of clusters that are shut down


@pytest.fixture
def cluster() -> Iterator[Any]:
    """A scheduler and two worker processes on this machine."""
    from dask.distributed import LocalCluster

    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, host="127.0.0.1", dashboard_address=None
    ) as local:
        yield local


def test_a_killed_worker_costs_nothing(design_file: Write, cluster: Any) -> None:
    """One of two workers is killed after the first chunk: every row comes, once, with the numbers of one process."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.on_dask import connected, run_on_dask
    from cocorosim_ros.study.experiments.rows import chunks, run_chunk

    work = list(chunks(load_design(design_file(replicates=6, duration="60 s")), set(), 1))
    expected = [run_chunk(chunk).drop_columns(["wall_seconds"]).to_pylist()[0] for chunk in work]
    found: list[dict[str, Any]] = []
    with connected(cluster.scheduler_address) as client:
        for table in run_on_dask(work, client, lambda: True):
            if not found:
                os.kill(next(iter(client.run(os.getpid).values())), signal.SIGKILL)
            found += table.drop_columns(["wall_seconds"]).to_pylist()
    assert len(found) == 12
    assert sorted(found, key=lambda row: (row["group"], row["replicate"])) == expected


def test_nothing_more_is_asked_for_after_an_interruption(design_file: Write, cluster: Any) -> None:
    """As soon as it is told to stop, no more rows come."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.on_dask import connected, run_on_dask
    from cocorosim_ros.study.experiments.rows import chunks

    work = list(chunks(load_design(design_file()), set(), 1))
    with connected(cluster.scheduler_address) as client:
        assert list(run_on_dask(work, client, lambda: False)) == []


def test_no_scheduler_is_a_sentence(
    experiment: Experiment, design_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An address where nobody answers is named, and no folder is made for rows that will not come."""
    from cocorosim_ros.study.experiments import on_dask

    monkeypatch.setattr(on_dask, "_CONNECTING", 1)
    ended = experiment(design_file(), "--out", tmp_path / "a", "--dask", "tcp://127.0.0.1:9")
    assert ended.status == 2 and "No Dask scheduler answers at 'tcp://127.0.0.1:9'" in ended.err
    assert not (tmp_path / "a").exists()


def test_the_command_on_a_cluster(experiment: Experiment, design_file: Write, tmp_path: Path, cluster: Any) -> None:
    """The table of `--dask` is the table of one process."""
    path, tables = design_file(duration="5 s"), []
    for name, where in (("far", ("--dask", cluster.scheduler_address)), ("near", ("--workers", 1))):
        ended = experiment(path, "--out", tmp_path / name, *where)
        assert ended.status == 0 and "8 rows" in ended.out, ended.err
        tables.append(pq.read_table(tmp_path / name / "results.parquet").drop_columns(["wall_seconds"]).to_pylist())
    assert len(tables[0]) == 8 and tables[0] == tables[1]


def test_rows_of_other_code_are_not_kept(
    experiment: Experiment, design_file: Write, tmp_path: Path, cluster: Any
) -> None:
    """A worker with another version of the program: both versions are named, none of its rows stays."""
    from dask.distributed import Client

    def become_another() -> None:
        from cocorosim_ros.study.experiments import rows

        rows.version = lambda: "0.0.9+other"

    with Client(cluster.scheduler_address, set_as_default=False) as client:
        client.run(become_another)
    ended = experiment(design_file(duration="5 s"), "--out", tmp_path / "a", "--dask", cluster.scheduler_address)
    assert ended.status == 2 and "A worker has version 0.0.9+other of the program" in ended.err
    assert ended.err.count("\n") == 1 and not list((tmp_path / "a/parts").iterdir())


def ended_by(cluster: Any, monkeypatch: pytest.MonkeyPatch, run_chunk: Callable[[Any], Any]) -> str:
    """What is said when workers calculate a chunk so."""
    from cocorosim_ros.study.experiments import on_dask

    monkeypatch.setattr(on_dask, "run_chunk", run_chunk)
    chunk: Any = "a chunk"
    with on_dask.connected(cluster.scheduler_address) as client, pytest.raises(CocorosimError) as error:
        list(on_dask.run_on_dask([chunk], client, lambda: True))
    return str(error.value)


def test_runs_that_kill_their_workers(cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """When Dask gives up, the scheduler is named and what to do."""
    cluster.scheduler.allowed_failures = 0
    said = ended_by(cluster, monkeypatch, lambda chunk: os._exit(1))
    assert f"'{cluster.scheduler_address}' has lost worker after worker" in said and "finished is kept" in said


@pytest.mark.parametrize(
    "error",
    [
        ModuleNotFoundError("No module named 'numba'"),
        RuntimeError("Error during deserialization of the task graph.\nThis frequently occurs"),
    ],
)
def test_a_cluster_without_the_package(error: Exception, cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a worker cannot load is named, and what the scheduler says when it cannot."""

    def load(chunk: Any) -> None:
        raise error

    said = ended_by(cluster, monkeypatch, load)
    assert f"cannot load the package ({' '.join(str(error).split())}); install there what is installed here" in said


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM])
def test_a_scheduler_that_dies_midway(number: signal.Signals, design_file: Write, tmp_path: Path) -> None:
    """Killed, or ended in order, while chunks wait for workers: one sentence with its address and no traceback."""
    program = "from cocorosim_ros.commands.main import main; main()"
    words = [sys.executable, "-c", program, "experiment", design_file(), "--out", str(tmp_path / "a"), "--dask"]
    with scheduler_process(tmp_path / "scheduler.json") as (scheduler, address):
        command = subprocess.Popen([*words, address], stderr=subprocess.PIPE, text=True)
        wait_for((tmp_path / "a/design.json").exists, command)
        time.sleep(1.0)
        scheduler.send_signal(number)
        _, said = command.communicate(timeout=120)
    assert command.returncode == 2 and said.count("\n") == 1 and f"'{address}' was lost on the way" in said, said


def test_a_scheduler_that_dies_before_anything_is_asked_of_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is noticed when it does not come back."""
    from cocorosim_ros.study.experiments import on_dask

    monkeypatch.setattr(on_dask, "_CONNECTING", 3)
    chunk: Any = "a chunk"
    with scheduler_process(tmp_path / "scheduler.json") as (scheduler, address):
        with on_dask.connected(address) as client, pytest.raises(CocorosimError, match="was lost on the way"):
            scheduler.kill()
            scheduler.wait()
            time.sleep(0.5)
            list(on_dask.run_on_dask([chunk], client, lambda: True))


def wait_for(happened: Callable[[], bool], process: subprocess.Popen[Any]) -> None:
    """Wait for something that a process does."""
    deadline = time.monotonic() + 120
    while not happened():
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.05)


@contextmanager
def scheduler_process(note: Path) -> Iterator[tuple[subprocess.Popen[bytes], str]]:
    """A scheduler without workers in a process of its own, and its address."""
    options = ["--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", str(note)]
    process = subprocess.Popen(
        [sys.executable, "-m", "distributed.cli.dask_scheduler", *options], stderr=subprocess.DEVNULL
    )
    try:
        wait_for(lambda: note.exists() and note.read_text("utf-8").endswith("}"), process)
        yield process, json.loads(note.read_text("utf-8"))["address"]
    finally:
        process.kill()
        process.wait()
