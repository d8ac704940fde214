"""A form of the drag that the platform's file denies, and that would explain more than all that is named.

A form that the file declares is taken as it is. But the declared form may be wrong, and what it leaves then becomes
laws of speeds and turn rates with much evidence, or the numbers of drag shift. So the other forms are asked at last,
each without any of what is named. Where one explains more, what is named is suspected at most, and the form is told.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from cocorosim_ros.diagnosis.criteria.fitting import DRAG_FORMS
from cocorosim_ros.diagnosis.fitting.drag_forms import other_forms
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.naming.contest import log_evidence
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of


def untold_form(case: Case) -> Iterator[Objection]:
    """Object to effects of motion, or to shifted numbers alone, where another form of the drag explains more."""
    named = any(moves(effect.candidate) for _, effect in effects_of(case))
    if case.base is None or not (named or (case.declared_form and not case.named)):
        return
    explained, clear = log_evidence(case.final), 0.0 if named else DRAG_FORMS.clear
    needed = explained - log_evidence(case.base) + clear
    if not math.isfinite(needed):  # a model that ran away
        return
    ahead = {name: log_evidence(fit) - explained for name, fit in other_forms(case.base, needed).items()}
    name = max(ahead, key=lambda each: ahead[each], default="")
    if name and ahead[name] > clear:
        than = "by all that is named" if named else "in the form of drag that the platform's file declares"
        yield Objection(
            f"With 'drag_form: {name}' in the platform's file these recordings would be explained better than {than}, "
            f"by {ahead[name]:.0f} nats: write that form, or none, and diagnose again."
        )
