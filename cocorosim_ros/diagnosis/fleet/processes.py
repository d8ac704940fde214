"""Work in processes of this machine, each with one job at a time, so that a death costs no other job."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections import deque
from collections.abc import Callable, Generator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, field
from typing import Generic, TypeVar

from cocorosim_ros.diagnosis.criteria.fleet import PROCESSES
from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.study.experiments.execution import ASKED_EVERY, Going, depend_on_parent, end_pool

A = TypeVar("A")
B = TypeVar("B")


@dataclass(frozen=True)
class Done(Generic[A, B]):
    """A job and its result; None if every process that had it died. ended: how the last one ended, if one did."""

    job: A
    result: B | None
    attempts: int
    ended: str


@dataclass
class _Lane(Generic[A, B]):
    """One process at a time, and the job that it has."""

    pool: ProcessPoolExecutor | None = None
    future: Future[B] | None = None
    waiting: _Waiting[A] | None = None


@dataclass
class _Waiting(Generic[A]):
    job: A
    attempts: int = 0
    ended: str = ""


@dataclass
class _Lanes(Generic[A, B]):
    work: Callable[[A], B]
    waiting: deque[_Waiting[A]]
    lanes: list[_Lane[A, B]] = field(default_factory=list)
    deaths: int = 0

    def fill(self) -> None:
        """Give every idle process a job."""
        for lane in self.lanes:
            if lane.future is None and self.waiting:
                if lane.pool is None:
                    lane.pool = ProcessPoolExecutor(1, multiprocessing.get_context("spawn"), depend_on_parent)
                try:
                    lane.future = lane.pool.submit(self.work, self.waiting[0].job)
                except BrokenProcessPool:  # it died with nothing to do, which counts against no job
                    _ended(lane)
                    continue
                lane.waiting = self.waiting.popleft()

    def finished(self, lane: _Lane[A, B]) -> Done[A, B] | None:
        """Take the result of a process that has ended its job; None if it died and the job is tried once more."""
        future, mine = lane.future, lane.waiting
        if future is None or mine is None or not future.done():
            return None
        lane.future = lane.waiting = None
        mine.attempts += 1
        try:
            result = future.result()
        except BrokenProcessPool as error:
            mine.ended = _ended(lane)
            self.deaths += 1
            if self.deaths == PROCESSES.deaths_in_a_row:
                raise ArgumentError(
                    f"{self.deaths} worker processes died one after the other, perhaps for lack of memory; give fewer "
                    "with 'workers'. What is finished is kept.",
                    "workers",
                ) from error
            if mine.attempts < PROCESSES.attempts:
                self.waiting.appendleft(mine)
                return None
            return Done(mine.job, None, mine.attempts, mine.ended)
        self.deaths = 0
        return Done(mine.job, result, mine.attempts, mine.ended)


def in_processes(
    work: Callable[[A], B], jobs: Sequence[A], workers: int, going: Going
) -> Generator[Done[A, B], None, None]:
    """Call `work` with each job in one of so many processes, and yield each as it is finished.

    A process that dies (killed, or out of memory) is replaced; its job is tried once more, then given up with no
    result. `going` is asked now and then; when it says no, the processes are ended and their jobs are lost. Raises
    ArgumentError if processes go on dying.
    """
    # Processes of their own would fight for the same processors in OpenBLAS; read when NumPy is loaded there.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    all_lanes: _Lanes[A, B] = _Lanes(work, deque(map(_Waiting, jobs)), [_Lane() for _ in range(workers)])
    try:
        while (all_lanes.waiting or any(lane.future for lane in all_lanes.lanes)) and going():
            all_lanes.fill()
            wait([lane.future for lane in all_lanes.lanes if lane.future], ASKED_EVERY, FIRST_COMPLETED)
            for lane in all_lanes.lanes:
                done = all_lanes.finished(lane)
                if done is not None:
                    yield done
    finally:
        for lane in all_lanes.lanes:
            if lane.pool is not None:
                end_pool(lane.pool)


def _ended(lane: _Lane[A, B]) -> str:
    """End what is left of a broken process, and say how it ended."""
    pool, lane.pool = lane.pool, None
    return _how(end_pool(pool)) if pool is not None else ""


def _how(codes: Sequence[int | None]) -> str:
    code = next((each for each in codes if each), None)
    if code is None:
        return "ended"
    if code >= 0:
        return f"ended with status {code}"
    try:
        return f"was killed by {signal.Signals(-code).name}"
    except ValueError:
        return f"was killed by signal {-code}"
