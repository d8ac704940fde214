"""Numbers with units: conversion against hand values, refusals, round trips."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, entry_of
from cocorosim_ros.scenario.reading.quantity import (
    UNITS,
    is_quantity,
    nanoseconds_text,
    quantity_text,
    read_any_quantity,
    read_list,
    read_nanoseconds,
    read_quantity,
    read_vector,
)

SOURCED = {"source": "hand"}


def at(value: Any) -> Entry:
    """The value as an entry called 'k' on line 12 of x.yaml."""
    return Entry(entry_of(value, "x.yaml", "k").value, "x.yaml", 12, "k")


@pytest.mark.parametrize(
    ("value", "dimension", "expected"),
    [
        ("6 m", "length", 6.0),
        ("55mm", "length", 0.055),
        ("440 cm^3", "volume", 0.00044),
        ("10 cm^3", "volume", 0.00001),
        ("90 deg", "angle", math.pi / 2),
        ("-180 deg", "angle", -math.pi),
        ("10 min", "time", 600.0),
        ("1.5 h", "time", 5400.0),
        ("5 mN", "force", 0.005),
        ("7.5 cm/s", "speed", 0.075),
        ("10 %", "pure number", 0.1),
        (0.25, "pure number", 0.25),
        (3, "pure number", 3.0),
        ("1e-3 kg m^2", "moment of inertia", 0.001),
        ({"value": 0.44, "unit": "kg", **SOURCED}, "mass", 0.44),
        ({"value": 440, "unit": "g", "confidence": "measured", "note": "scales", **SOURCED}, "mass", 0.44),
        ({"value": 127, "unit": 1, **SOURCED}, "pure number", 127.0),
    ],
)
def test_conversion_to_si(value: Any, dimension: str, expected: float) -> None:
    """The SI number is the double nearest to the decimal one."""
    assert read_quantity(at(value), dimension) == expected


@pytest.mark.parametrize(
    ("value", "dimension", "sentence"),
    [
        ("6 kg", "length", "has '6 kg', which is not a length; write it in m, cm or mm, e.g. '6 m'."),
        ("6 M", "length", "has '6 M', which is not a length"),
        (6, "length", "has '6', which has no unit; write it in m, cm or mm, e.g. '6 m'."),
        ("6", "length", "has '6', which has no unit"),
        ("six m", "length", "has 'six m', which is not a length"),
        (True, "length", "has 'true', which is not a length"),
        (None, "mass", "has nothing, which is not a mass; write it in kg or g, e.g. '6 kg'."),
        ("1 m", "angle", "which is not an angle; write it in rad or deg, e.g. '6 rad'."),
        ("nan m", "length", "has 'nan m', which is not a finite number"),
        ("-.inf m", "length", "is not a finite number"),
        ("1e999 m", "length", "is not a finite number"),
        ({"value": 10**400, "unit": "m", **SOURCED}, "length", "is not a finite number"),
        ({"value": 1, "unit": "s", **SOURCED}, "length", "has '1 s', which is not a length"),
        ({"value": "1", "unit": "m", **SOURCED}, "length", "is not a length"),
        ({"value": 1, "unit": "m"}, "length", "lacks 'source'; add it."),
        ({"value": 1, **SOURCED}, "length", "lacks 'unit'; add it."),
        ({"value": 1, "unit": "m", "source": ""}, "length", "'k.source' has '' where text is needed"),
        (
            {"value": 1, "unit": "m", "sauce": "x", **SOURCED},
            "length",
            "'k.sauce' is not a known key; did you mean 'source'?",
        ),
        ({"value": 1, "unit": "m", "confidence": "sure", **SOURCED}, "length", "'k.confidence' has 'sure'"),
    ],
)
def test_refusals(value: Any, dimension: str, sentence: str) -> None:
    """What is not a number of this dimension is refused in a sentence that shows what was found."""
    with pytest.raises(CocorosimError) as caught:
        read_quantity(at(value), dimension)
    assert sentence in str(caught.value)


def test_sentence_names_file_line_and_key() -> None:
    """The sentence begins with its place."""
    with pytest.raises(CocorosimError, match=r"^x\.yaml line 12: 'k' has '6 kg', which is not a length"):
        read_quantity(at("6 kg"), "length")


def test_signs() -> None:
    """Negative numbers are refused where they make no sense, zero only where it must be positive."""
    assert read_quantity(at("0 m"), "length", "not negative") == 0.0
    with pytest.raises(CocorosimError, match=r"has '-1 m'; it must not be negative\."):
        read_quantity(at("-1 m"), "length", "not negative")
    with pytest.raises(CocorosimError, match=r"has '0 m'; it must be greater than zero\."):
        read_quantity(at("0 m"), "length", "positive")


def test_vectors() -> None:
    """A vector has a unit for each number or one for all."""
    assert read_vector(at(["6 m", "50 cm", "2 m"]), ["length"] * 3) == (6.0, 0.5, 2.0)
    assert read_vector(at({"value": [1, 2], "unit": "cm", **SOURCED}), ["length"] * 2) == (0.01, 0.02)
    assert read_list(at({"value": [0, 90], "unit": "deg", **SOURCED}), "angle") == (0.0, math.pi / 2)
    with pytest.raises(CocorosimError, match=r"'k' has \[6 m, 6 m\]; write 3 values: \[\.\.\. m, \.\.\. m, \.\.\. m\]"):
        read_vector(at(["6 m", "6 m"]), ["length"] * 3)
    with pytest.raises(CocorosimError, match=r"'k' has '6 kg', which is not a length"):
        read_vector(at(["6 m", "6 kg"]), ["length"] * 2)
    with pytest.raises(CocorosimError, match="where a list is needed"):
        read_vector(at("6 m"), ["length"] * 2)


def test_any_quantity() -> None:
    """A number whose dimension is not known beforehand brings it along."""
    found = read_any_quantity(at("2 cm/s"))
    assert (found.value, found.unit, found.dimension) == (0.02, "m/s", "speed")
    with pytest.raises(CocorosimError, match=r"has '2 furlong', whose unit is unknown; allowed: m, cm"):
        read_any_quantity(at("2 furlong"))


def test_nanoseconds() -> None:
    """Times are exact: a tenth of a second is 100 million nanoseconds, a third of a nanosecond is none."""
    assert read_nanoseconds(at("0.1 s")) == 100_000_000
    assert read_nanoseconds(at("2.5 h")) == 9_000_000_000_000
    with pytest.raises(CocorosimError, match="not a whole number of nanoseconds"):
        read_nanoseconds(at("0.3333333333333 s"))
    with pytest.raises(CocorosimError, match="greater than zero"):
        read_nanoseconds(at("0 s"))


def test_each_unit_belongs_to_one_dimension() -> None:
    """No unit is in two rows of the table, and each row begins with factor 1."""
    units = [unit for row in UNITS.values() for unit in row]
    assert len(units) == len(set(units))
    assert all(next(iter(row.values())) == "1" for row in UNITS.values())


@pytest.mark.parametrize(
    ("value", "expected"),
    [("6 m", True), (6, True), ("6", True), ("six", False), (True, False), ("6 lilys", False)],
)
def test_is_quantity(value: Any, expected: bool) -> None:
    """Numbers, with a known unit or none, are quantities; words and truth values are not."""
    assert is_quantity(value) is expected


FINITE = st.floats(allow_nan=False, allow_infinity=False)


@given(FINITE, st.sampled_from(sorted(UNITS)))
def test_si_text_reads_back_exactly(value: float, dimension: str) -> None:
    """Writing and reading an SI number changes no bit."""
    assert repr(read_quantity(at(quantity_text(value, dimension)), dimension)) == repr(value)


@given(st.floats(-1e9, 1e9), st.sampled_from([(unit, dim) for dim, row in UNITS.items() for unit in row]))
def test_text_and_mapping_agree(value: float, unit: tuple[str, str]) -> None:
    """The short form and the form with a source give the same number, near to value times factor."""
    name, dimension = unit
    short = read_quantity(at(f"{value!r} {name}"), dimension)
    assert short == read_quantity(at({"value": value, "unit": name, **SOURCED}), dimension)
    assert math.isclose(short, value * float(UNITS[dimension][name]), rel_tol=1e-15, abs_tol=1e-300)


@given(st.integers(1, 2**53))
def test_nanoseconds_read_back(nanoseconds: int) -> None:
    """Whole nanoseconds survive writing and reading, as far as a double can hold the seconds' 15 digits."""
    rounded = nanoseconds // 1000 * 1000 if nanoseconds >= 10**15 else nanoseconds
    if rounded:
        assert read_nanoseconds(at(nanoseconds_text(rounded))) == rounded
