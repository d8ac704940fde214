"""Rows of a topic, sorted by their stamps, without duplicates and without rows that hold no number; all reported."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import BURSTS, SPACING
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE
from cocorosim_ros.diagnosis.evidence.topic_rows import TopicRows
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.counted import counted, either
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS

_EVEN = re.compile(r": \d+ readings( at \S+ Hz| in bunches, \S+ a second)?\.$")


@dataclass(frozen=True)
class Clean:
    """Rows in the order of their stamps; remarks: every change that was made, as a sentence."""

    rows: TopicRows
    remarks: tuple[str, ...]


def cleaned(rows: TopicRows) -> Clean:
    """Sort rows by stamp, and leave out duplicates and rows that hold no reading."""
    remarks: list[str] = []
    ordered = _in_order(rows, remarks)
    return Clean(_each_moment_once(_with_numbers(ordered, remarks), remarks), tuple(remarks))


def _in_order(rows: TopicRows, remarks: list[str]) -> TopicRows:
    back = np.flatnonzero(np.diff(rows.stamp_ns) < 0)
    if not back.size:
        return rows
    behind = np.maximum.accumulate(rows.stamp_ns) - rows.stamp_ns
    late = int(behind.argmax())
    after = (rows.stamp_ns[late] - rows.stamp_ns.min()) / NANOSECONDS
    places = "1 place" if back.size == 1 else f"{back.size} places"
    remarks.append(
        f"{rows.name}: time runs backwards at {places}, by up to {behind[late] / NANOSECONDS:.3g} s ({after:.1f} s "
        "after its first message); its messages were sorted by their stamps."
    )
    order = np.argsort(rows.stamp_ns, kind="stable")
    return rows.chosen(order)


def _with_numbers(rows: TopicRows, remarks: list[str]) -> TopicRows:
    values = np.where(np.isfinite(rows.values), rows.values, np.nan)
    given = np.isfinite(values)
    # A tracker that has lost its robot writes no place but often some attitude.
    good: Flags = np.asarray(given[:, PLANE].all(axis=1) if rows.topic == "pose" else given.any(axis=1))
    if len(rows.attitude) and rows.topic != "pose":
        good = good | np.isfinite(rows.attitude).all(axis=1)
    lost = np.flatnonzero(~good)
    if lost.size:
        first = (rows.stamp_ns[lost[0]] - rows.stamp_ns[0]) / NANOSECONDS
        remarks.append(
            f"{rows.name}: {lost.size} of {good.size} messages hold no number where the reading should be, first "
            f"{first:.1f} s after its first message; they were left out."
        )
    return replace(rows, values=values).chosen(good)


def _each_moment_once(rows: TopicRows, remarks: list[str]) -> TopicRows:
    count = len(rows.stamp_ns)
    if count < 2:
        return rows
    first = np.append(True, np.diff(rows.stamp_ns) != 0)
    leader = np.flatnonzero(first)[np.cumsum(first) - 1]
    copy, original = rows.values[~first], rows.values[leader[~first]]
    same = ((copy == original) | (np.isnan(copy) & np.isnan(original))).all(axis=1)
    equal, unequal = int(np.count_nonzero(same)), int(np.count_nonzero(~same))
    if equal:
        was = either(equal, "was recorded twice; it counts", "were recorded twice; each counts")
        remarks.append(f"{rows.name}: {counted(equal, 'message')} {was} once.")
    if unequal:
        remarks.append(
            f"{rows.name}: {counted(unequal, 'message')} {either(unequal, 'has', 'have')} the stamp of another one but "
            f"{either(unequal, 'says', 'say')} something else (two publishers?); the first of each was kept."
        )
    return rows.chosen(first)


def gaps_of(time: Floats) -> tuple[tuple[float, float], ...]:
    """Start and end [s] of every gap: a time without readings that is long beside their usual interval."""
    if len(time) < 3:
        return ()
    return tuple((float(time[k]), float(time[k + 1])) for k in np.flatnonzero(_is_long(np.diff(time))))


def _is_long(steps: Floats) -> Flags:
    """Tell of each interval (n,) [s] whether it is long beside the usual one."""
    return steps > max(SPACING.gap_intervals * float(np.median(steps)), SPACING.gap_seconds)


def timing_sentence(name: str, time: Floats) -> str:
    """A sentence about the rate, the evenness and the gaps of a recorded topic."""
    if len(time) < 3:
        return f"{name}: {len(time)} readings."
    first = _first_of_bunches(time)
    if len(first) < len(time):
        gaps = gaps_of(first)
        alive = float(first[-1] - first[0]) - sum(end - start for start, end in gaps)
        a_second = len(time) / len(first) * (len(first) - 1 - len(gaps)) / alive if alive > 0.0 else np.nan
        parts = [f"{len(time)} readings in bunches, {a_second:.3g} a second"]
        return f"{name}: {', '.join((*parts, *_of_gaps(first)))}."
    steps = np.diff(time)
    usual = float(np.median(steps))
    parts = [f"{len(time)} readings at {1.0 / usual:.3g} Hz"]
    jitter = 1.4826 * float(np.median(np.abs(steps - usual)))
    if jitter > SPACING.jitter * usual:
        parts.append(f"unevenly (jitter {1000.0 * jitter:.3g} ms)")
    return f"{name}: {', '.join((*parts, *_of_gaps(time)))}."


def _first_of_bunches(time: Floats) -> Floats:
    """Stamps of the first of the readings that writers of a topic give at once; all stamps if there is one writer.

    Intervals that are long beside the usual one are gaps if there are few of them; many are those between bunches.
    """
    steps = np.diff(time)
    long = _is_long(steps)
    mean = float(np.mean(steps[~long] if np.mean(long) < SPACING.many else steps))
    at_once = steps < BURSTS.at_once * mean
    return time[np.append(True, ~at_once)] if np.mean(at_once) > SPACING.bunched else time


def _of_gaps(time: Floats) -> tuple[str, ...]:
    """Words on the gaps between readings; () without any."""
    gaps = gaps_of(time)
    if not gaps:
        return ()
    longest = max(gaps, key=lambda gap: gap[1] - gap[0])
    times = "1 gap" if len(gaps) == 1 else f"{len(gaps)} gaps, the longest"
    return (f"{times} from {longest[0]:.1f} to {longest[1]:.1f} s",)


def is_noteworthy(remark: str) -> bool:
    """Tell whether a remark says more than the rate of a topic that was recorded without gaps, evenly or in bunches."""
    return _EVEN.search(remark) is None
