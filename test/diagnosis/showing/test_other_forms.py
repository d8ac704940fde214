"""A law that bends a named effect is another form of it, and no cause of its own."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.findings import PassedOver
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming
from cocorosim_ros.diagnosis.showing import other_forms
from cocorosim_ros.diagnosis.showing.other_forms import TakenBack, told_at_last, without_other_forms
from cocorosim_ros.diagnosis.showing.withdrawn import Withdrawn


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
        (named("unknown:heave~|w|^2*w", 0.9 * SHARE, "heave", ("a", "b")), 1.1 * ALIKE, False),
        (named("linear_drag", 0.9 * SHARE), 1.1 * ALIKE, False),
    ],
)
def test_what_is_another_form(law: NamedEffect, alike: float, is_form: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """A law of the same robots that changes the readings much alike and explains less; an entry of the catalogue never.

    What is taken back is told with the effect of which it is another form, and nothing is missing for it.
    """

    def gone(naming: Naming, effect: NamedEffect, robots: tuple[str, ...]) -> Withdrawn:
        assert robots == effect.candidate.robots
        told: Any = (effect.candidate.entry.id,)
        return Withdrawn(
            replace(naming, named=tuple(each for each in naming.named if each is not effect)), effect, told
        )

    monkeypatch.setattr(other_forms, "likeness", lambda fit, one, other: alike)
    monkeypatch.setattr(other_forms, "withdrawn", gone)
    fit: Any = "fit"
    left, forms = without_other_forms(Naming(fit, fit, (DRAG, law), (), ()))
    passed = [each.told for each in forms]
    assert [each.candidate.entry.id for each in left.named] == ["anisotropic_drag", law.candidate.entry.id][
        : 2 - is_form
    ]
    assert [(each.found, each.stands) for each in passed] == [(law.candidate.entry.id, False)] * is_form
    assert all("'anisotropic_drag'" in sentence for each in passed for sentence in each.because)


@pytest.mark.parametrize(("nats", "is_missing"), [(1.1, True), (0.9, False)])
def test_a_form_of_what_lost_its_name(nats: float, is_missing: bool) -> None:
    """Without the effect something is missing if the law has evidence enough; with it nothing is."""
    law = named("unknown:heave~|w|^2*w", nats * NAMING.threshold, "heave")
    told: Any = PassedOver(Any, False, ("of its own",), other_forms.OTHER_FORM)
    forms = [TakenBack(told, law, "anisotropic_drag")]
    fit: Any = "fit"
    assert told_at_last(Naming(fit, fit, (DRAG,), (), ()), forms) == (told,)
    (alone,) = told_at_last(Naming(fit, fit, (), (), ()), forms)
    assert alone.stands is is_missing and alone.because == (other_forms.OF_NO_NAME,)
