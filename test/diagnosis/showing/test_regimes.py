"""Sentences on parts unlike the fitted ones: in the units of the tables, and of a height where that is meant."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span
from cocorosim_ros.diagnosis.foretelling.regimes import QUANTITIES
from cocorosim_ros.diagnosis.showing import regimes

NAMES = [quantity.name for quantity in QUANTITIES]


def said(monkeypatch: pytest.MonkeyPatch, name: str, fitted: float, held: float) -> str:
    """The sentence where a quantity is another in the second half of a recording, which is held out."""
    values = np.zeros((20, len(QUANTITIES)))
    values[:, NAMES.index(name)] = np.repeat([fitted, held], 10) * np.tile([0.99, 1.0], 10)
    monkeypatch.setattr(regimes, "regimes_along", lambda track, course: values)
    split = SimpleNamespace(seen=[Span(0, 10)], held=[Span(10, 20)])
    unseen: Any = SimpleNamespace(tracks=[None], courses=[None], splits=[split])
    return next((sentence for key, sentence in regimes.unlike_regimes(unseen).items() if f" {key} is" in sentence), "")


@pytest.mark.parametrize(
    ("name", "fitted", "held", "words"),
    [
        ("turn rate", 0.02, 0.08, "their median turn rate is 4.56\u00b0/s, the middle half"),
        ("speed", 0.5, 0.05, "their median speed is 49.8 mm/s, the middle half"),
        (
            "depth",
            -1.2,
            -1.71,
            "their median height is 1.70 m, the middle half of the fitted parts lies between 1.19 m",
        ),
        ("depth", 0.2, 0.44, "their median depth is 438 mm, the middle half"),
    ],
)
def test_units_are_those_of_the_tables(
    monkeypatch: pytest.MonkeyPatch, name: str, fitted: float, held: float, words: str
) -> None:
    """Degrees and millimetres; a depth below nothing is a height."""
    assert words in said(monkeypatch, name, fitted, held)
    assert said(monkeypatch, name, fitted, fitted) == ""
