"""One clock for all streams of a recording: that of the header stamps, as far as these count from one zero.

Every message has two times: the header stamp, read from the clock of the instrument at the measurement, and the log
time, read from the clock of the recorder at the arrival. Their difference, the delay, shows where a clock counts from
another zero, jumps, or runs at another rate.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import CLOCKS
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.topic_rows import TopicRows
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS


@dataclass(frozen=True)
class Skew:
    """The rate of a topic's stamps against the recorder's clock, less the median of the recording; NaN if unknown."""

    rate: float = float("nan")  # s/s
    error: float = float("nan")  # standard deviation


def on_one_clock(topics: Sequence[TopicRows]) -> tuple[list[TopicRows], list[str]]:
    """Put the stamps of all topics of a recording on one clock; also give a sentence about every change.

    Stamps that differ by more than a second from those of the other topics, by the log times, are shifted by the
    difference. A single message with such a stamp is left out if the stamp is in the future or outside the recording.
    """
    if not topics:
        return [], []
    usual = _usual_delay([_early_delay(rows) for rows in topics if len(rows.stamp_ns)])
    remarks: list[str] = []
    shifted = [_shifted(rows, usual, remarks) for rows in topics]
    return [_without_strays(rows, usual, shifted, remarks) for rows in shifted], remarks


def are_of_one_clock(one: TopicRows, other: TopicRows) -> bool:
    """Tell whether two topics were stamped by clocks that count from one zero, by the log times; both as recorded."""
    return abs(_early_delay(one) - _early_delay(other)) <= CLOCKS.far


def clock_skews(topics: Sequence[TopicRows]) -> list[Skew]:
    """The rate of each topic's stamps by the log times, relative to the median of all topics."""
    found = [_skew(rows) for rows in topics]
    rates = [skew.rate for skew in found if np.isfinite(skew.rate)]
    usual = float(np.median(rates)) if rates else 0.0
    return [replace(skew, rate=skew.rate - usual) for skew in found]


def has_clock_of_commands(log: RobotLog, topic: str) -> bool:
    """Tell whether a stream was stamped by the clock of the commands: most of its stamps are stamps of commands too.

    Such rows of one table cannot run at two rates.
    """
    stamp, command = (np.round(time, 6) for time in (log.streams[topic].time, log.command_time))
    return len(stamp) > 1 and float(np.mean(np.isin(stamp, command))) >= CLOCKS.shared


def skew_sentence(name: str, skew: Skew) -> str:
    """A sentence about a clock that surely runs fast or slow; empty for any other clock."""
    if not (abs(skew.rate) > CLOCKS.sure * skew.error and abs(skew.rate) > CLOCKS.notable_skew):
        return ""
    return (
        f"{name}: its stamps run {abs(skew.rate) * 1e6:.0f} ppm {'fast' if skew.rate > 0.0 else 'slow'} against those "
        "of the other topics, by the log times."
    )


def _delay(rows: TopicRows) -> Floats:
    """Delay (n,) [s] from stamp to log time."""
    return np.asarray((rows.log_ns - rows.stamp_ns) / NANOSECONDS)


def _early_delay(rows: TopicRows) -> float:
    delay = _delay(rows)
    return float(np.quantile(delay[: max(CLOCKS.few, int(CLOCKS.early * len(delay)))], CLOCKS.prompt))


def _usual_delay(delays: Sequence[float]) -> float:
    """The delay that most topics share; among equally many, the smallest."""
    values = np.array(delays)
    near = np.abs(values[:, None] - values[None, :]) < CLOCKS.far
    votes = near.sum(axis=1)
    chosen = min(np.flatnonzero(votes == votes.max()), key=lambda index: abs(values[index]))
    return float(np.median(values[near[chosen]]))


def _shifted(rows: TopicRows, usual: float, remarks: list[str]) -> TopicRows:
    """Shift every long stretch of far stamps to where the log times of its messages put it."""
    if not len(rows.stamp_ns):
        return rows
    delay, stamps = _delay(rows), rows.stamp_ns.copy()
    early = _early_delay(rows) - usual
    if CLOCKS.notable < abs(early) <= CLOCKS.far:
        remarks.append(
            f"{rows.name}: its stamps are {abs(early):.2f} s {'behind' if early > 0 else 'ahead of'} the others' by "
            "the log times; they are used as they are."
        )
    for first, last in _stretches(delay):
        offset = float(np.quantile(delay[first:last], CLOCKS.prompt)) - usual
        if abs(offset) <= CLOCKS.far or last - first < CLOCKS.few:
            continue
        stamps[first:last] += round(offset * NANOSECONDS)
        where = "" if last - first == len(delay) else f" of messages {first + 1} to {last} of {len(delay)}"
        remarks.append(
            f"{rows.name}: the stamps{where} are {abs(offset):.6g} s {'behind' if offset > 0 else 'ahead of'} those "
            "of the other topics by the log times (another clock, or none); they were shifted by that, which leaves "
            "their latency uncertain."
        )
    return replace(rows, stamp_ns=stamps, shifted=float(np.median(stamps - rows.stamp_ns)) / NANOSECONDS)


def _stretches(delay: Floats) -> list[tuple[int, int]]:
    """Half-open ranges of messages between jumps of the delay; a few stray messages do not end a range."""
    breaks = [0, *(np.flatnonzero(np.abs(np.diff(delay)) > CLOCKS.far) + 1).tolist(), len(delay)]
    pieces = [(first, last) for first, last in pairwise(breaks) if last > first]
    merged: list[tuple[int, int]] = []
    for first, last in pieces:
        if merged and abs(np.median(delay[first:last]) - np.median(delay[slice(*merged[-1])])) <= CLOCKS.far:
            merged[-1] = (merged[-1][0], last)
        else:
            merged.append((first, last))
    return merged


def _without_strays(rows: TopicRows, usual: float, topics: Sequence[TopicRows], remarks: list[str]) -> TopicRows:
    delay = _delay(rows) - usual
    far = np.abs(delay) > CLOCKS.far
    if not far.any():
        return rows
    good = np.concatenate([other.stamp_ns[np.abs(_delay(other) - usual) <= CLOCKS.far] for other in topics])
    inside = (rows.stamp_ns >= good.min()) & (rows.stamp_ns <= good.max()) if good.size else np.ones_like(far)
    strays = far & ((delay < 0.0) | ~inside)
    if strays.any():
        remarks.append(
            f"{rows.name}: {np.count_nonzero(strays)} messages have stamps that are in the future or outside of the "
            "recording; they were left out."
        )
    return rows.chosen(~strays)


def _skew(rows: TopicRows) -> Skew:
    """The slope of the prompt messages' delay over time; unknown where log times are copies of the stamps."""
    count = len(rows.stamp_ns)
    span = (rows.log_ns.max() - rows.log_ns.min()) / NANOSECONDS if count else 0.0
    if count < CLOCKS.skew_blocks * CLOCKS.fewest_in_block or span < CLOCKS.shortest:
        return Skew()
    delay = _delay(rows) - float(np.median(_delay(rows)))
    if np.ptp(delay) < CLOCKS.same_delay:
        return Skew()
    time = (rows.log_ns - rows.log_ns[0]) / NANOSECONDS
    blocks = np.array_split(np.arange(count), CLOCKS.skew_blocks)
    moment = np.array([time[block].mean() for block in blocks])
    prompt = np.array([np.quantile(delay[block], CLOCKS.prompt) for block in blocks])
    moment = moment - moment.mean()
    spread = float((moment**2).sum())
    slope = float((moment * prompt).sum()) / spread
    left = prompt - prompt.mean() - slope * moment
    return Skew(-slope, float(np.sqrt((left**2).sum() / (CLOCKS.skew_blocks - 2) / spread)))
