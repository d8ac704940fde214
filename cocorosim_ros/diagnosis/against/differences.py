"""Differences between tracks to be judged and those of the learned vehicle, in the order of evidence.

The contest is that of `naming`, on the tracks to be judged alone and against a model whose numbers all tracks share:
what the vehicle had before as well is shared, so that it explains nothing here. Laws outside the catalogue come last,
when no entry and no number of the platform explains anything any more.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.against.control import Alike
from cocorosim_ros.diagnosis.against.delays import with_delays
from cocorosim_ros.diagnosis.against.kept_promises import as_kept
from cocorosim_ros.diagnosis.against.numbers import number_entries
from cocorosim_ros.diagnosis.against.starts import beyond_starts
from cocorosim_ros.diagnosis.against.twins import with_twin
from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.catalogue.open_set import open_set
from cocorosim_ros.diagnosis.catalogue.shown_by import LENGTHS
from cocorosim_ros.diagnosis.criteria.against import COMPARISON
from cocorosim_ros.diagnosis.criteria.naming import NAMING, SEARCH
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance
from cocorosim_ros.diagnosis.fitting.screening import Screen, Screened
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen
from cocorosim_ros.diagnosis.naming.choice import Choice
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming, Refused, Stage, onsets_of
from cocorosim_ros.diagnosis.naming.naming import best_addition, keys_of, ranked
from cocorosim_ros.diagnosis.naming.pruning import pruned
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.naming.steering_trims import trim_entries
from cocorosim_ros.world.terms.search import Scene

_NOTHING: tuple[NamedEffect, ...] = ()


class Addition(NamedTuple):
    """A fit with one more effect, and this effect."""

    fit: Fit
    effect: NamedEffect


@dataclass(frozen=True)
class Judged:
    """The tracks of a joint fit that are to be judged, by number, and the measures of evidence in them.

    unseen: parts of these tracks, through which free runs choose among differences of motion.
    """

    numbers: tuple[int, ...]
    alike: Alike
    unseen: Unseen


def name_differences(joint: Fit, judged: Judged, progress: Callable[[str, float], None]) -> Naming:
    """Name what differs on the judged tracks of a joint fit, to all tracks of which the shared model has been fitted.

    The rows of the fit hold the shared numbers, as `joint.below` writes them. Recordings of a sound vehicle differ too,
    by more than their evidence says where the random force is not quite as the model has it: so a difference of motion
    is named only if free runs gain by it. A law outside the catalogue is not named:
    with altered logs of real vehicles it mostly stood in for something that has a name. That there is one is kept.
    """
    fit, named = joint, _NOTHING
    first: tuple[Screened, ...] = ()
    first_laws: tuple[Screened, ...] = ()
    nameless = ""
    refused: tuple[Refused, ...] = ()
    traces: tuple[Candidate, ...] = ()
    unsettled: tuple[Candidate, ...] = ()
    for number in range(SEARCH.most_rounds):
        progress("looking for what differs", number / (number + SEARCH.pruned_from))
        scene = _scene(fit, judged)
        screen = Screen(fit, scene)
        tested = _tested(screen, judged, _entries(joint, judged), named)
        choice = Choice(
            judged.unseen, fit, onsets_of(named), must_gain=True, judged=judged.numbers,
            instruments_apart=COMPARISON.instruments_apart, instruments_share=COMPARISON.instruments_share,
        )  # fmt: skip
        found = _simplest(Stage(fit, named), screen, tested, choice)
        louder = _louder(found.effect, tested) if found is not None else []
        if found is not None and louder:
            unsettled = (found.effect.candidate, *louder)
            found = None
        laws: tuple[Screened, ...] = ()
        if found is None:
            water = any(each.candidate.entry.water and each.nats > SEARCH.worth_refining for each in tested)
            laws = _tested(screen, judged, _laws(scene, joint, judged, named, water=water), named)
            refused, traces = tuple(choice.refused), tuple(choice.traces)
            left_over = _best(Stage(fit, named), screen, (), choice, laws)
            nameless = left_over.effect.candidate.entry.id if left_over is not None else ""
        if number == 0:
            felt = [beyond_starts(screen, screen.felt(each)) for each in tested]
            first = tuple(felt if found is not None else (as_kept(each, choice.begun) for each in felt))
            first_laws = laws
        if found is None:
            break
        fit, named = settled(found.fit, SEARCH.settling), (*named, found.effect)
        if len(named) >= SEARCH.pruned_from:
            fit, named, _ = pruned(Stage(fit, named), joint, unseen=judged.unseen)
    fit, named, _ = pruned(Stage(fit, named), joint, unseen=judged.unseen)
    candidates = _candidates(joint, judged, _entries(joint, judged)) if named else []
    named = tuple(with_twin(effect, candidates, joint.tracks) for effect in named)
    return Naming(joint, fit, named, first, first_laws, nameless, refused=refused, traces=traces, unsettled=unsettled)


def _best(
    stage: Stage, screen: Screen, tested: Sequence[Screened], choice: Choice, laws: Sequence[Screened] = ()
) -> Addition | None:
    found = best_addition(stage.named, screen, tested, laws, choice)
    return None if found is None else Addition(*found)


def _simplest(stage: Stage, screen: Screen, tested: Sequence[Screened], choice: Choice) -> Addition | None:
    """Find the best addition to a stage, or in its place a rival with fewer numbers where one of its own may be zero.

    So an offset is named for a drift whose rate may be nothing.
    """
    found = _best(stage, screen, tested, choice)
    if found is None or not _holds_neutral(found):
        return found
    rivals = {rival.candidate.key for rival in found.effect.rivals}
    count = len(found.effect.candidate.entry.amplitudes)
    fewer = [each for each in tested if each.candidate.key in rivals and len(each.candidate.entry.amplitudes) < count]
    simple = _best(stage, screen, fewer, choice) if fewer else None
    if simple is None or _holds_neutral(simple):
        return found
    others = tuple(rival for rival in found.effect.rivals if rival.candidate.key != simple.effect.candidate.key)
    return Addition(simple.fit, replace(simple.effect, rivals=others))


def _louder(found: NamedEffect, tested: Sequence[Screened]) -> list[Candidate]:
    """List the candidates for which the readings speak much louder than for an effect that could be named.

    Alike recordings differ in them too, so that none of them may be named; but then that effect may stand in for one.
    """
    own = found.nats * found.candidate.spread
    return [
        each.candidate
        for each in tested
        if each.candidate.key != found.candidate.key
        and each.nats > COMPARISON.heard * NAMING.threshold
        and each.nats * each.candidate.spread > COMPARISON.louder * own
    ]


def _holds_neutral(found: Addition) -> bool:
    """Tell whether the 95 % interval of any amplitude of an added effect holds its neutral value."""
    fit, candidate = found.fit, found.effect.candidate
    spread = np.sqrt(np.diag(covariance(fit)))
    amplitudes = {each.column for each in candidate.entry.amplitudes}
    own = [place for place in candidate.places_among(fit.unknowns) if fit.unknowns[place].column in amplitudes]
    return any(abs(float(fit.q[place])) < COMPARISON.apart * float(spread[place]) for place in own)


def _scene(fit: Fit, judged: Judged) -> Scene:
    filled = fit.filled
    tracks = [fit.tracks[number] for number in judged.numbers]
    courses = [fit.tracks[number].filter.smoothed(filled[number]) for number in judged.numbers]
    return scene_of(tracks, courses, drag_form_of(fit))


def _entries(joint: Fit, judged: Judged) -> list[Entry]:
    tracks = [joint.tracks[number] for number in judged.numbers]
    numbers = [*number_entries(tracks, joint.rows[list(judged.numbers)]), *trim_entries(tracks)]
    taken = {each.id for each in numbers}
    return with_delays([*(each for each in ENTRIES if each.id not in taken), *numbers], tracks)


def _laws(scene: Scene, joint: Fit, judged: Judged, named: Sequence[NamedEffect], *, water: bool) -> list[Entry]:
    return open_set(scene, [each.candidate.entry for each in named], joint.rows[list(judged.numbers)], water=water)


def _tested(
    screen: Screen, judged: Judged, entries: Sequence[Entry], named: Sequence[NamedEffect]
) -> tuple[Screened, ...]:
    """Screen entries on the judged tracks, best first, their evidence divided by what tracks differ that are alike.

    Delays are searched from the beginning: the slope of one of several steps may promise nothing, and then a lag, which
    is like it, would be named in its place.
    """
    taken = {key for effect in named for key in keys_of(effect.candidate)}
    candidates = [each for each in _candidates(screen.fit, judged, entries) if not taken & keys_of(each)]
    tested = [screen.searched(each) for each in ranked(screen, candidates)]
    return judged.alike.weighed(sorted(tested, key=lambda each: -each.nats))


def _candidates(fit: Fit, judged: Judged, entries: Sequence[Entry]) -> list[Candidate]:
    """Make candidates that act on the judged tracks alone, on top of the numbers that these share with others.

    A scale of lengths may be told where nothing else measures them: the learned vehicle does, by how far it comes.
    """
    tracks = [fit.tracks[number] for number in judged.numbers]
    rows = fit.rows[list(judged.numbers)]
    shared = {unknown.column for unknown in fit.unknowns if set(unknown.tracks) - set(judged.numbers)}
    return [_placed(each, judged.numbers, shared) for each in expand(entries, tracks, rows, LENGTHS)]


def _placed(candidate: Candidate, numbers: Sequence[int], shared: set[str]) -> Candidate:
    """Number a candidate's tracks as the joint fit does, and note the columns that it shares with other tracks."""
    places = tuple(tuple(numbers[number] for number in own) for own in candidate.tracks)
    over = frozenset(each.column for each in candidate.entry.amplitudes if each.column in shared)
    return replace(candidate, tracks=places, over=over)
