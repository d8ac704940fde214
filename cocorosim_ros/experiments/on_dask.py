"""Chunks on a Dask cluster: the same chunks, calculated by its workers and handed back to this process.

Workers need the package and nothing else: neither the design's files nor the folder of the results.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import pyarrow as pa
from dask.distributed import Client
from dask.distributed import wait as wait_on_dask

from cocorosim_ros.errors import CocorosimError
from cocorosim_ros.experiments.execution import ASKED_EVERY, LOST_WORKERS, Going
from cocorosim_ros.experiments.rows import Chunk, run_chunk

_CONNECTING = 20  # s


def run_on_dask(chunks: Sequence[Chunk], scheduler: str, going: Going) -> Iterator[pa.Table]:
    """The rows of each chunk as it is finished, from the workers of a Dask cluster.

    Chunks of a worker that dies are calculated again by others. Raises CocorosimError if there is no scheduler.
    """
    try:
        client = Client(scheduler, timeout=_CONNECTING)
    except (OSError, TimeoutError, ValueError) as error:
        raise CocorosimError(
            f"No Dask scheduler answers at '{scheduler}'; start one with 'dask scheduler' and give its address."
        ) from error
    futures: list[Any] = []
    try:
        futures = [client.submit(run_chunk, chunk, pure=False, retries=LOST_WORKERS) for chunk in chunks]
        yield from _as_finished(futures, going)
    finally:
        client.cancel(futures)
        client.close()


def _as_finished(futures: list[Any], going: Going) -> Iterator[pa.Table]:
    left = list(futures)
    while left and going():
        try:
            wait_on_dask(left, ASKED_EVERY, "FIRST_COMPLETED")
        except TimeoutError:
            continue
        for future in [future for future in left if future.done()]:
            left.remove(future)
            yield future.result()
            future.release()
