"""Candidates that no search looks for, and that are asked once all is named."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.screening import Screen
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.naming.contest import Refined, begin, log_evidence, refine
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.showing.case import Case, effects_of


def asked_at_last(fit: Fit, candidate: Candidate) -> Refined:
    """Fit a candidate beside all numbers of a fit, from the best of its starts."""
    scene = scene_of(fit.tracks, smoothed_tracks(fit), drag_form_of(fit))
    screen = Screen(fit, scene)
    return refine(begin(fit, screen.searched(screen.test(candidate)), scene), log_evidence(fit))


class Better(NamedTuple):
    """A candidate that would explain more than all that is named, and by how many nats."""

    tried: Refined
    nats: float


def better_than_named(case: Case, entry: Entry, known: Collection[str], alone: float = math.inf) -> Iterator[Better]:
    """Ask an error of readings that is not looked for, since no other readings show the states `known`.

    It is asked for all robots, in place of all that is named, where any of that is motion; where nothing is named, it
    has to explain more than `alone` nats.
    """
    moving = any(moves(named.candidate) for _, named in effects_of(case))
    if case.base is None or not (moving or (math.isfinite(alone) and not case.named)):
        return
    told = {each.key for each in expand([entry], case.base.tracks, case.base.rows)}
    every = expand([entry], case.base.tracks, case.base.rows, known=known)
    explained = log_evidence(case.final) - log_evidence(case.base) if moving else alone
    for candidate in [each for each in every if each.key not in told and not each.known][:1]:
        tried = asked_at_last(case.base, candidate)
        if tried.nats > explained:
            yield Better(tried, tried.nats - (explained if moving else 0.0))


def value_of(tried: Refined, number: str) -> float:
    """The fitted value of a number of a candidate, for its first robot."""
    places = tried.candidate.places_among(tried.fit.unknowns)
    place = next(each for each in places if tried.fit.unknowns[each].owner.parameter == number)
    return tried.fit.unknowns[place].value(float(tried.fit.q[place]))
