"""Manoeuvres and places in words."""

from __future__ import annotations

from typing import get_args

import pytest

from cocorosim_ros.diagnosis.findings import Concentration, Regime
from cocorosim_ros.diagnosis.report.advice import MANOEUVRES, REGIME_WORDS, manoeuvre_words, where_words


def test_manoeuvres_are_one_sentence_or_none() -> None:
    """Begun with a capital, several behind semicolons."""
    assert manoeuvre_words(["along_wall"]) == MANOEUVRES["along_wall"].capitalize() + "."
    assert manoeuvre_words(["zig_zag", "rest"]) == (
        "Zig-zag at three speeds, turning both ways; lie still for a minute before and after."
    )
    assert manoeuvre_words([]) is None


def test_every_regime_has_words() -> None:
    """One each, all different."""
    assert set(REGIME_WORDS) == set(get_args(Regime))
    assert len(set(REGIME_WORDS.values())) == len(REGIME_WORDS)


@pytest.mark.parametrize(
    ("where", "words"),
    [
        (None, "throughout"),
        (Concentration("deep", 0.876), "mostly when deep (88% of the evidence)"),
        (Concentration("east", 1.3), "mostly in the eastern half (100% of the evidence)"),
    ],
)
def test_a_place_is_told_with_its_share(where: Concentration | None, words: str) -> None:
    """Never more than all of it, although what other regimes lose may make it so."""
    assert where_words(where) == words
