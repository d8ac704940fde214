"""Numbers as people read them: in a handy unit, with the digits that are certain."""

from __future__ import annotations

import math
from dataclasses import dataclass

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.foundation.units.unit_algebra import powers_of, unit_of, with_superscripts
from cocorosim_ros.foundation.units.units import prefixed, units_shown

NONE = "\u2013"
_FINEST = 6  # decimals, at most


@dataclass(frozen=True)
class Scale:
    """A handy unit: multiply the SI number by `factor` to have it in `unit`."""

    factor: float
    unit: str


def handy_scale(magnitude: float, unit: str) -> Scale:
    """The unit in which a number of this size [SI unit] is at least 1, if there is one."""
    unit = unit_of(powers_of(unit)) if "(" in unit else unit
    options = [(each.per_si, unit_text(each.label or each.symbol)) for each in units_shown(unit) or prefixed(unit)]
    size = abs(magnitude)
    if size == 0.0 or not math.isfinite(size):
        return Scale(*min(options, key=lambda option: abs(math.log(option[0]))))
    return Scale(*next((option for option in options if size * option[0] >= 1.0), options[-1]))


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
    """The value with its unit, and its 95 % interval in the same unit, both with the digits that are certain."""
    width = abs(estimate.high - estimate.low)
    scale = _scale_of(estimate)
    decimals = _decimals(width * scale.factor / 2, 2) if math.isfinite(width) and width > 0 else None
    value, low, high = (
        _rounded(number * scale.factor, decimals) for number in (estimate.value, estimate.low, estimate.high)
    )
    interval = NONE if low == high == NONE else with_unit(f"{low} to {high}", scale.unit)
    return with_unit(value, scale.unit), interval


def in_unit_of(nominal: float, estimate: Estimate) -> str:
    """A nominal number, four digits, in the unit in which the estimate of it is shown."""
    scale = _scale_of(estimate)
    words = f"{nominal * scale.factor:.4g}"
    return with_unit(_signed(words) if "e" not in words else plain_number(nominal * scale.factor), scale.unit)


def _scale_of(estimate: Estimate) -> Scale:
    ends = [abs(end) for end in (estimate.low, estimate.high) if math.isfinite(end)]
    return handy_scale(max([abs(estimate.value), *ends]), estimate.unit)


def plain_number(value: float, digits: int = 3) -> str:
    """Significant digits without an exponent."""
    if not math.isfinite(value):
        return NONE if math.isnan(value) else ("\u221e" if value > 0 else "\u2212\u221e")
    if value == 0.0:
        return "0"
    return _signed(f"{value:,.{_decimals(value, digits)}f}")


def _rounded(value: float, decimals: int | None) -> str:
    if decimals is None or not math.isfinite(value):
        return plain_number(value)
    return _signed(f"{value:,.{decimals}f}")


def _signed(text: str) -> str:
    return text.replace("-", "\u2212").replace(",", "\u202f")


def _decimals(size: float, digits: int) -> int:
    return min(max(0, digits - 1 - math.floor(math.log10(abs(size)))), _FINEST)
