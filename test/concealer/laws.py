"""Names of laws outside the catalogue, understood: `surge~|u|^0.5*u` and `surge~u*|u|^0.5` are one law."""

from __future__ import annotations

import fnmatch
import re

Law = tuple[str, frozenset[tuple[str, float, bool]]]

SAME_EQUATION = {"world_z": "heave"}  # robots neither pitch nor roll
SAME_REGRESSOR = {"cos_t": "sin_t"}  # but for a phase


def law(name: str) -> Law | None:
    """Equation and factors (variable, power, whether it keeps the variable's sign) of `unknown:EQUATION~PRODUCT`."""
    head, colon, rest = name.partition(":")
    equation, tilde, product = rest.partition("~")
    if head != "unknown" or not colon or not tilde:
        return None
    powers: dict[str, list[float]] = {}
    for factor in product.split("*"):
        found = re.fullmatch(r"(\|?)([a-z_1]+)\|?(?:\^(-?[0-9.]+))?", factor.strip())
        if not found:
            return None
        variable = SAME_REGRESSOR.get(found[2], found[2])
        power = float(found[3] or 1.0)
        total = powers.setdefault(variable, [0.0, 0.0])
        total[0] += power
        total[1] += 0.0 if found[1] else power  # what keeps a sign
    factors = frozenset((key, total, odd % 2.0 == 1.0) for key, (total, odd) in powers.items() if key != "1")
    return SAME_EQUATION.get(equation, equation), factors


def matches(name: str, pattern: str) -> bool:
    """Whether a name is one of those that a pattern allows: the same law, or as fnmatch reads the pattern."""
    if name == pattern or fnmatch.fnmatchcase(name, pattern):
        return True
    said = law(name)
    return said is not None and said == law(pattern)
