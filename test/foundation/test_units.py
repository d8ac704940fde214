"""The table of units: factors against hand values, one dimension per symbol, what is derived from it."""

from __future__ import annotations

import math

import pytest

from cocorosim_ros.foundation.units.unit_algebra import multiplied, powers_of
from cocorosim_ros.foundation.units.units import (
    DIMENSIONS,
    EQUAL,
    PREFIXES,
    Unit,
    prefixed,
    units_in_files,
    units_shown,
)
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.laws.readings import READINGS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.equations import EQUATIONS
from cocorosim_ros.world.terms.regressors import REGRESSORS

# What each symbol is in kg, m, s, rad, V, lx: by hand.
SIZES = {
    "m": 1.0, "cm": 1e-2, "mm": 1e-3, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9, "min": 60.0, "h": 3600.0,
    "rad": 1.0, "deg": math.pi / 180.0, "kg": 1.0, "g": 1e-3, "mg": 1e-6, "N": 1.0, "mN": 1e-3, "Pa": 1.0, "hPa": 1e2,
    "mbar": 1e2, "kPa": 1e3, "dbar": 1e4, "bar": 1e5, "Hz": 1.0, "kHz": 1e3, "V": 1.0, "mV": 1e-3, "lx": 1.0,
    "klx": 1e3, "1": 1.0, "bit": 1.0, "kbit": 1e3, "dB": 1.0, "degC": 1.0,
}  # fmt: skip
ODD = {"%": 1e-2, "ppm": 1e-6, "g0": 9.80665, "mm/s per m": 1e-3, "rev/s": 2 * math.pi, "rpm": math.pi / 30}
ODD["g/kg"] = 1.0  # salinity is never converted: equations of state take it so
EVERY = [(dimension, unit) for dimension, units in DIMENSIONS.items() for unit in units]


@pytest.mark.parametrize(("dimension", "unit"), EVERY, ids=lambda part: getattr(part, "symbol", part))
def test_a_factor_is_the_product_of_its_symbols(dimension: str, unit: Unit) -> None:
    """As 'kg cm^2' is 1e-4 kg m^2."""
    expected = ODD.get(unit.symbol)
    if expected is None:
        expected = math.prod(SIZES[symbol] ** power for symbol, power in powers_of(unit.symbol).items())
    assert float(unit.factor) == pytest.approx(expected, rel=1e-15)
    assert unit.per_si * float(unit.factor) == pytest.approx(1.0, rel=1e-15)


def test_each_symbol_has_one_dimension_that_begins_with_si() -> None:
    """No symbol twice; factors of SI units are one; what is shown goes from the largest to the smallest."""
    symbols = [unit.symbol for _, unit in EVERY]
    assert len(symbols) == len(set(symbols))
    for units in DIMENSIONS.values():
        assert units[0].factor == "1"
        sizes = [float(unit.factor) for unit in units if unit.shown]
        assert sizes == sorted(sizes, reverse=True)
    assert [float(factor) for factor in PREFIXES.values()] == [1e3, 1.0, 1e-3, 1e-6, 1e-9]


def test_files_may_have_units_that_can_be_read() -> None:
    """Only those, SI first; a dimension that no file has is none of theirs."""
    found = units_in_files()
    assert "square of a speed" not in found
    assert list(found["mass"].items()) == [("kg", "1"), ("g", "0.001")]
    assert {unit for units in found.values() for unit in units} == {unit.symbol for _, unit in EVERY if unit.read}
    assert all(next(iter(units)) == DIMENSIONS[dimension][0].symbol for dimension, units in found.items())


@pytest.mark.parametrize("unit", EQUAL)
def test_equal_units_are_equal(unit: str) -> None:
    """With a newton as kg m/s^2; reports show the one that people write, the other stays as it is in files."""

    def in_kilograms(text: str) -> dict[str, float]:
        powers = powers_of(text)
        return multiplied(powers, {"N": 1.0, "kg": -1.0, "m": -1.0, "s": 2.0}, -powers.get("N", 0.0))

    assert in_kilograms(unit) == in_kilograms(EQUAL[unit])
    assert (units_shown(unit) or prefixed(unit)) == (units_shown(EQUAL[unit]) or prefixed(EQUAL[unit]))


def test_units_of_reports() -> None:
    """Special ones by their SI unit, prefixes for all others."""
    assert [unit.symbol for unit in units_shown("kg")] == ["kg", "g", "mg"]
    assert units_shown("N") == units_shown("no unit") == ()
    assert [unit.symbol for unit in prefixed("N/m")] == ["kN/m", "N/m", "mN/m", "\u00b5N/m", "nN/m"]
    assert prefixed("lx") == (Unit("lx"),)
    assert prefixed("m^1.5/s") == (Unit("m^1.5/s"),)


def test_the_physics_is_made_of_these_units() -> None:
    """Regressors, readings, equations and parameters of effects name no symbol that the table does not have."""
    named = [part.unit for part in (*REGRESSORS, *READINGS, *EQUATIONS)]
    named += [part.unit for effect in (*EFFECTS.values(), *ERRORS.values()) for part in effect.parameters]
    known = {symbol for units in DIMENSIONS.values() for symbol in powers_of(units[0].symbol)} | {"*"}
    assert {symbol for unit in named for symbol in powers_of(unit)} <= known
