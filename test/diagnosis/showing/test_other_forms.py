"""A law that bends a named effect is another form of it, and no cause of its own."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming
from cocorosim_ros.diagnosis.showing import other_forms
from cocorosim_ros.diagnosis.showing.other_forms import without_other_forms


def named(name: str, nats: float, law: str | None = None, robots: tuple[str, ...] = ("a",)) -> NamedEffect:
    """A named effect of motion; with a law it stands outside the catalogue."""
    entry = SimpleNamespace(id=name, law=law, channel="heave")
    candidate: Any = SimpleNamespace(entry=entry, robots=robots, key=(name, None, robots))
    return NamedEffect(candidate, nats, (), HeldOutGain(np.zeros(1), 0.01))


DRAG = named("anisotropic_drag", 100.0)
SHARE, ALIKE = 100.0 * NAMING.law_form, NAMING.alike


@pytest.mark.parametrize(
    ("law", "alike", "is_form"),
    [
        (named("unknown:heave~|w|^2*w", 0.9 * SHARE, "heave"), 1.1 * ALIKE, True),
        (named("unknown:heave~|w|^2*w", 1.1 * SHARE, "heave"), 1.1 * ALIKE, False),
        (named("unknown:heave~u*x", 0.9 * SHARE, "heave"), 0.9 * ALIKE, False),
        (named("unknown:heave~|w|^2*w", 0.9 * SHARE, "heave", ("b",)), 1.1 * ALIKE, False),
        (named("linear_drag", 0.9 * SHARE), 1.1 * ALIKE, False),
    ],
)
def test_what_is_another_form(law: NamedEffect, alike: float, is_form: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """A law of the same robots that changes the readings much alike and explains less; an entry of the catalogue never.

    What is taken back is told with the effect of which it is another form, and nothing is missing for it.
    """

    def gone(naming: Naming, effect: NamedEffect, robots: tuple[str, ...]) -> tuple[Naming, NamedEffect]:
        assert robots == effect.candidate.robots
        return replace(naming, named=tuple(each for each in naming.named if each is not effect)), effect

    monkeypatch.setattr(other_forms, "likeness", lambda fit, one, other: alike)
    monkeypatch.setattr(other_forms, "taken_back", gone)
    monkeypatch.setattr(other_forms, "fitted", lambda fit: ())
    monkeypatch.setattr(
        other_forms, "found_effects", lambda fit, every, numbers: [each.candidate.entry.id for each in every]
    )
    fit: Any = "fit"
    left, passed = without_other_forms(Naming(fit, fit, (DRAG, law), (), ()))
    assert [each.candidate.entry.id for each in left.named] == ["anisotropic_drag", law.candidate.entry.id][
        : 2 - is_form
    ]
    assert [(each.found, each.stands) for each in passed] == [(law.candidate.entry.id, False)] * is_form
    assert all("'anisotropic_drag'" in sentence for each in passed for sentence in each.because)
