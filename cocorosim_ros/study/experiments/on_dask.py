"""Chunks on a Dask cluster: the same chunks, calculated by its workers and handed back to this process.

Scheduler and workers need the package as it is here, with what it needs itself, but neither the design's files nor the
folder of the results. A controller of the user's own has to lie at the same path there.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from typing import Any, TypeVar

import pyarrow as pa
from dask.distributed import Client, KilledWorker
from dask.distributed import wait as wait_on_dask
from distributed.client import ClosedClientError

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.experiments.execution import ASKED_EVERY, LOST_WORKERS, Going
from cocorosim_ros.study.experiments.rows import Chunk, run_chunk

A = TypeVar("A")
B = TypeVar("B")
_CONNECTING = 20  # s
_OTHER_SET_UP = "Error during deserialization"  # how Dask's scheduler begins when it cannot load what it is given


@contextmanager
def connected(scheduler: str) -> Iterator[Any]:
    """A client of the scheduler at this address. Raises CocorosimError if none answers."""
    # A scheduler that is lost is said in one sentence; Dask would log the tracebacks of its own attempts as well.
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
    try:
        client = Client(scheduler, timeout=_CONNECTING)
    except (OSError, TimeoutError, ValueError) as error:
        raise CocorosimError(
            f"No Dask scheduler answers at '{scheduler}'; start one with 'dask scheduler' and give its address."
        ) from error
    with client:
        yield client


def run_on_dask(chunks: Sequence[Chunk], client: Any, going: Going) -> Generator[pa.Table, None, None]:
    """The rows of each chunk as it is finished, from the workers of a client's cluster.

    Chunks of a worker that dies are calculated again by others. Raises CocorosimError if that goes on, if the
    scheduler is lost or if the package cannot be loaded there.
    """
    for _, rows in work_on_dask(run_chunk, chunks, client, going):
        yield rows


def work_on_dask(
    work: Callable[[A], B], jobs: Sequence[A], client: Any, going: Going, instead: Callable[[A], B] | None = None
) -> Generator[tuple[A, B], None, None]:
    """Each job with what `work` makes of it on a cluster, as it is finished.

    instead: what a job gives over which Dask has lost worker after worker; None if that ends all. Raises
    CocorosimError as `run_on_dask` does.
    """
    futures: dict[Any, A] = {}
    address = client.scheduler.address
    try:
        futures = {client.submit(work, job, pure=False, retries=LOST_WORKERS): job for job in jobs}
        yield from _as_finished(futures, going, instead)
    except (CancelledError, ClosedClientError, KilledWorker, ImportError, RuntimeError) as error:
        what = _what_happened(error)
        if not what:
            raise
        raise CocorosimError(f"The Dask scheduler at '{address}' {what}. What is finished is kept.") from error
    finally:
        with suppress(ClosedClientError):  # a client that has noticed the loss first has closed itself
            client.cancel(list(futures))


def _what_happened(error: Exception) -> str:
    """What became of the scheduler or its workers and what to do; nothing if the error is none of theirs."""
    if isinstance(error, CancelledError | ClosedClientError):
        return "was lost on the way; start it and its workers again and give the same command with its address"
    if isinstance(error, KilledWorker):
        return (
            "has lost worker after worker over the same runs, perhaps for lack of memory; give workers more of it and "
            "the same command again"
        )
    if isinstance(error, ImportError) or str(error).startswith(_OTHER_SET_UP):
        reason = " ".join(str(error).split())
        return f"or a worker of it cannot load the package ({reason}); install there what is installed here"
    return ""


def _as_finished(
    futures: Mapping[Any, A], going: Going, instead: Callable[[A], B] | None
) -> Generator[tuple[A, B], None, None]:
    left = list(futures)
    while left and going():
        try:
            wait_on_dask(left, ASKED_EVERY, "FIRST_COMPLETED")
        except TimeoutError:
            continue
        for future in [future for future in left if future.done()]:
            left.remove(future)
            yield futures[future], _result(future, futures[future], instead)
            future.release()


def _result(future: Any, job: A, instead: Callable[[A], B] | None) -> B:
    try:
        result: B = future.result()
    except KilledWorker:
        if instead is None:
            raise
        return instead(job)
    return result
