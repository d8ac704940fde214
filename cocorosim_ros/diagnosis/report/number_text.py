"""Numbers as people read them: in a handy unit, with the digits that are certain."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.foundation.units.unit_algebra import powers_of, unit_of

NONE = "\u2013"
_FINEST = 6  # decimals, at most
_PREFIXES = {
    "N": (("k", 1e-3), ("", 1.0), ("m", 1e3), ("\u00b5", 1e6), ("n", 1e9)),
    "Pa": (("k", 1e-3), ("", 1.0), ("m", 1e3)),
    "m": (("", 1.0), ("m", 1e3), ("\u00b5", 1e6)),
    "s": (("", 1.0), ("m", 1e3), ("\u00b5", 1e6)),
}
# Units whose handy form is no prefix alone: factor and text, the largest unit first.
_SPECIAL: dict[str, tuple[tuple[float, str], ...]] = {
    "rad": ((math.degrees(1.0), "\u00b0"),),
    "rad/s": ((math.degrees(1.0), "\u00b0/s"),),
    "kg": ((1.0, "kg"), (1e3, "g"), (1e6, "mg")),
    "kg m^2": ((1.0, "kg m\u00b2"), (1e4, "kg cm\u00b2")),
    "kg/m": ((1.0, "kg/m"), (1e3, "g/m")),
    "m^2": ((1.0, "m\u00b2"), (1e4, "cm\u00b2"), (1e6, "mm\u00b2")),
    "m^2/s^2": ((1.0, "m\u00b2/s\u00b2"), (1e4, "cm\u00b2/s\u00b2"), (1e6, "mm\u00b2/s\u00b2")),
    "s/s": ((1e6, "ppm"),),
    "1/s": ((1.0, "m/s per m"), (1e3, "mm/s per m")),
}
_SUPERSCRIPTS = str.maketrans(
    "0123456789-.", "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079\u207b\u02d9"
)


@dataclass(frozen=True)
class Scale:
    """A handy unit: multiply the SI number by `factor` to have it in `unit`."""

    factor: float
    unit: str


def handy_scale(magnitude: float, unit: str) -> Scale:
    """The unit in which a number of this size [SI unit] is at least 1, if there is one."""
    unit = unit_of(powers_of(unit)) if "(" in unit else unit
    options = _SPECIAL.get(unit) or _prefixed(unit)
    size = abs(magnitude)
    if size == 0.0 or not math.isfinite(size):
        return Scale(*min(options, key=lambda option: abs(math.log(option[0]))))
    return Scale(*next((option for option in options if size * option[0] >= 1.0), options[-1]))


def unit_text(unit: str) -> str:
    """A unit with superscripts: 'N m s^2' as N m s\u00b2; nothing for a pure number."""
    if unit == "1":
        return ""
    return re.sub(r"\^(-?[0-9.]+)", lambda power: power[1].translate(_SUPERSCRIPTS), unit)


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


def _prefixed(unit: str) -> tuple[tuple[float, str], ...]:
    symbol = re.match(r"[A-Za-z]+", unit)
    if symbol is None or symbol[0] not in _PREFIXES or unit[symbol.end() :].startswith("^"):
        return ((1.0, unit_text(unit)),)
    return tuple((factor, unit_text(prefix + unit)) for prefix, factor in _PREFIXES[symbol[0]])
