"""Numbers as people read them: handy units, certain digits, no exponents."""

from __future__ import annotations

import math

import pytest

from cocorosim_ros.diagnosis.catalogue.meaning import between
from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.report.believable import is_possible_size
from cocorosim_ros.diagnosis.report.number_text import estimate_words
from cocorosim_ros.foundation.units.quantity_text import plain_number, quantity_words, unit_text
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
        (2e-3, "N m/((m/s) (m/s))", "0.00200 kg"),  # of Munk's moment
        (0.124, "N/((m/s) (rad/s))", "0.124 kg"),
        (12.0, "N/((m/s)^2)", "12.0 kg/m"),
        (0.0775, "s/rad", "0.0775 s/rad"),
        (-2.0, "N/((N m))", "\u22122.00 N per N m"),
        (0.002, "N/((N m))", "2.00 mN per N m"),
        (math.pi / 6, "rad/((m))", "30.0° per m"),
        (math.pi / 6, "rad/((m/s))", "30.0° per m/s"),
        (0.3, "rad/((rad/s))", "300 ms"),
        (0.02, "m/((m))", "0.0200"),
        (0.5, "m/((m) (m))", "500 mm per m²"),
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
    """NaN ends leave the value alone; where one is infinite the other is told."""
    assert estimate_words(Estimate(0.5, math.nan, math.nan, "N"))[1] == "\u2013"
    assert estimate_words(Estimate(0.5, math.nan, math.nan, "N"))[0].replace("\u00a0", " ") == "500 mN"
    assert plain_words(Estimate(0.5, 0.1, math.inf, "N"))[1] == "at least 100 mN"
    assert plain_words(Estimate(0.5, -math.inf, 0.7, "N"))[1] == "at most 700 mN"


def plain_words(estimate: Estimate) -> tuple[str, str]:
    """Value and interval with usual spaces."""
    value, interval = estimate_words(estimate)
    return value.replace("\u00a0", " "), interval.replace("\u00a0", " ")


@pytest.mark.parametrize(
    ("estimate", "words"),
    [
        (Estimate(0.245, 0.002, 24.3, "1"), ("0.24", "0.0020 to 24")),  # the gain of a small AUV's thrusters
        (Estimate(0.0054, -1.78, 1.79, "s"), ("0.0054 s", "\u22121.8 to 1.8 s")),
        (Estimate(-0.0054, -1.79, 1.78, "s"), ("\u22120.0054 s", "\u22121.8 to 1.8 s")),
        (Estimate(0.0, -226.0, 226.0, "N m s"), ("0 N m s", "\u2212226 to 226 N m s")),
        (Estimate(1.0, 1e-14, 2.0, "kg"), ("1.00 kg", "just above 0 to 2.00 kg")),
    ],
)
def test_no_number_is_told_as_nothing(estimate: Estimate, words: tuple[str, str]) -> None:
    """Two significant digits at least, however wide the interval; what is exactly zero is zero."""
    assert plain_words(estimate) == words


@pytest.mark.parametrize(
    ("estimate", "words"),
    [
        # Logarithms without information: the drag of a hovercraft and of a small AUV.
        (Estimate(0.001, 1e-25, 3.6e22, "kg/m"), ("1.0 g/m", "not told by these recordings")),
        (Estimate(8.0, 3.3e-7, 1.95e8, "kg/m"), ("8.0 kg/m", "not told by these recordings")),
        (Estimate(0.0, 0.0, 3.6e22, "kg/m"), ("0 kg/m", "not told by these recordings")),
        # A gauge that nothing else tells: no water is that deep.
        (Estimate(-1e3, -1.4e14, 1.4e14, "Pa"), ("\u22121.0 kPa", "not told by these recordings")),
        (Estimate(3.0, 1.0, 1e9, "m/s"), ("3.0 m/s", "at least 1.0 m/s")),
        (Estimate(0.4, -1e3, 0.6, "rad"), ("23°", "at most 34°")),
        # A factor of eight to either side is a number.
        (Estimate(0.0034, 0.00048, 0.024, "kg/m"), ("3.4 g/m", "0.48 to 24 g/m")),
    ],
)
def test_what_no_vehicle_can_have_is_not_told(estimate: Estimate, words: tuple[str, str]) -> None:
    """An end that is unknown by factors, or beyond all water and vehicles, is left out, and does not set the unit."""
    assert plain_words(estimate) == words


@pytest.mark.parametrize(
    ("column", "estimate", "interval"),
    [
        ("battery_sag.fraction_lost", (0.9, 0.3, 22.7), "0.30 to 1.00"),
        ("battery_sag.fraction_lost", (0.22, -0.23, 0.67), "\u22120.23 to 0.67"),  # thrust that rises can be
        ("reverse_loss.loss", (0.6, 0.2, 4.97), "0.20 to 1.00"),
        ("thruster_deadband.width", (0.1, -0.2, 0.4), "0 to 0.40"),
        ("rudder_1.drag_share", (0.4, -0.23, 1.03), "0 to 1.00"),
        ("wall_effect.gain", (2.0, -1.0, 5.0), "\u22121.0 to 5.0"),
    ],
)
def test_shares_end_where_a_share_ends(column: str, estimate: tuple[float, float, float], interval: str) -> None:
    """No more than all of the thrust is lost; what is more than a share keeps its interval."""
    assert estimate_words(Estimate(*estimate, "1", between(column)))[1] == interval


@pytest.mark.parametrize(
    ("effect", "number", "size", "unit", "possible"),
    [
        ("battery_sag", "fraction_lost", 22.7, "1", False),
        ("battery_sag", "fraction_lost", 0.3, "1", True),
        ("reverse_loss", "loss", 4.97, "1", False),
        ("pressure_offset", "offset", 1.4e14, "Pa", False),
        ("pressure_offset", "offset", 500.0, "Pa", True),
        ("compass_distortion", "offset", 3e9, "rad", False),
        ("steady_current", "x", 166.0, "m/s", False),
        ("steady_current", "x", 0.2, "m/s", True),
        ("linear_drag", "surge", 8.2e7, "N s/m", False),
        ("linear_drag", "surge", math.nan, "N s/m", False),
    ],
)
def test_no_size_is_visible_that_cannot_be(effect: str, number: str, size: float, unit: str, possible: bool) -> None:
    """Sizes of the recordings of others from which an effect was told to show."""
    assert is_possible_size(effect, number, size, unit) == possible


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
