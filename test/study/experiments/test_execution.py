"""Chunks in processes of this machine: none is lost, whenever the pool breaks."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool
from typing import Any

import pytest

from cocorosim_ros.study.experiments import execution


class FakePool:
    """Gives every chunk back as its own rows; the first one made breaks when a third chunk is given to it."""

    made = 0
    _processes: dict[int, Any] | None = None
    _executor_manager_thread = None

    def __init__(self, *_: Any) -> None:
        FakePool.made += 1
        self._left = 2 if FakePool.made == 1 else 100

    def submit(self, _: Callable[..., Any], chunk: Any) -> Future[Any]:
        """A future that is finished."""
        if self._left == 0:
            raise BrokenProcessPool("a worker died")
        self._left -= 1
        future: Future[Any] = Future()
        future.set_result(chunk)
        return future

    def shutdown(self, **_: Any) -> None:
        """Nothing is left behind."""


def test_a_pool_that_is_broken_already_loses_no_chunk(monkeypatch: pytest.MonkeyPatch) -> None:
    """The pool breaks while the third of five chunks is handed to it: all five come, each once."""
    monkeypatch.setattr(FakePool, "made", 0)
    monkeypatch.setattr(execution, "ProcessPoolExecutor", FakePool)
    work: Any = ["a", "b", "c", "d", "e"]
    assert sorted(execution.run_in_processes(work, 2, lambda: True)) == work
    assert FakePool.made == 2
