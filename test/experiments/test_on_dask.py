"""A Dask cluster gives the rows that one process gives, also when a worker is killed in the middle."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from cocorosim_ros.errors import CocorosimError

Write = Callable[..., str]
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
    from dask.distributed import Client

    from cocorosim_ros.experiments.design import load_design
    from cocorosim_ros.experiments.on_dask import run_on_dask
    from cocorosim_ros.experiments.rows import chunks, run_chunk

    work = list(chunks(load_design(design_file(replicates=6, duration="60 s")), set(), 1))
    expected = [run_chunk(chunk).drop_columns(["wall_seconds"]).to_pylist()[0] for chunk in work]
    found: list[dict[str, Any]] = []
    for table in run_on_dask(work, cluster.scheduler_address, lambda: True):
        if not found:
            with Client(cluster.scheduler_address, set_as_default=False) as client:
                victim = next(iter(client.run(os.getpid).values()))
            os.kill(victim, signal.SIGKILL)
        found += table.drop_columns(["wall_seconds"]).to_pylist()
    assert len(found) == 12
    assert sorted(found, key=lambda row: (row["group"], row["replicate"])) == expected


def test_nothing_more_is_asked_for_after_an_interruption(design_file: Write, cluster: Any) -> None:
    """As soon as it is told to stop, no more rows come."""
    from cocorosim_ros.experiments.design import load_design
    from cocorosim_ros.experiments.on_dask import run_on_dask
    from cocorosim_ros.experiments.rows import chunks

    work = list(chunks(load_design(design_file()), set(), 1))
    assert list(run_on_dask(work, cluster.scheduler_address, lambda: False)) == []


def test_no_scheduler_is_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    """An address where nobody answers is named."""
    from cocorosim_ros.experiments import on_dask

    monkeypatch.setattr(on_dask, "_CONNECTING", 1)
    with pytest.raises(CocorosimError, match="No Dask scheduler answers at 'tcp://127"):
        next(on_dask.run_on_dask([], "tcp://127.0.0.1:9", lambda: True))
