"""Laws that are another form of a named effect: each cause gets one name.

A cause of another form than the catalogue's law, as drag that saturates, is named by that law; a law outside the
catalogue may then explain what the form leaves, as the cube of a speed does beside its square. The two change the same
readings, so that the second is no cause of its own. It is taken back, and what the first then leaves widens its
interval (`form_width`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.findings import PassedOver
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming
from cocorosim_ros.diagnosis.naming.needed_evidence import likeness
from cocorosim_ros.diagnosis.showing.doubt import stands_without_name
from cocorosim_ros.diagnosis.showing.withdrawn import withdrawn

OTHER_FORM = "it is another form of a named effect"
OF_NO_NAME = (
    "It looked like another form of an effect that did not keep its name either: something is missing, and these two "
    "do not say what."
)
SHORTLY_OF_NO_NAME = "what it was taken for another form of has no name either"


class OtherForm(NamedTuple):
    """A law, and the named effect of which it is most likely another form."""

    law: NamedEffect
    effect: NamedEffect


class TakenBack(NamedTuple):
    """A law that was taken back, as it is told, and the effect of which it was taken for another form."""

    told: PassedOver
    law: NamedEffect
    effect: str


def without_other_forms(naming: Naming) -> tuple[Naming, tuple[TakenBack, ...]]:
    """Take back the laws that are another form of a named effect, the weakest first, and fit the rest anew."""
    passed: list[TakenBack] = []
    while (found := _weakest_other_form(naming)) is not None:
        law, effect = found
        left, gone, told = withdrawn(naming, law, law.candidate.robots)
        name = effect.candidate.entry.id
        because = (
            f"It changes the readings much as '{name}' does, and explains less than that: it is most likely no cause "
            "of its own, but says that the law of that effect has another form here.",
        )
        passed += [TakenBack(PassedOver(each, False, because, OTHER_FORM), gone, name) for each in told]
        naming = left
    return naming, tuple(passed)


def told_at_last(naming: Naming, forms: Sequence[TakenBack]) -> tuple[PassedOver, ...]:
    """Tell of what was taken back; something is missing where the effect itself has lost its name since."""
    named = {each.candidate.entry.id for each in naming.named}
    return tuple(
        each.told
        if each.effect in named
        else replace(each.told, stands=stands_without_name(each.law), because=(OF_NO_NAME,), shortly=SHORTLY_OF_NO_NAME)
        for each in forms
    )


def _weakest_other_form(naming: Naming) -> OtherForm | None:
    """Find the law of least evidence that is another form of a named effect; None if there is none."""
    laws = [each for each in naming.named if each.candidate.entry.law is not None and moves(each.candidate)]
    entries = [each for each in naming.named if each.candidate.entry.law is None and moves(each.candidate)]
    found = [OtherForm(law, entry) for law in laws for entry in entries if _is_other_form(naming.fit, law, entry)]
    return min(found, key=lambda each: each.law.nats) if found else None


def _is_other_form(fit: Fit, law: NamedEffect, effect: NamedEffect) -> bool:
    """Tell whether a law is a rest of an effect by its evidence, and acts on no other robots, in much the same way."""
    if law.nats >= NAMING.law_form * effect.nats or not set(law.candidate.robots) <= set(effect.candidate.robots):
        return False
    return likeness(fit, law.candidate, effect.candidate) > NAMING.alike
