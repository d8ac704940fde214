"""Gains of thrusters that differ from one part of the recordings to the next, which no model here has.

A thruster that loses a blade halfway is no weak thruster: one number for all of the recording is wrong everywhere, and
no law that a random force may follow puts it right, so that free runs reach a floor that is as high as their error.
Other numbers change no less from part to part where a model is wrong, but say nothing of why. Nor does a gain that
differs by more than itself: what one part tells of it is then hardly anything.
"""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.criteria.showing import UNSTEADY
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM
from cocorosim_ros.diagnosis.showing.form_width import variances_in_time
from cocorosim_ros.diagnosis.tracks.columns import OWN_GAINS

GAINS_OF_THRUST = frozenset((*OWN_GAINS, "thrust_gain"))


def unsteady_numbers(fit: Fit) -> tuple[str, ...]:
    """Sentences on the platform's gains of thrusters that differ much in time, the one that differs most first."""
    told = []
    for unknown, q, variance in zip(fit.unknowns, fit.q.tolist(), variances_in_time(fit).tolist(), strict=True):
        if unknown.owner.effect == PLATFORM and unknown.column in GAINS_OF_THRUST:
            share = math.sqrt(variance) * abs(unknown.slope(q) / unknown.value(q))
            told.append((share if share < UNSTEADY.most else 0.0, unknown.owner))
    most = max((share for share, _ in told), default=0.0)
    clear = [(share, owner) for share, owner in told if share > max(UNSTEADY.material, UNSTEADY.beside * most)]
    return tuple(
        f"{parameter_words(owner.parameter).capitalize()} of {', '.join(owner.robots)} differs by {share:.0%} "
        "(standard deviation) from one part of the recordings to the next, more than noise makes: it changes while the "
        "vehicle is under way, and one number is right for no part."
        for share, owner in sorted(clear, key=lambda each: -each[0])
    )
