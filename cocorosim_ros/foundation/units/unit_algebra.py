"""Units as powers of their symbols, so that products and quotients can be written plainly."""

from __future__ import annotations

import re

Powers = dict[str, float]

_POWER = re.compile(r"\^(-?[0-9.]+)")
_SUPERSCRIPTS = str.maketrans(
    "0123456789-.", "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079\u207b\u02d9"
)
_TOKEN = re.compile(r"\s*(?:(?P<symbol>[A-Za-z]+|1)|(?P<sign>[/()])|\^(?P<power>-?[0-9.]+))")


def powers_of(unit: str) -> Powers:
    """'N/((m/s)^2)' as {N: 1, m: -2, s: 2}. Everything after '/' up to the next one divides, as in 'kg/m s'."""
    powers, rest = _product(unit, 0)
    return powers if rest == len(unit) else {unit: 1.0}


def multiplied(first: Powers, second: Powers, power: float = 1.0) -> Powers:
    """first * second^power, without what cancels."""
    names = dict.fromkeys([*first, *second])
    total = {name: first.get(name, 0.0) + power * second.get(name, 0.0) for name in names}
    return {name: each for name, each in total.items() if each}


def unit_of(powers: Powers) -> str:
    """'N s/m' from {N: 1, s: 1, m: -1}, '1' for a pure number; an angle counts only alone or over time."""
    kept = multiplied(powers, {})
    if set(kept) - {"rad", "s"}:
        kept.pop("rad", None)
    above = [_power(name, power) for name, power in kept.items() if power > 0]
    below = [_power(name, -power) for name, power in kept.items() if power < 0]
    if not below:
        return " ".join(above) or "1"
    return f"{' '.join(above) or '1'}/{' '.join(below)}"


def with_superscripts(unit: str) -> str:
    """The unit with its powers standing high: 'N m s^2' as N m s\u00b2."""
    return _POWER.sub(lambda power: power[1].translate(_SUPERSCRIPTS), unit)


def leading_symbol(unit: str) -> str:
    """The symbol that a unit begins with, to which a prefix can be put; empty if it stands to a power or is none."""
    symbol = re.match(r"[A-Za-z]+", unit)
    return "" if symbol is None or _POWER.match(unit, symbol.end()) else symbol[0]


def _product(unit: str, place: int) -> tuple[Powers, int]:
    """Powers of the product that begins there, and where it ends: at a closing bracket or the end."""
    powers: Powers = {}
    sign = 1.0
    while match := _TOKEN.match(unit, place):
        if match["sign"] == ")":
            return powers, place
        place = match.end()
        if match["sign"] == "/":
            sign = -1.0
            continue
        if match["sign"] == "(":
            inner, place = _product(unit, place)
            place += 1
        else:
            inner = {match["symbol"]: 1.0} if match["symbol"] not in (None, "1") else {}
        exponent = _POWER.match(unit, place)
        place = exponent.end() if exponent else place
        powers = multiplied(powers, inner, sign * float(exponent[1] if exponent else 1.0))
    return powers, place


def _power(name: str, power: float) -> str:
    return name if power == 1.0 else f"{name}^{power:g}"
