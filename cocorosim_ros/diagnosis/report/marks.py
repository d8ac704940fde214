"""Marks beside numbers that are to be doubted: at a limit, with an interval beyond one, or of another regime."""

from __future__ import annotations

import math
from collections.abc import Sequence

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.report.number_text import estimate_words, in_unit_of

DOUBTFUL_NUMBER = "may as well be nothing"
"""Mark of a number of an effect whose 95 % interval holds the value at which it does nothing."""


def limit_words(estimate: Estimate) -> str:
    """Words for a number that stands at an end of its limits, or whose interval leaves them; '' for any other."""
    limits = _limits(estimate)
    if not limits:
        return ""
    if estimate.at_limit:
        return f"at an end of its limits, {limits}"
    leaves = estimate.low < estimate.limits[0] or estimate.high > estimate.limits[1]
    return f"its interval leaves its limits, {limits}" if leaves else ""


def marked_words(estimate: Estimate, *, doubtful: bool = False) -> tuple[str, str]:
    """Value and 95 % interval as `estimate_words` has them, the marks of the number behind the interval.

    doubtful: whether the interval holds the value at which the number does nothing.
    """
    value, interval = estimate_words(estimate)
    return value, "; ".join(filter(None, (interval, limit_words(estimate), DOUBTFUL_NUMBER if doubtful else "")))


def marked_value(estimate: Estimate) -> str:
    """The value with its mark in brackets, where it has one."""
    mark = limit_words(estimate)
    return f"{estimate_words(estimate)[0]} ({mark})" if mark else estimate_words(estimate)[0]


def unlike_words(quantities: Sequence[str]) -> str:
    """Words for errors of free runs through parts that are unlike the fitted ones, by quantities; '' if none."""
    if not quantities:
        return ""
    *others, last = quantities
    listed = f"{', '.join(others)} and {last}" if others else last
    return f"unlike the fitted parts in {listed}"


def _limits(estimate: Estimate) -> str:
    """The limits in the unit in which the number is shown, '' where it has none."""
    low, high = (in_unit_of(end, estimate) if math.isfinite(end) else "" for end in estimate.limits)
    if low and high:
        return f"{low} to {high}"
    return f"from {low} on" if low else f"up to {high}" if high else ""
