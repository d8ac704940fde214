"""Stamps of readings that were taken evenly but delivered in bursts, put back to the moment of the reading.

A camera makes such bursts if the loop that fetches its images is slower than the camera: two readings arrive at once,
then one, and each is stamped at its delivery; where the loop stalls, a dozen arrive at once. A robot that turns at
15 rad/s is then shown at an angle that is wrong by a tenth of a radian. No reading is delivered before it is taken, and
two readings are at least a period apart; the latest moment that all later readings allow is therefore taken.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import BURSTS
from cocorosim_ros.diagnosis.evidence.topic_rows import COMMAND, TopicRows
from cocorosim_ros.wire.cdr.stamped_numbers import Stamps


def as_taken(rows: TopicRows) -> tuple[TopicRows, tuple[str, ...]]:
    """Put the stamps of rows that came in bursts back to the moments of the readings, and give a sentence about it."""
    if rows.topic == COMMAND or len(rows.stamp_ns) <= BURSTS.in_a_row:
        return rows, ()
    steps = np.diff(rows.stamp_ns)
    share = float(np.mean(steps < BURSTS.at_once * np.mean(steps)))
    if share < BURSTS.many:
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
    rows = stamp_ns[BURSTS.in_a_row :] - stamp_ns[: -BURSTS.in_a_row]
    place = np.arange(len(stamp_ns)) * int(np.quantile(rows, BURSTS.swiftest) / BURSTS.in_a_row)
    return np.asarray(np.minimum.accumulate((stamp_ns - place)[::-1])[::-1] + place)
