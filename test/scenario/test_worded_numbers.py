"""Numbers that choose a form may stand in words."""

from __future__ import annotations

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import DRAG_FORMS
from cocorosim_ros.scenario.reading.worded_numbers import WORDS, word_of, worded_number
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.effects.anisotropic_drag import (
    EACH_AXIS,
    EACH_AXIS_STRIPS,
    FORM_BY_NAME,
    OWN_SPEED,
    STRIPS,
    TOTAL_SPEED,
)

FORM = "anisotropic_drag.form"


@pytest.mark.parametrize("key", WORDS)
def test_each_word_is_the_number_of_its_place(key: str) -> None:
    """There and back, bare and with a source, of numbers that effects have; no word reads as a number or a unit."""
    effect, _, name = key.partition(".")
    assert name in {parameter.name for parameter in EFFECTS[effect].parameters}
    for number, word in enumerate(WORDS[key]):
        for text in (word, f"{{value: {word}, source: test, confidence: derived}}"):
            found = worded_number(key, parse_yaml(f"a: {text}", "p.yaml").mapping()["a"])
            assert found is not None and (found.value, found.unit) == (number, "1")
        assert word_of(key, float(number)) == word
    assert word_of(key, 0.5) is None and word_of(key, float(len(WORDS[key]))) is None


def test_the_words_of_the_drag_are_those_of_its_forms() -> None:
    """The whole drag's form has the same word as effect and as key of the platform."""
    codes = (TOTAL_SPEED, OWN_SPEED, STRIPS, EACH_AXIS, EACH_AXIS_STRIPS)
    assert codes == tuple(map(float, range(len(WORDS[FORM]))))
    assert {name: word_of(FORM, code) for name, code in FORM_BY_NAME.items()} == {name: name for name in DRAG_FORMS}


@pytest.mark.parametrize("text", ["3", "3.0 1", '{value: 3, unit: "1", source: test}'])
def test_a_number_is_no_word(text: str) -> None:
    """It is read as any number."""
    assert worded_number(FORM, parse_yaml(f"a: {text}", "p.yaml").mapping()["a"]) is None


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("own_sped", "p.yaml line 1: 'a' has 'own_sped'.*own_speed"),
        ("{value: own_speed}", "lacks 'source'"),
        ('{value: own_speed, unit: "1", source: a}', "'a.unit' is not a known key"),
        ("{value: own_speed, source: a, confidence: sure}", "'a.confidence' has 'sure'"),
    ],
)
def test_wrong_words(text: str, sentence: str) -> None:
    """A word that there is not, no source, a unit, a confidence that there is not."""
    with pytest.raises(CocorosimError, match=sentence):
        worded_number(FORM, parse_yaml(f"a: {text}", "p.yaml").mapping()["a"])
