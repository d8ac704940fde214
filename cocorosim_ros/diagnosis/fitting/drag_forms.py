"""The form of a vehicle's quadratic drag where its platform's file does not say it: by total speed, axis or strips.

Fossen and most simulators take |u| u, |v| v, |w| w, Read et al. 2013 the total speed U u, U v, U w. A vehicle of the
one form looked at through the other shows drag between its axes that is not there. So the forms are compared before
anything is called missing, each with ratios of its own between the axes, because only with these a form can show.
Source of the forms: effects.anisotropic_drag.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import DRAG_FORMS
from cocorosim_ros.diagnosis.fitting.climbing import improved, settled, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Owner, Unknown
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, WATER_RANDOM
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects.anisotropic_drag import FORM_BY_NAME, REPLACING, TOTAL_SPEED
from cocorosim_ros.world.vehicle_model.platform_effects import DRAG_FORM, STRIP_LENGTH

RATIOS = ("anisotropic_drag.sway_ratio", "anisotropic_drag.heave_ratio")


class ChosenForm(NamedTuple):
    """The form of the drag, by its word in a platform file, and by how many nats it is ahead of the total speed."""

    name: str
    nats: float


def drag_form_of(fit: Fit) -> float:
    """Code of the form that the rows of a fit have for the drag of the vehicle."""
    return float(fit.rows[0, COLUMN[DRAG_FORM]])


def word_of_form(fit: Fit) -> str:
    """Find the word of a platform file for the form that a fit has chosen; '' for the total speed, which is usual."""
    form = drag_form_of(fit)
    return next((name for name, code in FORM_BY_NAME.items() if code == form != TOTAL_SPEED), "")


def with_best_form(base: Fit, rounds: int) -> tuple[Fit, ChosenForm | None]:
    """Settle the base fit in the form of drag that explains most; None where no form is clearly ahead.

    base: a settled fit of a platform whose file does not say the form; rounds: at most so many turns of settling.
    """
    trials = {name: _trial(base, code) for name, code in FORM_BY_NAME.items()}
    first = trials["total_speed"].objective
    name = max(trials, key=lambda each: trials[each].objective)
    nats = trials[name].objective - first
    if not (math.isfinite(nats) and nats > DRAG_FORMS.clear):
        return base, None
    fit = settled(evaluated(replace(base, rows=_rows(base, FORM_BY_NAME[name]))), rounds)
    return fit, ChosenForm(name, nats)


def other_forms(base: Fit, needed: float) -> dict[str, Fit]:
    """Fit each form of the drag, by its word in a platform file, that the rows of a base fit do not have.

    needed: nats over the base that a form is asked for; one that is far from them with the noise as it was is left out.
    """
    own = drag_form_of(base)
    own = own if own in REPLACING else TOTAL_SPEED  # which a difference between axes may add to, in a form of its own
    begun = {name: _begun(base, code) for name, code in FORM_BY_NAME.items() if code != own}
    least = base.objective + DRAG_FORMS.worth_noise * needed
    return {name: _with_its_noise(fit) for name, fit in begun.items() if fit.objective > least}


def _trial(base: Fit, form: float) -> Fit:
    """Fit one form, and the noise with it."""
    return _with_its_noise(_begun(base, form))


def _begun(base: Fit, form: float) -> Fit:
    """Fit one form with ratios between the axes beside those that the base has, and with the noise of the base."""
    fitted = {(unknown.column, *unknown.tracks) for unknown in base.unknowns}
    ratios = [each for each in _ratios(base.tracks) if (each.column, *each.tracks) not in fitted]
    q = np.concatenate([base.q, np.zeros(len(ratios))])
    start = evaluated(replace(base, rows=_rows(base, form), unknowns=(*base.unknowns, *ratios), q=q))
    return improved(start, DRAG_FORMS.steps)


def _with_its_noise(fit: Fit) -> Fit:
    return improved(with_noise(fit, 1, WATER_RANDOM), DRAG_FORMS.steps)


def _rows(base: Fit, form: float) -> Floats:
    rows = base.rows.copy()
    if form != TOTAL_SPEED or drag_form_of(base) in REPLACING:
        rows[:, COLUMN[DRAG_FORM]] = form
        rows[:, COLUMN[STRIP_LENGTH]] = [track.vehicle.hull for track in base.tracks]
    return rows


def _ratios(tracks: Sequence[Track]) -> list[Unknown]:
    """Unknown ratios between the axes, of each robot, around 1."""
    bound = math.log(DRAG_FORMS.most_ratio)
    return [
        Unknown(
            Owner(PLATFORM, (robot,), column, "1"), column, numbers, 1.0, logarithmic=True, prior=DRAG_FORMS.prior,
            bounds=(-bound, bound),
        )
        for robot, numbers in tracks_by_robot(tracks).items()
        for column in RATIOS
    ]  # fmt: skip
