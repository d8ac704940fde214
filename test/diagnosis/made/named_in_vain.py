"""Cases in which an effect is named that has no evidence at all."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np


def case_of(base: Any, effect_id: str, *, declared_form: bool = False, topic: str | None = None) -> Any:
    """A finished diagnosis that names one effect, at the numbers with which it does nothing, on top of a base fit.

    topic: of the effect, where it is told by topics.
    """
    from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
    from cocorosim_ros.diagnosis.fitting.candidate import expand
    from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
    from cocorosim_ros.diagnosis.showing.case import Case
    from cocorosim_ros.diagnosis.showing.estimates import fitted, found_effects

    entry = next(each for each in ENTRIES if each.id == effect_id and topic in (None, each.topic))
    effect = NamedEffect(expand([entry], base.tracks, base.rows)[0], 9.0, (), HeldOutGain(np.zeros(1), 0.5))
    unknowns = (*base.unknowns, *effect.candidate.amplitudes())
    final = replace(base, unknowns=unknowns, q=np.concatenate([base.q, np.zeros(len(unknowns) - len(base.unknowns))]))
    found = found_effects(final, [effect], fitted(final))
    return Case(final, [effect], found, smoothed_tracks(base), {}, base, declared_form)
