"""Laws outside the catalogue: one text form, one parser, codes and units by hand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cocorosim_ros.diagnosis.catalogue.eddies import ALONG_X
from cocorosim_ros.diagnosis.catalogue.laws import LAWS_OF, SWINGING
from cocorosim_ros.diagnosis.catalogue.sensor_laws import SENSOR_LAWS_OF
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.laws.law import Factor, Law, Product, subject_and_product
from cocorosim_ros.world.laws.readings import READING, READING_CODE
from cocorosim_ros.world.terms.equations import EQUATION_CODE
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE, REGRESSORS

OPEN_SET = [
    *(Law(equation, product) for equation, products in LAWS_OF.items() for product in products),
    *(Law(reading, product) for reading, products in SENSOR_LAWS_OF.items() for product in products),
    *(Law(equation, Product(Factor("sin_t"))) for equation in SWINGING),
    ALONG_X,
]
NAMES = [name for name in REGRESSOR_CODE if name != "1"]
# Quarters, so that sums of powers are exact.
FACTORS = st.builds(Factor, st.sampled_from(NAMES), st.integers(-16, 16).map(lambda part: part / 4.0), st.booleans())
PRODUCTS = st.one_of(
    st.just(Product(Factor("1"))),
    FACTORS.map(Product),
    st.tuples(FACTORS, FACTORS).filter(lambda pair: pair[0].name != pair[1].name).map(lambda pair: Product(*pair)),
)
LAWS = st.builds(Law, st.sampled_from([*EQUATION_CODE, *READING_CODE]), PRODUCTS)


@pytest.mark.parametrize("law", OPEN_SET, ids=lambda law: f"{law.of}~{law.product.text}")
def test_every_law_of_the_open_set_is_read_as_it_was_written(law: Law) -> None:
    """Its text gives the same equation or reading and the same factors; the text of these is the same again."""
    again = Law.parse(law.text, law.of if law.of in READING else None)
    assert again == law
    assert again.text == law.text


@given(LAWS)
def test_any_law_is_read_as_it_was_written(law: Law) -> None:
    """All equations, readings and regressors, powers from -4 to 4, with and without their signs."""
    again = Law.parse(law.text, law.of if law.of in READING else None)
    assert again == law
    assert again.text == law.text


@given(PRODUCTS, st.floats(0.1, 3.0), st.floats(-3.0, -0.1))
def test_text_says_the_values(product: Product, one: float, other: float) -> None:
    """A product is, up to rounding, what its text says if Python reads it, with bars as amounts and ^ as powers."""
    values = {name: np.array([one if code % 2 else other]) for name, code in REGRESSOR_CODE.items()}
    values["1"] = np.ones(1)
    said = 1.0
    for written in product.text.split("*"):
        name, _, power = written.partition("^")
        base = values[name.strip("|")][0]
        said *= (abs(base) if "|" in name else base) ** float(power or 1.0)
    assert product.along(values)[0] == pytest.approx(said, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "codes"),
    [
        ("u*v", (("u", 1.0, 1.0), ("v", 1.0, 1.0))),
        ("|u|^0.5*u", (("u", 1.5, 1.0), ("1", 1.0, 1.0))),
        ("|u|^-1*u", (("u", 0.0, 1.0), ("1", 1.0, 1.0))),
        ("|u|", (("u", 1.0, 0.0), ("1", 1.0, 1.0))),
        ("x*x", (("x", 2.0, 0.0), ("1", 1.0, 1.0))),
        ("x^2", (("x", 2.0, 0.0), ("1", 1.0, 1.0))),
        ("u*u*u", (("u", 3.0, 1.0), ("1", 1.0, 1.0))),
        ("|u|*v", (("u", 1.0, 0.0), ("v", 1.0, 1.0))),
        ("|x|^2*x", (("x", 3.0, 1.0), ("1", 1.0, 1.0))),
        ("1", (("1", 1.0, 1.0), ("1", 1.0, 1.0))),
    ],
)
def test_products_and_powers_become_codes(text: str, codes: tuple[tuple[str, float, float], ...]) -> None:
    """The power of the amount adds up, the sign counts where an odd number of signed factors is left."""
    numbers = Law.parse(f"unknown:heave~{text}").codes
    assert next(iter(numbers)) == "equation" and numbers.pop("equation") == 2.0
    expected = {
        f"{part}_{place}": number
        for place, (name, *rest) in enumerate(codes, 1)
        for part, number in zip(("regressor", "power", "signed"), (REGRESSOR_CODE[name], *rest), strict=True)
    }
    assert numbers == expected


@pytest.mark.parametrize(
    ("text", "reading", "unit"),
    [
        ("unknown:heave~u*u", None, "N/((m/s)^2)"),
        ("unknown:yaw~|r|^-1*r", None, "N m"),
        ("unknown:world_x~|u|^0.5*u", None, "N/((m/s)^1.5)"),
        ("unknown:surge~v*r", None, "N/((m/s) (rad/s))"),
        ("unknown:compass~|thrust|*sin_yaw", None, "rad/((N))"),
        ("unknown:imu~t", "accel_x", "m/s^2/((s))"),
        ("unknown:imu~t", "gyro_z", "rad/s/((s))"),
    ],
)
def test_units_of_coefficients(text: str, reading: str | None, unit: str) -> None:
    """What is in proportion over the units of the factors."""
    assert Law.parse(text, reading).unit == unit


def test_order_makes_no_difference() -> None:
    """Equal laws have the same factors; other powers, signs or equations are other laws."""
    one, other = Factor("v"), Factor("u", 1.0, False)
    assert Product(one, other) == Product(other, one)
    assert hash(Product(one, other)) == hash(Product(other, one))
    assert Product(one, other).text == Product(other, one).text == "|u|*v"
    assert Product(one) != Product(Factor("v", 2.0)) != Product(Factor("v", 2.0, False))
    assert Law("surge", Product(one)) != Law("sway", Product(one))
    assert Product(one) != "v"


def test_a_law_of_a_topic_with_several_readings_is_said_with_its_reading() -> None:
    """The text names the topic alone."""
    law = Law("accel_y", Product(Factor("u")))
    assert (law.topic, law.text) == ("imu", "unknown:imu~u")
    assert subject_and_product(law.text) == ("imu", law.product)
    with pytest.raises(CocorosimError, match="add which one: gyro_z, accel_x, accel_y, accel_z"):
        Law.parse(law.text)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("linear_drag", "'linear_drag' is no law; write it as 'unknown:heave~u\\*u'"),
        ("unknown:heave", "no law"),
        ("unknown:pitch~u", "no law"),
        ("unknown:heave~q", "the factor 'q', no regressor; write 1, x, y"),
        ("unknown:heave~", "the factor '', no regressor"),
        ("unknown:heave~yaw", "the factor 'yaw'"),
        ("unknown:heave~|u*v", "the factor '\\|u'"),
        ("unknown:heave~u^two", "the power 'two'; write a number"),
        ("unknown:heave~u*v*w", "has 3 regressors; a law has one or two"),
    ],
)
def test_other_text_is_refused(text: str, words: str) -> None:
    """In a sentence that says what is wrong and what is right."""
    with pytest.raises(CocorosimError, match=words):
        Law.parse(text)


def test_a_law_is_of_an_equation_or_a_reading() -> None:
    """A topic alone is neither."""
    with pytest.raises(CocorosimError, match="neither an equation nor a reading; write one of surge, sway"):
        Law("imu", Product(Factor("u")))


def test_codes_are_places_in_the_tables() -> None:
    """As they stand in platform files that exist: an order that must not change."""
    assert list(EQUATION_CODE) == ["surge", "sway", "heave", "yaw", "world_x", "world_y", "world_z"]
    assert list(READING_CODE)[:7] == ["pose_x", "pose_y", "pose_z", "pose_yaw", "compass", "pressure", "gyro_z"]
    assert [REGRESSOR_CODE[part.name] for part in REGRESSORS] == list(range(20))
    assert Law("compass", Product(Factor("thrust", 1.0, False))).codes["reading"] == 4.0
