"""Estimates as people read them: in a handy unit, with the digits that are certain."""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.report.believable import Ends, told_ends
from cocorosim_ros.foundation.units.quantity_text import (
    NONE,
    Scale,
    decimals_of,
    handy_scale,
    is_finest,
    plain_number,
    signed,
    with_unit,
)

NOT_TOLD = "not told by these recordings"


def estimate_words(estimate: Estimate) -> tuple[str, str]:
    """The value with its unit, and its 95 % interval in the same unit, both with the digits that are certain.

    No number has fewer than two digits, so that none is told as nothing. An end that no vehicle can have, or that is
    unknown by factors, is left out.
    """
    ends = told_ends(estimate)
    width = ends.high - ends.low
    scale = _scale_of(estimate)
    decimals = decimals_of(width * scale.factor / 2, 2) if math.isfinite(width) and width > 0 else None
    digits = 2 if math.isinf(width) else 3
    value, low, high = (_rounded(number * scale.factor, decimals, digits) for number in (estimate.value, *ends))
    return with_unit(value, scale.unit), _interval_words(ends, low, high, scale.unit)


def _interval_words(ends: Ends, low: str, high: str, unit: str) -> str:
    """Words for an interval; low, high: its ends as text."""
    if math.isnan(ends.low) or math.isnan(ends.high):
        return NONE
    if math.isinf(ends.low) and math.isinf(ends.high):
        return NOT_TOLD
    if math.isinf(ends.high):
        return f"at least {with_unit(low, unit)}"
    if math.isinf(ends.low):
        return f"at most {with_unit(high, unit)}"
    return with_unit(f"{low} to {high}", unit)


def in_unit_of(nominal: float, estimate: Estimate) -> str:
    """A nominal number, four digits, in the unit in which the estimate of it is shown."""
    scale = _scale_of(estimate)
    words = f"{nominal * scale.factor:.4g}"
    return with_unit(signed(words) if "e" not in words else plain_number(nominal * scale.factor), scale.unit)


def _scale_of(estimate: Estimate) -> Scale:
    ends = [abs(end) for end in told_ends(estimate) if math.isfinite(end)]
    return handy_scale(max([abs(estimate.value), *ends]), estimate.unit)


def _rounded(value: float, decimals: int | None, digits: int) -> str:
    """The number with so many decimals, two significant digits at least; with `digits` where decimals are not known."""
    if decimals is None or not math.isfinite(value) or is_finest(value):
        return plain_number(value, digits)
    return signed(f"{value:,.{max(decimals, decimals_of(value, 2))}f}")
