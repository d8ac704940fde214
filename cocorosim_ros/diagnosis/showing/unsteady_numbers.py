"""Numbers of a platform that differ from one part of the recordings to the next, which no model here has.

A thruster that loses a blade halfway is no weak thruster: one number for all of the recording is wrong everywhere, and
no law that a random force may follow puts it right, so that free runs reach a floor that is as high as their error.
"""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.criteria.showing import UNSTEADY
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM
from cocorosim_ros.diagnosis.showing.form_width import variances_in_time


def unsteady_numbers(fit: Fit) -> tuple[str, ...]:
    """Sentences on the numbers of the platform that differ much in time, the one that differs most first."""
    told = []
    for unknown, q, variance in zip(fit.unknowns, fit.q.tolist(), variances_in_time(fit).tolist(), strict=True):
        value = unknown.value(q)
        if unknown.owner.effect == PLATFORM and value != 0.0:
            told.append((math.sqrt(variance) * abs(unknown.slope(q) / value), unknown.owner))
    most = max((share for share, _ in told), default=0.0)
    clear = [(share, owner) for share, owner in told if share > max(UNSTEADY.material, UNSTEADY.beside * most)]
    return tuple(
        f"{parameter_words(owner.parameter).capitalize()} of {', '.join(owner.robots)} differs by {share:.0%} "
        "(standard deviation) from one part of the recordings to the next, more than noise makes: it changes while the "
        "vehicle is under way, and one number is right for no part."
        for share, owner in sorted(clear, key=lambda each: -each[0])
    )
