"""Laws in words in a platform file: the numbers they become, the words that come back, and what is refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.reading.law_text import LawText
from cocorosim_ros.world.laws.laws_of_platform import effects_of, in_words
from cocorosim_ros.world.sensors.law import SENSOR_LAWS
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE
from cocorosim_ros.world.vehicle_model.platform_effects import check_platform, parameter_row
from cocorosim_ros.world.vehicle_model.vehicles import PARAMETER_COLUMNS

LILY = load_platform("lily")
HEAD = "name: boat\ndescription: a boat\nbased_on: lily\neffects:\n"


def boat(folder: Path, effects: str) -> Platform:
    """Lily with these effects, read from a file."""
    path = folder / "boat.yaml"
    path.write_text(HEAD + effects, encoding="utf-8")
    return load_platform(path)


def test_words_become_the_numbers_of_the_effect(tmp_path: Path) -> None:
    """A quadratic drag with its sign, by hand: code 0 is surge, power 2, signed; numbers beside it stay."""
    text = (
        '  law_1:\n    surge: {value: "-0.5 * |u| * u", source: test}\n    omega: {value: 2, unit: rad/s, source: t}\n'
    )
    platform = boat(tmp_path, text)
    check_platform(platform)
    law = effects_of(platform)["law_1"]
    assert (law["coefficient"], law["equation"], law["omega"]) == (-0.5, 0.0, 2.0)
    assert (law["regressor_1"], law["power_1"], law["signed_1"]) == (REGRESSOR_CODE["u"], 2.0, 1.0)
    assert parameter_row(platform)[PARAMETER_COLUMNS["law_1.coefficient"]] == -0.5


def test_words_and_codes_are_one_platform(tmp_path: Path) -> None:
    """The same row of numbers, whichever way a law is written."""
    codes = "".join(
        f'    {name}: {{value: {value}, unit: "1", source: test}}\n'
        for name, value in {
            "coefficient": 3e-4,
            "equation": 3,
            "regressor_1": REGRESSOR_CODE["w"],
            "signed_1": 0,
        }.items()
    )
    said = boat(tmp_path, '  law_2:\n    yaw: {value: "3e-4 * |w|", source: test}\n')
    coded = boat(tmp_path, f"  law_2:\n{codes}")
    np.testing.assert_array_equal(parameter_row(said), parameter_row(coded))


@given(
    st.floats(-1e3, 1e3, allow_nan=False).filter(bool), st.sampled_from(["u", "|r|", "u*u", "|v|^0.5*v", "thrust*r"])
)
def test_words_come_back(coefficient: float, product: str) -> None:
    """The words of a law's numbers say the same law with the same number to the last bit."""
    law = {"heave": LawText(coefficient, product)}
    of, law = in_words(effects_of(replace(LILY, effect_quantities={"law_1": law}))["law_1"])
    assert (of, law.coefficient) == ("heave", coefficient)
    assert law.product.replace(" ", "") == product or sorted(law.product.split(" * ")) == sorted(product.split("*"))


@pytest.mark.parametrize(
    ("effects", "words"),
    [
        ('  law_1: {surge: "-0.5 * u"}\n', "without a source"),
        ('  law_1:\n    surge: {value: "-0.5 * q", source: test}\n', "'q'"),
        ('  law_1:\n    surge: {value: "2 * u", source: a}\n    sway: {value: "2 * v", source: a}\n', "one of 2 laws"),
        ('  law_1:\n    compass: {value: "2 * u", source: a}\n', "write one of surge"),
        ('  torque_bias:\n    yaw: {value: "2 * u", source: a}\n', "write it below law_1"),
        ('  law_1:\n    yaw: {value: "2 * u", source: a}\n    coefficient: {value: 2, unit: "1", source: a}\n', "out"),
        ('  law_1:\n    yaw: {value: "2 * u", unit: N, source: a}\n', "unit"),
    ],
)
def test_refused(effects: str, words: str, tmp_path: Path) -> None:
    """A law without a source, of no regressor, doubled, of nothing, elsewhere, beside codes, with a unit."""
    with pytest.raises(CocorosimError, match=r"boat\.yaml") as error:
        check_platform(boat(tmp_path, effects))
    assert words in str(error.value)


def test_sensor_laws_are_of_readings(tmp_path: Path) -> None:
    """The place decides: a law of a reading stands below a sensor law alone."""
    platform = boat(tmp_path, '  sensor_law_1:\n    pressure: {value: "-500 * speed * speed", source: test}\n')
    check_platform(platform)
    law = effects_of(platform)["sensor_law_1"]
    assert set(law) <= {part.name for part in SENSOR_LAWS["sensor_law_1"]}
    assert (law["coefficient"], law["power_1"], law["signed_1"]) == (-500.0, 2.0, 0.0)
