"""Numbers as people read them: handy units, certain digits, no exponents."""

from __future__ import annotations

import math

import pytest

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.report.number_text import estimate_words, plain_number, quantity_words, unit_text
from cocorosim_ros.foundation.units.unit_algebra import powers_of, unit_of


@pytest.mark.parametrize(
    ("value", "unit", "words"),
    [
        (0.0044, "N", "4.40 mN"),
        (2.2e-5, "N m", "22.0 µN m"),
        (-0.003, "m/s", "\u22123.00 mm/s"),
        (0.25, "m", "250 mm"),
        (1.5, "m", "1.50 m"),
        (0.3, "s", "300 ms"),
        (0.3, "s/m", "0.300 s/m"),
        (math.pi / 6, "rad", "30.0°"),
        (0.0443, "kg", "44.3 g"),
        (4.05e-4, "kg m^2", "4.05 kg cm²"),
        (5e-5, "s/s", "50.0 ppm"),
        (0.03, "1", "0.0300"),
        (1.14e-4, "N m s^2", "114 µN m s²"),
        (3e-4, "N/((m))", "300 µN/m"),
        (2e-3, "N m/((m/s) (m/s))", "2.00 mN s²/m"),
        (101325.0, "Pa", "101 kPa"),
        (0.0, "N", "0 N"),
        (math.nan, "N", "\u2013"),
        (1e-12, "N", "0.00100 nN"),
    ],
)  # fmt: skip
def test_a_number_stands_in_the_unit_that_makes_it_handy(value: float, unit: str, words: str) -> None:
    """Three digits, an SI prefix, degrees for angles; never an exponent."""
    assert quantity_words(value, unit).replace("\u00a0", " ") == words


def test_an_interval_says_how_many_digits_are_certain() -> None:
    """Two digits of the half width, the same decimals and unit for value and ends."""
    value, interval = estimate_words(Estimate(0.31432, 0.30118, 0.32746, "s"))
    assert (value.replace("\u00a0", " "), interval.replace("\u00a0", " ")) == ("314 ms", "301 to 327 ms")
    value, interval = estimate_words(Estimate(1.853, 1.831, 1.875, "kg/m"))
    assert (value.replace("\u00a0", " "), interval.replace("\u00a0", " ")) == ("1.853 kg/m", "1.831 to 1.875 kg/m")


def test_an_interval_without_ends_is_a_dash() -> None:
    """NaN ends leave the value alone; infinite ones are shown as such."""
    assert estimate_words(Estimate(0.5, math.nan, math.nan, "N"))[1] == "\u2013"
    assert estimate_words(Estimate(0.5, math.nan, math.nan, "N"))[0].replace("\u00a0", " ") == "500 mN"
    assert "∞" in estimate_words(Estimate(0.5, 0.1, math.inf, "N"))[1]


@pytest.mark.parametrize(
    ("value", "text"),
    [(1234567.0, "1\u202f234\u202f567"), (0.000012, "0.000012"), (-0.5, "\u22120.500"), (99.96, "99.96")],
)
def test_plain_numbers(value: float, text: str) -> None:
    """Thin spaces for thousands, a true minus; four digits where asked."""
    assert plain_number(value, 4 if value == 99.96 else 3) == text


def test_units_are_multiplied_out() -> None:
    """Brackets, quotients of quotients and powers of halves come to plain units."""
    assert powers_of("N/((m/s)^2)") == {"N": 1.0, "m": -2.0, "s": 2.0}
    assert unit_of(powers_of("N/((m/s)^2)")) == "N s^2/m^2"
    assert unit_of(powers_of("N m/((m/s)^1.5)")) == "N s^1.5/m^0.5"
    assert unit_of(powers_of("m/((m))")) == "1"
    assert unit_of({"rad": 1.0, "s": -1.0}) == "rad/s"
    assert unit_of({"m": 1.0, "rad": 1.0, "s": -2.0}) == "m/s^2"


def test_superscripts() -> None:
    """Powers stand high, pure numbers have no unit."""
    assert unit_text("kg m^2/s^-1") == "kg m²/s⁻¹"
    assert unit_text("1") == ""
