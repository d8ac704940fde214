"""The vehicle as its recordings show it when it was well: recalibrated, with every effect that earns its place.

None of it is named. What a catalogue of effects says of the vehicle is at best a likeness; here it only has to foretell
the recordings of the same vehicle, so that nothing but differences is left to be named.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.against.numbers import curve_entries
from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.against import LEARNING
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.screening import Screen
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Unknown
from cocorosim_ros.diagnosis.naming.contest import begin
from cocorosim_ros.diagnosis.naming.naming import name_effects
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.naming.single_thrusters import thruster_entries

LEARNED = "learned"
"""Owner of the numbers that the vehicle has beside the platform's: an effect's name and number are its parameter."""


def learned_vehicle(base: Fit, progress: Callable[[str, float], None]) -> Fit:
    """Learn the vehicle from its recalibrated fit `base`."""
    fit = name_effects(base, progress).fit
    fit = replace(fit, unknowns=tuple(map(_nameless, fit.unknowns)))
    for _ in range(LEARNING.most):
        richer = _richer(fit)
        if richer is None:
            break
        fit = replace(richer, unknowns=tuple(map(_nameless, richer.unknowns)))
    return settled(fit, LEARNING.turns)


def learned_effects(fit: Fit) -> tuple[str, ...]:
    """Names of the effects that a learned vehicle has beside the platform's own numbers, in the order of learning."""
    owners = [unknown.owner for unknown in fit.unknowns if unknown.owner.effect == LEARNED]
    return tuple(dict.fromkeys(owner.parameter.rpartition(".")[0] for owner in owners))


def without_last(fit: Fit) -> Fit:
    """Take the effect that was learned last out of a learned vehicle, and fit the rest anew."""
    gone = f"{learned_effects(fit)[-1]}."
    stays = np.array([not _is_of(unknown, gone) for unknown in fit.unknowns], dtype=bool)
    unknowns = tuple(unknown for unknown in fit.unknowns if not _is_of(unknown, gone))
    return settled(evaluated(replace(fit, unknowns=unknowns, q=fit.q[stays])), LEARNING.turns)


def _is_of(unknown: Unknown, effect: str) -> bool:
    owner = unknown.owner
    return owner.effect == LEARNED and owner.parameter.startswith(effect)


def _nameless(unknown: Unknown) -> Unknown:
    """Give a number of an effect to the learned vehicle."""
    owner = unknown.owner
    if owner.effect in (PLATFORM, LEARNED):
        return unknown
    return replace(unknown, owner=replace(owner, effect=LEARNED, parameter=f"{owner.effect}.{owner.parameter}"))


def _richer(fit: Fit) -> Fit | None:
    """Add the effect that explains most, of those without shapes, to all robots; None if none explains enough."""
    scene = scene_of(fit.tracks, smoothed_tracks(fit), drag_form_of(fit))
    screen = Screen(fit, scene)
    taken = {unknown.column for unknown in fit.unknowns}
    tested = [screen.test(each) for each in _candidates(fit) if not taken & _columns(each)]
    for best in sorted(tested, key=lambda each: -each.nats):
        if best.nats < LEARNING.worth:
            return None
        begun = begin(fit, best, scene)
        if begun.gain > LEARNING.worth:
            return begun.fit
    return None


def _candidates(fit: Fit) -> list[Candidate]:
    """Make candidates of entries without shapes and of thrusters' own gains and curves, each for all its robots."""
    own = (*thruster_entries(fit.tracks), *curve_entries(fit.tracks))
    plain = [entry for entry in (*ENTRIES, *own) if not entry.shapes]
    widest: dict[int, Candidate] = {}
    for candidate in expand(plain, fit.tracks, fit.rows):
        widest.setdefault(id(candidate.entry), candidate)
    return list(widest.values())


def _columns(candidate: Candidate) -> set[str]:
    return {amplitude.column for amplitude in candidate.entry.amplitudes}
