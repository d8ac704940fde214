"""Numbers as people read them: in a handy unit, with the digits that are certain."""

from __future__ import annotations

import math
from dataclasses import dataclass

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.report.believable import Ends, told_ends
from cocorosim_ros.foundation.units.unit_algebra import powers_of, unit_of, with_superscripts
from cocorosim_ros.foundation.units.units import prefixed, units_shown

NONE = "\u2013"
NOT_TOLD = "not told by these recordings"
_FINEST = 6  # decimals, at most


@dataclass(frozen=True)
class Scale:
    """A handy unit: multiply the SI number by `factor` to have it in `unit`."""

    factor: float
    unit: str


def handy_scale(magnitude: float, unit: str) -> Scale:
    """The unit in which a number of this size [SI unit] is at least 1, if there is one."""
    if "(" in unit:
        above, below = _divided(unit)
        if below:
            scale = handy_scale(magnitude, above)
            return Scale(scale.factor, f"{scale.unit} per {unit_text(below)}")
        unit = above
    options = [(each.per_si, unit_text(each.label or each.symbol)) for each in units_shown(unit) or prefixed(unit)]
    size = abs(magnitude)
    if size == 0.0 or not math.isfinite(size):
        return Scale(*min(options, key=lambda option: abs(math.log(option[0]))))
    return Scale(*next((option for option in options if size * option[0] >= 1.0), options[-1]))


def _divided(unit: str) -> tuple[str, str]:
    """The unit of a law's coefficient multiplied out, and nothing; or what it is per what, where that says more.

    That is where only a reciprocal would be left over, as of newtons per newton metre, and where an angle would vanish.
    """
    product = unit_of(powers_of(unit))
    of, _, per = unit.partition("/(")
    per = unit_of(powers_of(per.removesuffix(")")))
    vanished = "rad" in of and "rad" not in product and "rad" not in per
    return (of, per) if per != "1" and (product.startswith("1/") or vanished) else (product, "")


def unit_text(unit: str) -> str:
    """A unit with superscripts: 'N m s^2' as N m s\u00b2; nothing for a pure number."""
    return "" if unit == "1" else with_superscripts(unit)


def with_unit(number: str, unit: str) -> str:
    """Number and unit, with a space where one belongs."""
    if not unit or number == NONE:
        return number
    return number + unit if unit.startswith("\u00b0") else f"{number}\u00a0{unit}"


def quantity_words(value: float, unit: str) -> str:
    """A number with its unit, three significant digits."""
    scale = handy_scale(value, unit)
    return with_unit(plain_number(value * scale.factor), scale.unit)


def estimate_words(estimate: Estimate) -> tuple[str, str]:
    """The value with its unit, and its 95 % interval in the same unit, both with the digits that are certain.

    No number has fewer than two digits, so that none is told as nothing. An end that no vehicle can have, or that is
    unknown by factors, is left out.
    """
    ends = told_ends(estimate)
    width = ends.high - ends.low
    scale = _scale_of(estimate)
    decimals = _decimals(width * scale.factor / 2, 2) if math.isfinite(width) and width > 0 else None
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
    return with_unit(_signed(words) if "e" not in words else plain_number(nominal * scale.factor), scale.unit)


def _scale_of(estimate: Estimate) -> Scale:
    ends = [abs(end) for end in told_ends(estimate) if math.isfinite(end)]
    return handy_scale(max([abs(estimate.value), *ends]), estimate.unit)


def plain_number(value: float, digits: int = 3) -> str:
    """Significant digits without an exponent."""
    if not math.isfinite(value):
        return NONE if math.isnan(value) else ("\u221e" if value > 0 else "\u2212\u221e")
    if _is_finest(value):
        return "0" if value == 0.0 else "just above 0" if value > 0.0 else "just below 0"
    return _signed(f"{value:,.{_decimals(value, digits)}f}")


def _is_finest(value: float) -> bool:
    return abs(value) < 10.0**-_FINEST


def _rounded(value: float, decimals: int | None, digits: int) -> str:
    """The number with so many decimals, two significant digits at least; with `digits` where decimals are not known."""
    if decimals is None or not math.isfinite(value) or _is_finest(value):
        return plain_number(value, digits)
    return _signed(f"{value:,.{max(decimals, _decimals(value, 2))}f}")


def _signed(text: str) -> str:
    return text.replace("-", "\u2212").replace(",", "\u202f")


def _decimals(size: float, digits: int) -> int:
    """Decimals that show so many significant digits; beyond the finest there are two, so that none is nothing."""
    first = math.floor(math.log10(abs(size)))
    return min(max(0, digits - 1 - first), max(_FINEST, 1 - first))
