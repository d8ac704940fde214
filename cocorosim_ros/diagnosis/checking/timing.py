"""Clocks that run backwards, stand at zero, or differ; rates that drop and gaps."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from cocorosim_ros.diagnosis.checking.finding import Kind, Oddity
from cocorosim_ros.diagnosis.checking.topic_log import TopicLog
from cocorosim_ros.diagnosis.criteria.checking import CHECKING
from cocorosim_ros.diagnosis.evidence.cleaning import cleaned, gaps_of
from cocorosim_ros.diagnosis.evidence.clocks import clock_skews, on_one_clock, skew_sentence
from cocorosim_ros.foundation.arrays import Floats

Gaps = Sequence[tuple[float, float]]
"""Start and end [s] of times without messages."""
_LATCHED = ("/tf_static", "/robot_description")
_ALWAYS_AT_ZERO = ("visualization_msgs/msg/Marker", "visualization_msgs/msg/MarkerArray")
"""Types of which a stamp of zero says that they hold at any time: viewers take the latest transform for them."""


def check_timing(topics: Sequence[TopicLog]) -> Iterator[Oddity]:
    """Look at stamps and times of recording."""
    for topic in topics:
        yield from _zero_stamps(topic)
        yield from _rate(topic)
    moving = [topic for topic in topics if topic.name not in _LATCHED and topic.stamp_ns is not None]
    rows = [each for each in (topic.rows(_stamped(topic)) for topic in moving) if len(each.stamp_ns)]
    on_one, remarks = on_one_clock(rows)
    for remark in remarks:
        yield Oddity("clock", remark.partition(":")[0], _first_clause(remark))
    for each, skew in zip(on_one, clock_skews(on_one), strict=True):
        if sentence := skew_sentence(each.name, skew):
            yield Oddity("clock", each.topic, sentence)
        if each.topic in ("/tf", "/clock"):  # several publishers by right; simulated time may be repeated
            continue
        for remark in cleaned(each).remarks:
            kind: Kind = "values" if "hold no number" in remark else "stamps"
            yield Oddity(kind, each.topic, _first_clause(remark))


def _stamped(topic: TopicLog) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    return np.asarray(topic.stamp_ns != 0)


def _first_clause(remark: str) -> str:
    """Leave out of a remark what a diagnosis does about it."""
    return f"{remark.partition(';')[0].rstrip('.')}."


def _zero_stamps(topic: TopicLog) -> Iterator[Oddity]:
    if topic.stamp_ns is None or topic.name in _LATCHED or topic.type_name in _ALWAYS_AT_ZERO:
        return
    zero = int(np.count_nonzero(topic.stamp_ns == 0))
    every = len(topic.stamp_ns)
    if zero == 0 or (zero == 1 and every > 1):  # a simulation may begin at zero
        return
    which = "all" if zero == every else f"{zero} of {every}"
    yield Oddity(
        "stamps", topic.name, f"{topic.name}: {which} messages have the stamp zero; their publisher does not set it."
    )


def _rate(topic: TopicLog) -> Iterator[Oddity]:
    if len(topic.log_ns) < CHECKING.fewest or topic.name in _LATCHED:
        return
    time = np.sort(topic.time())
    steps = np.diff(time)
    usual = float(np.median(steps))
    if usual <= 0.0 or float(np.median(np.abs(steps - usual))) > CHECKING.even * usual:
        return  # what comes when something happens has no rate
    gaps = gaps_of(time)
    if gaps:
        start, end = max(gaps, key=lambda gap: gap[1] - gap[0])
        several = "a gap" if len(gaps) == 1 else f"{len(gaps)} gaps, the longest"
        words = f"{several} from {start:.1f} to {end:.1f} s, though it comes at {1.0 / usual:.3g} Hz"
        yield Oddity("rate", topic.name, f"{topic.name}: {words}.")
    slow = _slow(time, usual, gaps)
    if slow is not None:
        first, last, rate = slow
        yield Oddity(
            "rate",
            topic.name,
            f"{topic.name}: its rate drops from {1.0 / usual:.3g} to {rate:.3g} Hz from {first:.1f} to {last:.1f} s.",
        )


def _slow(time: Floats, usual: float, gaps: Gaps) -> tuple[float, float, float] | None:
    """Start, end [s] and least rate [Hz] of what comes more slowly for a while; None without that."""
    count = CHECKING.slow_in_a_row
    spans = time[count:] - time[:-count]
    for start, end in gaps:  # which are told by themselves
        spans = spans - np.where((time[:-count] <= start) & (time[count:] >= end), end - start, 0.0)
    places = np.flatnonzero(spans > CHECKING.slower * count * usual)
    if not places.size:
        return None
    return float(time[places[0]]), float(time[places[-1] + count]), count / float(spans.max())
