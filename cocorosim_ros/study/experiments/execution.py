"""Where chunks are calculated: in this process or in processes of this machine."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Generator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from typing import Any

import pyarrow as pa

from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.study.experiments.rows import Chunk, run_chunk

LOST_WORKERS = 5  # after so many deaths of workers in a row something is wrong
ASKED_EVERY = 0.2  # s
Going = Callable[[], bool]


def run_here(chunks: Sequence[Chunk], going: Going) -> Generator[pa.Table, None, None]:
    """The rows of each chunk, calculated in this process one after the other."""
    for chunk in chunks:
        if not going():
            return
        yield run_chunk(chunk)


def run_in_processes(chunks: Sequence[Chunk], workers: int, going: Going) -> Generator[pa.Table, None, None]:
    """The rows of each chunk as it is finished, from `workers` processes of this machine.

    A worker that dies is replaced and its chunks are calculated again. Raises CocorosimError if that goes on.
    """
    waiting, deaths = deque(chunks), 0
    while waiting and going():
        pool = ProcessPoolExecutor(workers, multiprocessing.get_context("spawn"), depend_on_parent)
        running: dict[Future[pa.Table], Chunk] = {}
        try:
            for rows in _feed(pool, waiting, running, workers, going):
                deaths = 0
                yield rows
        except BrokenProcessPool as error:
            waiting.extendleft(running.values())
            deaths += 1
            if deaths == LOST_WORKERS:
                raise ArgumentError(
                    f"{deaths} worker processes died one after the other, perhaps for lack of memory; "
                    "give fewer with 'workers'. What is finished is kept.",
                    "workers",
                ) from error
        finally:
            end_pool(pool)


def _feed(
    pool: ProcessPoolExecutor,
    waiting: deque[Chunk],
    running: dict[Future[pa.Table], Chunk],
    workers: int,
    going: Going,
) -> Generator[pa.Table, None, None]:
    while (waiting or running) and going():
        while waiting and len(running) < workers:
            future = pool.submit(run_chunk, waiting[0])  # which a broken pool refuses: the chunk must still wait then
            running[future] = waiting.popleft()
        finished, _ = wait(running, ASKED_EVERY, FIRST_COMPLETED)
        for future in finished:
            rows = future.result()
            del running[future]
            yield rows


def depend_on_parent() -> None:
    """Ctrl-C reaches every process of the terminal: the parent decides what ends, and its death ends the worker."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def end_pool(pool: ProcessPoolExecutor) -> list[int | None]:
    """End the workers at once, and give their exit codes: what they have not handed over will be calculated again."""
    processes = list((pool._processes or {}).values())
    manager: Any = pool._executor_manager_thread  # a thread, whatever the types of others say
    pool.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.terminate()
    if manager is not None:
        manager.join()  # it waits for the workers too, and of two that wait one may miss how they ended
    for process in processes:
        process.join()
    return [process.exitcode for process in processes]
