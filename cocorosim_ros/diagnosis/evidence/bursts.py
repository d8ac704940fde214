"""Stamps of readings that were taken evenly but delivered in bursts, put back to the moment of the reading.

A camera makes such bursts if the loop that fetches its images is slower than the camera: two readings arrive at once,
then one, and each is stamped at its delivery; where the loop stalls, a dozen arrive at once. A robot that turns at
15 rad/s is then shown at an angle that is wrong by a tenth of a radian. No reading is delivered before it is taken, and
two readings are at least a period apart; the latest moment that all later readings allow is therefore taken.

That moment is only a bound where readings of a burst were lost on their way: what is left of ten may have been taken
over all the time of the stall. Such readings are left out but for the last one, which came as it was taken.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import BURSTS
from cocorosim_ros.diagnosis.evidence.topic_rows import COMMAND, TopicRows
from cocorosim_ros.foundation.arrays import Flags
from cocorosim_ros.wire.cdr.stamped_numbers import Stamps


def as_taken(rows: TopicRows) -> tuple[TopicRows, tuple[str, ...]]:
    """Put the stamps of rows that came in bursts back to the moments of the readings, and give a sentence about it."""
    if rows.topic == COMMAND or len(rows.stamp_ns) <= BURSTS.in_a_row:
        return rows, ()
    steps = np.diff(rows.stamp_ns)
    share = float(np.mean(steps < BURSTS.at_once * np.mean(steps)))
    if share < BURSTS.many:
        return rows, ()
    period = _period(rows.stamp_ns)
    taken = _taken(rows.stamp_ns, period)
    uncertain = _of_bursts_that_lack(rows.stamp_ns, taken, period)
    early = 1e-6 * (rows.stamp_ns - taken)[~uncertain]
    sentence = (
        f"{rows.name}: {100.0 * share:.0f} % of the readings come at once with the one before; each was put at the "
        f"latest moment at which it can have been taken, {early.mean():.2g} ms before its stamp on average and at "
        f"most {early.max():.0f} ms."
    )
    if uncertain.any():
        sentence += (
            f" {np.count_nonzero(uncertain)} of {len(uncertain)} readings were left out: readings of their bursts are "
            "lost, so that the time at which each was taken is not known."
        )
    return replace(rows, stamp_ns=taken).chosen(~uncertain), (sentence,)


def _period(stamp_ns: Stamps) -> int:
    """Time [ns] from one reading to the next where none is lost."""
    rows = stamp_ns[BURSTS.in_a_row :] - stamp_ns[: -BURSTS.in_a_row]
    return int(np.quantile(rows, BURSTS.swiftest) / BURSTS.in_a_row)


def _taken(stamp_ns: Stamps, period: int) -> Stamps:
    """Latest moments [ns] at which readings can have been taken, if two are at least a period apart."""
    place = np.arange(len(stamp_ns)) * period
    return np.asarray(np.minimum.accumulate((stamp_ns - place)[::-1])[::-1] + place)


def _of_bursts_that_lack(stamp_ns: Stamps, taken: Stamps, period: int) -> Flags:
    """Tell of each reading whether it came in a burst from which several are missing, and not as the last of it."""
    follows = np.diff(stamp_ns) < BURSTS.together * period
    first, last = ~np.append(False, follows), ~np.append(follows, False)
    spare = np.diff(taken, prepend=taken[0]) - period
    lacking = first & (spare > BURSTS.lacking * period)
    burst = np.cumsum(first) - 1
    return np.asarray(lacking[first][burst] & ~last)
