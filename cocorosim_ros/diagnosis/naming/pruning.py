"""Removal of effects from a fit: those that the others have made superfluous, and the weakest one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.climbing import improved, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.naming.contest import log_evidence
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming
from cocorosim_ros.diagnosis.naming.needed_evidence import held_against, needed_nats
from cocorosim_ros.diagnosis.tracks.columns import WATER_NOISE


def without(fit: Fit, candidate: Candidate, base: Fit) -> Fit:
    """Take the unknowns of a candidate out of a fit, and fit the rest and the noise of the water anew.

    What the candidate explained must then pass for random force. So the fit goes on from its own noise or from that of
    `base`, a model before the candidate, whichever has the greater objective.
    """
    stays = np.array([not candidate.owns(unknown) for unknown in fit.unknowns], dtype=bool)
    unknowns = tuple(unknown for unknown in fit.unknowns if not candidate.owns(unknown))
    smaller = evaluated(replace(fit, unknowns=unknowns, q=fit.q[stays]))
    noisy = evaluated(replace(smaller, q_noise=base.q_noise))
    smaller = improved(max(smaller, noisy, key=lambda each: each.objective), 2)
    return improved(with_noise(smaller, 2, WATER_NOISE), 2)


def pruned(
    fit: Fit, named: tuple[NamedEffect, ...], base: Fit, known: tuple[NamedEffect, ...] = ()
) -> tuple[Fit, tuple[NamedEffect, ...]]:
    """Take back effects that the others have made superfluous, the weakest first; return the fit and what is left.

    base: the recalibrated fit, before any effect was named; known: the effects that it has already.
    """
    while len(named) > 1:
        whole = log_evidence(fit)
        smaller = {effect.candidate.key: without(fit, effect.candidate, base) for effect in named}
        named = tuple(_measured(effect, whole, smaller[effect.candidate.key], fit) for effect in named)
        needed = {effect.candidate.key: needed_nats((*known, *named), effect.candidate, fit) for effect in named}
        weakest = min(named, key=lambda effect: effect.nats / needed[effect.candidate.key])
        if weakest.nats >= needed[weakest.candidate.key]:
            break
        fit, named = smaller[weakest.candidate.key], _others(named, weakest)
    return fit, named


def _measured(effect: NamedEffect, whole: float, smaller: Fit, fit: Fit) -> NamedEffect:
    """Measure the evidence of an effect anew: `whole`, the log evidence of `fit`, less that of the fit without it."""
    return replace(effect, nats=whole - log_evidence(smaller) - held_against(effect.candidate, smaller, fit))


def without_weakest(naming: Naming) -> Naming:
    """Take back the effect that has the least evidence, and fit the rest anew."""
    weakest = min(naming.named, key=lambda effect: effect.nats)
    fit = without(naming.fit, weakest.candidate, naming.base)
    return replace(naming, fit=fit, named=_others(naming.named, weakest))


def _others(named: tuple[NamedEffect, ...], gone: NamedEffect) -> tuple[NamedEffect, ...]:
    return tuple(effect for effect in named if effect.candidate.key != gone.candidate.key)
