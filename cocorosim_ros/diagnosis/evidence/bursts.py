"""Readings that were taken evenly but delivered in bursts: their stamps are put back to when they were taken.

A camera whose images are fetched by a loop slower than itself is one: two readings come at once, then one, and each
bears the time of its delivery; where the loop stalls, a dozen come at once. What turns at 15 rad/s is then shown at a
wrong angle by a tenth of a radian. No reading is delivered before it was taken, and one is taken at least a period
after the other: so each was taken no later than any that follows allows.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.topic_rows import COMMAND, TopicRows
from cocorosim_ros.wire.cdr.stamped_numbers import Stamps

AT_ONCE = 0.1  # of the mean interval: no instrument takes two readings so close
MANY = 0.05  # share of intervals that are so short, from which readings come in bursts
IN_A_ROW = 20  # readings over which the period is taken
SWIFTEST = 0.05  # quantile of what they take: the others have lost readings among them


def as_taken(rows: TopicRows) -> tuple[TopicRows, tuple[str, ...]]:
    """The rows with the stamps of their taking, and a sentence that says so, if they came in bursts."""
    if rows.topic == COMMAND or len(rows.stamp_ns) <= IN_A_ROW:
        return rows, ()
    steps = np.diff(rows.stamp_ns)
    share = float(np.mean(steps < AT_ONCE * np.mean(steps)))
    if share < MANY:
        return rows, ()
    taken = _taken(rows.stamp_ns)
    early = 1e-6 * (rows.stamp_ns - taken)
    sentence = (
        f"{rows.name}: {100.0 * share:.0f} % of the readings come at once with the one before; each was put at the "
        f"latest moment at which it can have been taken, {early.mean():.2g} ms before its stamp on average and at "
        f"most {early.max():.0f} ms."
    )
    return replace(rows, stamp_ns=taken), (sentence,)


def _taken(stamp_ns: Stamps) -> Stamps:
    rows = stamp_ns[IN_A_ROW:] - stamp_ns[:-IN_A_ROW]
    place = np.arange(len(stamp_ns)) * int(np.quantile(rows, SWIFTEST) / IN_A_ROW)
    return np.asarray(np.minimum.accumulate((stamp_ns - place)[::-1])[::-1] + place)
