"""Numbers with their units as people read them: in a handy unit, with few digits, without an exponent."""

from __future__ import annotations

import math
from dataclasses import dataclass

from cocorosim_ros.foundation.units.unit_algebra import powers_of, unit_of, with_superscripts
from cocorosim_ros.foundation.units.units import EQUAL, prefixed, units_shown

NONE = "\u2013"
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
        if above in EQUAL:  # in the unit of its equation: what is in proportion to an acceleration is no mass of grams
            return Scale(1.0, unit_text(EQUAL[above]))
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


def said_quantity(value: float, unit: str) -> str:
    """A number with its unit as it stands in a sentence that programs read too: with usual spaces."""
    return quantity_words(value, unit).replace("\u00a0", " ")


def plain_number(value: float, digits: int = 3) -> str:
    """Significant digits without an exponent."""
    if not math.isfinite(value):
        return NONE if math.isnan(value) else ("\u221e" if value > 0 else "\u2212\u221e")
    if is_finest(value):
        return "0" if value == 0.0 else "just above 0" if value > 0.0 else "just below 0"
    return signed(f"{value:,.{decimals_of(value, digits)}f}")


def is_finest(value: float) -> bool:
    """Tell whether a number is too small for the decimals that are shown."""
    return abs(value) < 10.0**-_FINEST


def signed(text: str) -> str:
    """Text of a number with a proper minus sign, and thin spaces between thousands."""
    return text.replace("-", "\u2212").replace(",", "\u202f")


def decimals_of(size: float, digits: int) -> int:
    """Decimals that show so many significant digits; beyond the finest there are two, so that none is nothing."""
    first = math.floor(math.log10(abs(size)))
    return min(max(0, digits - 1 - first), max(_FINEST, 1 - first))
