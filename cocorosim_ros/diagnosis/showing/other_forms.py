"""Laws that are another form of a named effect: each cause gets one name.

A cause of another form than the catalogue's law, as drag that saturates, is named by that law; a law outside the
catalogue may then explain what the form leaves, as the cube of a speed does beside its square. The two change the same
readings, so that the second is no cause of its own. It is taken back, and what the first then leaves widens its
interval (`form_width`).
"""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.findings import PassedOver
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming
from cocorosim_ros.diagnosis.naming.needed_evidence import likeness
from cocorosim_ros.diagnosis.naming.pruning import taken_back
from cocorosim_ros.diagnosis.showing.estimates import fitted, found_effects

OTHER_FORM = "another form of a named effect"


class OtherForm(NamedTuple):
    """A law, and the named effect of which it is most likely another form."""

    law: NamedEffect
    effect: NamedEffect


def without_other_forms(naming: Naming) -> tuple[Naming, tuple[PassedOver, ...]]:
    """Take back the laws that are another form of a named effect, the weakest first, and fit the rest anew."""
    passed: list[PassedOver] = []
    while (found := _weakest_other_form(naming)) is not None:
        law, effect = found
        numbers = fitted(naming.fit)
        fewer, gone = taken_back(naming, law, law.candidate.robots)
        because = (
            f"It changes the readings much as '{effect.candidate.entry.id}' does, and explains less than that: it is "
            "most likely no cause of its own, but says that the law of that effect has another form here.",
        )
        every = found_effects(naming.fit, [gone], numbers)
        passed += [PassedOver(each, False, because, OTHER_FORM) for each in every]
        naming = fewer
    return naming, tuple(passed)


def _weakest_other_form(naming: Naming) -> OtherForm | None:
    """Find the law of least evidence that is another form of a named effect; None if there is none."""
    laws = [each for each in naming.named if each.candidate.entry.law is not None and moves(each.candidate)]
    entries = [each for each in naming.named if each.candidate.entry.law is None and moves(each.candidate)]
    found = [OtherForm(law, entry) for law in laws for entry in entries if _is_other_form(naming.fit, law, entry)]
    return min(found, key=lambda each: each.law.nats) if found else None


def _is_other_form(fit: Fit, law: NamedEffect, effect: NamedEffect) -> bool:
    """Tell whether a law is a rest of an effect by its evidence, and acts on the same robots in much the same way."""
    if law.nats >= NAMING.law_form * effect.nats or set(law.candidate.robots).isdisjoint(effect.candidate.robots):
        return False
    return likeness(fit, law.candidate, effect.candidate) > NAMING.alike
