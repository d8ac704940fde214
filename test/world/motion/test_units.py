"""Units of every equation: each parameter, times what it multiplies, has the unit of what it is added to."""

from __future__ import annotations

import math
import re
from collections import Counter

import pytest

from cocorosim_ros.world.effects import CATALOGUE_EFFECTS, EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.regressors import REGRESSORS

# In kg, m and s; angles have no dimension.
BASE: dict[str, dict[str, float]] = {
    "N": {"kg": 1, "m": 1, "s": -2},
    "Pa": {"kg": 1, "m": -1, "s": -2},
    "kg": {"kg": 1},
    "m": {"m": 1},
    "s": {"s": 1},
    "rad": {},
    "1": {},
}


def dimension(unit: str) -> dict[str, float]:
    """Powers of kg, m and s in a unit such as 'N m s^2' or 'kg/m'."""
    total: Counter[str] = Counter()
    numerator, _, denominator = unit.partition("/")
    for side, sign in ((numerator, 1.0), (denominator, -1.0)):
        for name, power in re.findall(r"([A-Za-z1]+)(?:\^([-0-9.]+))?", side):
            for base, exponent in BASE[name].items():
                total[base] += sign * exponent * float(power or 1)  # type: ignore[assignment]
    return {base: exponent for base, exponent in total.items() if exponent}


# Per parameter: what it multiplies, and the unit of the term, as its own file says.
TERMS: dict[str, tuple[str, str]] = {
    f"{name}.{number.name}": (number.multiplies, number.gives)
    for table in (EFFECTS, ERRORS)
    for name, described in table.items()
    for number in described.numbers
}
PARAMETERS = {
    f"{effect}.{parameter.name}": parameter.unit
    for table in (EFFECTS, ERRORS)
    for effect, described in table.items()
    if not effect.startswith("law_")
    for parameter in described.parameters
}


def test_every_parameter_has_a_term() -> None:
    """No equation is left out."""
    assert set(TERMS) == set(PARAMETERS)


@pytest.mark.parametrize("name", TERMS)
def test_units_of_the_equations_fit(name: str) -> None:
    """The parameter's unit times that of what it multiplies is that of the term."""
    factor, term = TERMS[name]
    product = Counter(dimension(PARAMETERS[name]))
    for base, exponent in dimension(factor).items():
        product[base] += exponent  # type: ignore[assignment]
    assert {base: exponent for base, exponent in product.items() if exponent} == dimension(term)


@pytest.mark.parametrize(
    ("name", "unit"),
    [("thrust", "N"), ("yaw_command", "N m"), ("pump", "N"), ("pump_rate", "N/s"), ("r", "rad/s"), ("u", "m/s"),
     ("speed", "m/s"), ("x", "m"), ("neighbour_distance", "m"), ("t", "s"), ("sin_t", "1"), ("1", "1")],
)  # fmt: skip
def test_units_of_regressors(name: str, unit: str) -> None:
    """Each regressor has the unit of what it measures."""
    units = {regressor.name: regressor.unit for regressor in REGRESSORS}
    assert dimension(units[name]) == dimension(unit)


def test_the_swing_of_a_law_is_an_angle() -> None:
    """omega t + phase has no dimension."""
    units = {parameter.name: parameter.unit for parameter in CATALOGUE_EFFECTS["law_1"].parameters}
    assert dimension(units["omega"]) == {"s": -1}
    assert dimension(units["phase"]) == {}


def test_units_are_read_as_they_are_meant() -> None:
    """The reader itself: kg/m times (m/s)^2 is a newton, N m s^2 over s^2 a newton metre."""
    assert dimension("kg/m") == {"kg": 1, "m": -1}
    assert dimension("N m s^2") == {"kg": 1, "m": 2}
    assert math.isclose(dimension("m^2/s^2")["s"], -2)
