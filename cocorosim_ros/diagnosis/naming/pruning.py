"""Removal of effects from a fit: those that the others have made superfluous, and the weakest one."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.climbing import improved, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.foretelling.gains import FreeRuns, rows_without_held_out
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen
from cocorosim_ros.diagnosis.naming.choice import harms, moves
from cocorosim_ros.diagnosis.naming.contest import log_evidence
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming, Refused, Stage, onsets_of
from cocorosim_ros.diagnosis.naming.needed_evidence import held_against, needed_nats
from cocorosim_ros.diagnosis.tracks.columns import WATER_RANDOM

Key = tuple[str, str | None, tuple[str, ...]]


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
    return improved(with_noise(smaller, 2, WATER_RANDOM), 2)


def pruned(stage: Stage, base: Fit, known: tuple[NamedEffect, ...] = (), unseen: Unseen | None = None) -> Stage:
    """Take back effects that the others have made superfluous, the weakest first; return the fit and what is left.

    base: the recalibrated fit, before any effect was named; known: the effects that it has already. unseen: parts on
    which no effect may make free runs worse; the one that harms most is taken back before any other.
    """
    fit, named, gone = stage
    while len(named) > 1:
        whole = log_evidence(fit)
        smaller = {effect.candidate.key: without(fit, effect.candidate, base) for effect in named}
        named = tuple(_measured(effect, whole, smaller[effect.candidate.key], fit) for effect in named)
        named = _run_freely(named, fit, smaller, unseen) if unseen is not None else named
        needed = {effect.candidate.key: needed_nats((*known, *named), effect.candidate, fit) for effect in named}
        harmful = _harmful(named)
        weakest = harmful or min(named, key=lambda effect: effect.nats / needed[effect.candidate.key])
        if harmful is None and weakest.nats >= needed[weakest.candidate.key]:
            break
        if weakest.nats >= needed[weakest.candidate.key]:
            gone = (*gone, Refused(fit, weakest))
        fit, named = smaller[weakest.candidate.key], _others(named, weakest)
    return Stage(fit, named, gone)


def _run_freely(
    named: tuple[NamedEffect, ...], fit: Fit, smaller: Mapping[Key, Fit], unseen: Unseen
) -> tuple[NamedEffect, ...]:
    """Measure anew what free runs gain by each effect that moves; smaller: the fits without one of them."""
    runs = FreeRuns(unseen, fit.filled)
    onsets = onsets_of(named)
    whole = runs.errors(rows_without_held_out(fit, unseen.splits, onsets))

    def measured(effect: NamedEffect) -> NamedEffect:
        less = runs.errors(rows_without_held_out(smaller[effect.candidate.key], unseen.splits, onsets))
        return replace(effect, foretold=runs.gain(less, whole))

    return tuple(measured(effect) if moves(effect.candidate) else effect for effect in named)


def _harmful(named: tuple[NamedEffect, ...]) -> NamedEffect | None:
    """Find the effect that makes free runs worst, of those that make them worse."""
    worse = [
        (effect.foretold.mean, effect)
        for effect in named
        if effect.foretold is not None and harms(effect.candidate, effect.foretold)
    ]
    return min(worse, key=lambda pair: pair[0])[1] if worse else None


def _measured(effect: NamedEffect, whole: float, smaller: Fit, fit: Fit) -> NamedEffect:
    """Measure the evidence of an effect anew: `whole`, the log evidence of `fit`, less that of the fit without it."""
    return replace(effect, nats=whole - log_evidence(smaller) - held_against(effect.candidate, smaller, fit))


def without_least(naming: Naming) -> Naming:
    """Take back the effect that speaks least for itself, and fit the rest anew: see `_worth`."""
    least = min(naming.named, key=_worth)
    fit = without(naming.fit, least.candidate, naming.base)
    return replace(naming, fit=fit, named=_others(naming.named, least))


def taken_back(naming: Naming, effect: NamedEffect, robots: Collection[str]) -> tuple[Naming, NamedEffect]:
    """Take back an effect from some robots or from all, and fit the rest anew; also what was taken back.

    What was taken back has the evidence by which the model is worse without it; what stays has the rest of it.
    """
    gone = effect.candidate.of_robots(robots)
    fit = without(naming.fit, gone, naming.base)
    lost = log_evidence(naming.fit) - log_evidence(fit) - held_against(gone, fit, naming.fit)
    left = [robot for robot in effect.candidate.robots if robot not in robots]
    others = _others(naming.named, effect)
    if left:
        stays = effect.candidate.of_robots(left)
        others = (*others, replace(effect, candidate=stays, nats=effect.nats - lost))
        fit = replace(fit, unknowns=tuple(_of_fewer(each, effect.candidate, stays) for each in fit.unknowns))
    return replace(naming, fit=fit, named=others), replace(effect, candidate=gone, nats=lost)


def _of_fewer(unknown: Unknown, before: Candidate, after: Candidate) -> Unknown:
    """Give a number that all robots of a candidate had in common to those that are left of them."""
    if not before.owns(unknown) or unknown.owner.robots != before.robots:
        return unknown
    return replace(unknown, owner=replace(unknown.owner, robots=after.robots), tracks=after.everybody)


def _worth(effect: NamedEffect) -> tuple[int, float]:
    """Rank of an effect: what free runs lose by, then errors of readings by their evidence, then what they gain by."""
    if effect.foretold is None:
        return 1, effect.nats
    return (2 if effect.foretold.mean > 0.0 else 0), effect.foretold.mean


def _others(named: tuple[NamedEffect, ...], gone: NamedEffect) -> tuple[NamedEffect, ...]:
    return tuple(effect for effect in named if effect.candidate.key != gone.candidate.key)
