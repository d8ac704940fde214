"""Many recordings with something concealed, their envelopes, and the ledger of their seals."""

from __future__ import annotations

import multiprocessing
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat
from pathlib import Path
from typing import Any

from concealer.prior import Wish
from concealer.recording import make
from concealer.seal import publish
from concealer.six_degrees.makes import MAKES
from concealer.six_degrees.recording import make as make_with_six


def conceal(out: Path, numbers: dict[str, Any], seed: int, indices: range, wish: Wish, jobs: int = 1) -> Iterator[str]:
    """Names of the recordings as they are finished; the ledger is written after the last one.

    Numbers are those of a prior: of a vehicle with six degrees of freedom if they say so, as by `robot: rov`.

    Raises FileExistsError if the folder holds a trial already.
    """
    for folder in ("recordings", "envelopes"):
        (out / folder).mkdir(parents=True)
    entries: dict[str, dict[str, str]] = {}
    fixed = (repeat(seed), repeat(out), repeat(numbers), repeat(wish))
    make_one = make_with_six if numbers.get("robot") in MAKES else make
    if jobs == 1:
        for entry in map(make_one, indices, *fixed):
            entries.update([entry])
            yield entry[0]
    else:
        with ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn")) as pool:
            for entry in pool.map(make_one, indices, *fixed):
                entries.update([entry])
                yield entry[0]
    publish(out, entries)
