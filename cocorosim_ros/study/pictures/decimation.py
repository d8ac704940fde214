"""Fewer points for a picture, in ways that can be said in its caption."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers

MOST_GROUPS = 1200
"""Moments beyond which a curve shows groups of moments: their mean and their range."""

_GAP_IN_INTERVALS = 3
_SHORTEST_GAP_NS = 1_000_000_000


@dataclass(frozen=True)
class Envelope:
    """What a series does in successive groups of moments; each (groups,). NaN where a group has no value."""

    time: Floats
    """Mean time of the group's moments."""
    low: Floats
    mean: Floats
    high: Floats
    per_group: int
    """Moments in one group (fewer in the last)."""


def envelope(time: Floats, values: Floats, most: int) -> Envelope:
    """Lowest, mean and highest of at most `most` groups of equally many successive moments; (t,) each.

    No extreme is lost: the lowest and the highest value of the series are those of the groups.
    """
    per_group = max(1, -(-time.size // most))
    starts = np.arange(0, time.size, per_group)
    known = np.isfinite(values)
    count = np.add.reduceat(known.astype(float), starts)
    nobody = count == 0
    low = np.minimum.reduceat(np.where(known, values, np.inf), starts)
    high = np.maximum.reduceat(np.where(known, values, -np.inf), starts)
    total = np.add.reduceat(np.where(known, values, 0.0), starts)
    members = np.diff(np.append(starts, time.size))
    return Envelope(
        np.add.reduceat(time, starts) / members,
        np.where(nobody, np.nan, low),
        np.where(nobody, np.nan, total / np.maximum(count, 1.0)),
        np.where(nobody, np.nan, high),
        per_group,
    )


def every_nth(stamp_ns: Integers, most: int) -> tuple[Integers, int]:
    """Indices of every n-th moment and of the last one, and n, so that about `most` of them are left."""
    step = max(1, -(-stamp_ns.size // most))
    kept = np.arange(0, stamp_ns.size, step)
    if stamp_ns.size and kept[-1] != stamp_ns.size - 1:
        kept = np.append(kept, stamp_ns.size - 1)
    return kept, step


def with_breaks(stamp_ns: Integers, points: Floats) -> Floats:
    """The points (t, d) with a row of NaN in each gap, so that no line is drawn across it."""
    gaps = np.flatnonzero(np.diff(stamp_ns) > longest_interval(stamp_ns))
    return np.insert(points, gaps + 1, np.nan, axis=0)


def longest_interval(stamp_ns: Integers) -> float:
    """Time [ns] between two poses beyond which it is a gap: three median intervals, and one second at least."""
    if stamp_ns.size < 2:
        return float(_SHORTEST_GAP_NS)
    return max(_SHORTEST_GAP_NS, _GAP_IN_INTERVALS * float(np.median(np.diff(stamp_ns))))
