"""One clock for all streams of a recording: their header stamps, where these count from one zero.

Every message has two times: its header stamp, when it was measured by the clock of whoever measured, and its log time,
when it reached the recorder. The difference of the two tells when a clock counts from another zero, jumps or runs at
another rate.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from cocorosim_ros.diagnosis.evidence.topic_rows import TopicRows
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS

FAR = 1.0  # s: what no transport and no latency explains
NOTABLE = 0.2  # s: said, and left to the diagnosis
FEW = 10  # messages in a row with stamps far off are faults of these messages, not another clock
EARLY = 0.1  # share of the messages from which the offset is read, before a skew shows
PROMPT = 0.1  # quantile of the delays: those of messages that did not have to wait
NOTABLE_SKEW, SURE = 2e-5, 6.0  # s/s, as much as cheap quartz is off; standard deviations
SKEW_BLOCKS, FEWEST_IN_BLOCK, SHORTEST = 20, 10, 30.0  # of a skew estimate; s


@dataclass(frozen=True)
class Skew:
    """How much faster the stamps run than the recorder's clock, less what is usual in the recording; NaN if unknown."""

    rate: float = float("nan")  # s/s
    error: float = float("nan")  # standard deviation


def on_one_clock(topics: Sequence[TopicRows]) -> tuple[list[TopicRows], list[str]]:
    """The topics of one recording with stamps on one clock, and what had to be done for it, in sentences.

    Stamps that are more than a second off the others', by the log times, are shifted by that. Single messages with
    such stamps are left out if their stamp is in the future or outside the recording.
    """
    if not topics:
        return [], []
    usual = _usual_delay([_early_delay(rows) for rows in topics if len(rows.stamp_ns)])
    remarks: list[str] = []
    shifted = [_shifted(rows, usual, remarks) for rows in topics]
    return [_without_strays(rows, usual, shifted, remarks) for rows in shifted], remarks


def clock_skews(topics: Sequence[TopicRows]) -> list[Skew]:
    """How fast each topic's stamps run by the log times, relative to the median of all."""
    found = [_skew(rows) for rows in topics]
    rates = [skew.rate for skew in found if np.isfinite(skew.rate)]
    usual = float(np.median(rates)) if rates else 0.0
    return [replace(skew, rate=skew.rate - usual) for skew in found]


def skew_sentence(name: str, skew: Skew) -> str:
    """What is to be said of a clock that surely runs fast or slow; empty if it does not."""
    if not (abs(skew.rate) > SURE * skew.error and abs(skew.rate) > NOTABLE_SKEW):
        return ""
    return (
        f"{name}: its stamps run {abs(skew.rate) * 1e6:.0f} ppm {'fast' if skew.rate > 0.0 else 'slow'} against those "
        "of the other topics, by the log times."
    )


def _delay(rows: TopicRows) -> Floats:
    """(n,) [s] from stamp to log."""
    return np.asarray((rows.log_ns - rows.stamp_ns) / NANOSECONDS)


def _early_delay(rows: TopicRows) -> float:
    delay = _delay(rows)
    return float(np.quantile(delay[: max(FEW, int(EARLY * len(delay)))], PROMPT))


def _usual_delay(delays: Sequence[float]) -> float:
    """The delay that most topics share; among equally many, the smallest."""
    values = np.array(delays)
    near = np.abs(values[:, None] - values[None, :]) < FAR
    votes = near.sum(axis=1)
    chosen = min(np.flatnonzero(votes == votes.max()), key=lambda index: abs(values[index]))
    return float(np.median(values[near[chosen]]))


def _shifted(rows: TopicRows, usual: float, remarks: list[str]) -> TopicRows:
    """The topic with every long stretch of far stamps put where its log times say."""
    if not len(rows.stamp_ns):
        return rows
    delay, stamps = _delay(rows), rows.stamp_ns.copy()
    early = _early_delay(rows) - usual
    if NOTABLE < abs(early) <= FAR:
        remarks.append(
            f"{rows.name}: its stamps are {abs(early):.2f} s {'behind' if early > 0 else 'ahead of'} the others' by "
            "the log times; they are used as they are."
        )
    for first, last in _stretches(delay):
        offset = float(np.quantile(delay[first:last], PROMPT)) - usual
        if abs(offset) <= FAR or last - first < FEW:
            continue
        stamps[first:last] += round(offset * NANOSECONDS)
        where = "" if last - first == len(delay) else f" of messages {first + 1} to {last} of {len(delay)}"
        remarks.append(
            f"{rows.name}: the stamps{where} are {abs(offset):.6g} s {'behind' if offset > 0 else 'ahead of'} those "
            "of the other topics by the log times (another clock, or none); they were shifted by that, which leaves "
            "their latency uncertain."
        )
    return replace(rows, stamp_ns=stamps)


def _stretches(delay: Floats) -> list[tuple[int, int]]:
    """Half-open ranges of messages between jumps of the delay; a few strays do not end one."""
    breaks = [0, *(np.flatnonzero(np.abs(np.diff(delay)) > FAR) + 1).tolist(), len(delay)]
    pieces = [(first, last) for first, last in pairwise(breaks) if last > first]
    merged: list[tuple[int, int]] = []
    for first, last in pieces:
        if merged and abs(np.median(delay[first:last]) - np.median(delay[slice(*merged[-1])])) <= FAR:
            merged[-1] = (merged[-1][0], last)
        else:
            merged.append((first, last))
    return merged


def _without_strays(rows: TopicRows, usual: float, topics: Sequence[TopicRows], remarks: list[str]) -> TopicRows:
    delay = _delay(rows) - usual
    far = np.abs(delay) > FAR
    if not far.any():
        return rows
    good = np.concatenate([other.stamp_ns[np.abs(_delay(other) - usual) <= FAR] for other in topics])
    inside = (rows.stamp_ns >= good.min()) & (rows.stamp_ns <= good.max()) if good.size else np.ones_like(far)
    strays = far & ((delay < 0.0) | ~inside)
    if strays.any():
        remarks.append(
            f"{rows.name}: {np.count_nonzero(strays)} messages have stamps that are in the future or outside of the "
            "recording; they were left out."
        )
    return _selected(rows, ~strays)


def _selected(rows: TopicRows, chosen: Flags) -> TopicRows:
    return replace(rows, stamp_ns=rows.stamp_ns[chosen], log_ns=rows.log_ns[chosen], values=rows.values[chosen])


def _skew(rows: TopicRows) -> Skew:
    """From the slope of the prompt messages' delay over time; unknown where log times are made from stamps."""
    count = len(rows.stamp_ns)
    span = (rows.log_ns.max() - rows.log_ns.min()) / NANOSECONDS if count else 0.0
    if count < SKEW_BLOCKS * FEWEST_IN_BLOCK or span < SHORTEST:
        return Skew()
    delay = _delay(rows) - float(np.median(_delay(rows)))
    if np.ptp(delay) < 1e-6:
        return Skew()
    time = (rows.log_ns - rows.log_ns[0]) / NANOSECONDS
    blocks = np.array_split(np.arange(count), SKEW_BLOCKS)
    moment = np.array([time[block].mean() for block in blocks])
    prompt = np.array([np.quantile(delay[block], PROMPT) for block in blocks])
    moment = moment - moment.mean()
    spread = float((moment**2).sum())
    slope = float((moment * prompt).sum()) / spread
    left = prompt - prompt.mean() - slope * moment
    return Skew(-slope, float(np.sqrt((left**2).sum() / (SKEW_BLOCKS - 2) / spread)))
