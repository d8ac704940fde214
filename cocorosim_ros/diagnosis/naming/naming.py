"""Search for missing effects: contests among catalogue and laws, one effect added in each, then pruned.

An effect is named if its evidence passes a threshold (7 nats for 14 entries, more for a longer catalogue), if it also
foretells data that its fit did not see, and if no rival explains more. Rivals within a few nats are named with it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.catalogue.open_set import open_set
from cocorosim_ros.diagnosis.criteria.naming import NAMING, SEARCH
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.declared_numbers import declared_columns
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.held_out import held_out_gain
from cocorosim_ros.diagnosis.fitting.screening import Screen, Screened
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.naming.contest import Begun, Refined, begin, log_evidence, refine
from cocorosim_ros.diagnosis.naming.instruments import is_beyond_instrument
from cocorosim_ros.diagnosis.naming.known_effects import known_effects
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming, NearRival
from cocorosim_ros.diagnosis.naming.needed_evidence import held_against, is_like, is_tiny, needed_nats, standing
from cocorosim_ros.diagnosis.naming.pruning import pruned, without
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.world.terms.search import Scene

Progress = Callable[[str, float], None]


def name_effects(base: Fit, progress: Progress) -> Naming:
    """Name the effects that the recalibrated model `base` lacks; `progress` is told a task and the share done."""
    fit = base
    named: tuple[NamedEffect, ...] = ()
    first: tuple[Screened, ...] = ()
    first_laws: tuple[Screened, ...] = ()
    entries_of_catalogue = _undeclared(base)
    known = known_effects(base)
    for round_number in range(SEARCH.most_rounds):
        progress("looking for what is missing", round_number / (round_number + SEARCH.pruned_from))
        scene = scene_of(fit.tracks, smoothed_tracks(fit), drag_form_of(base))
        screen = Screen(fit, scene)
        taken = {key for effect in named for key in keys_of(effect.candidate)}
        entries = [each for each in expand(entries_of_catalogue, fit.tracks, fit.rows) if not taken & keys_of(each)]
        tested = ranked(screen, entries)
        water = any(each.candidate.entry.water and each.nats > SEARCH.worth_refining for each in tested)
        found = [effect.candidate.entry for effect in named]
        laws = expand(open_set(scene, found, base.rows, water=water), fit.tracks, base.rows)
        tested_laws = ranked(screen, [each for each in laws if not taken & keys_of(each)])
        if round_number == 0:
            first, first_laws = tested, tested_laws
        best = best_addition(fit, (*known, *named), screen, tested, tested_laws)
        if best is None:
            break
        fit, named = settled(best[0], SEARCH.settling), (*named, best[1])
        if len(named) >= SEARCH.pruned_from:
            fit, named = pruned(fit, named, base, known)
    fit, named = pruned(fit, named, base, known)
    return Naming(base, fit, named, first, first_laws)


def _undeclared(base: Fit) -> list[Entry]:
    """Choose the entries of the catalogue of which no number is one of the platform's own that are fitted anyway."""
    declared = declared_columns(base.unknowns)
    return [entry for entry in ENTRIES if not declared & {amplitude.column for amplitude in entry.amplitudes}]


def keys_of(candidate: Candidate) -> set[tuple[str, str | None, str]]:
    """Effect, topic and robot, for each robot of a candidate: two candidates that share one exclude each other."""
    return {(candidate.entry.id, candidate.entry.topic, robot) for robot in candidate.robots}


def ranked(screen: Screen, candidates: Sequence[Candidate]) -> tuple[Screened, ...]:
    """Screen candidates, and order them by evidence, the best first."""
    return tuple(sorted((screen.test(each) for each in candidates), key=lambda screened: -screened.nats))


def best_addition(
    fit: Fit, named: tuple[NamedEffect, ...], screen: Screen, tested: Sequence[Screened], laws: Sequence[Screened]
) -> tuple[Fit, NamedEffect] | None:
    """Find the best addition: the fit with it and all named effects, or None if no candidate may be named.

    named: also the effects that the base model has already. tested, laws: screened entries of the catalogue and
    screened laws outside it, best first.
    """
    begun = _begun(fit, screen.scene, tested, [law for law in laws[:2] if law.nats > SEARCH.worth_refining])
    if not begun:
        return None
    base_evidence = log_evidence(fit)
    negligible: list[Candidate] = []  # candidates that explain something but are too small to be believed
    for promising in _by_promise(begun):
        refined = [_refined(fit, each, base_evidence) for each in promising]
        found = _first_believed(fit, named, refined, negligible)
        if found is not None:
            return found
    return None


def _begun(fit: Fit, scene: Scene, tested: Sequence[Screened], laws: Sequence[Screened]) -> list[Begun]:
    """Begin the fit of every entry that is worth refining, and of these laws.

    A candidate whose fit finds hardly any of the nats that its screening promised makes room for the next one. A slope
    at a kink, as of a reading on the edge between two commands, promises what no model reaches.
    """
    begun: dict[int, Begun] = {}
    while True:
        chosen = [each for each in (*_worth_refining(tested), *laws) if id(each) not in begun]
        begun |= {id(each): begin(fit, each, scene) for each in chosen}
        empty = {_fault(each) for each in chosen if begun[id(each)].gain < SEARCH.kept * each.nats}
        tested, before = [each for each in tested if _fault(each) not in empty], tested
        if len(tested) == len(before):
            return list(begun.values())


def _fault(screened: Screened) -> tuple[str, str | None]:
    """Identifier and topic of a screened candidate: the same for all choices of robots."""
    return screened.candidate.entry.id, screened.candidate.entry.topic


def _by_promise(begun: Sequence[Begun]) -> tuple[list[Begun], list[Begun]]:
    """Split candidates into those that may lead, or be a rival, once noise is fitted too, and the rest."""
    gains = [each.gain - each.candidate.entry.prior_nats for each in begun]
    needed = min(SEARCH.promising * max(gains), max(gains) - SEARCH.close)
    chosen: tuple[list[Begun], list[Begun]] = ([], [])
    for each, gain in zip(begun, gains, strict=True):
        chosen[gain < needed].append(each)
    return chosen


def _first_believed(
    fit: Fit, named: tuple[NamedEffect, ...], refined: list[Refined], negligible: list[Candidate]
) -> tuple[Fit, NamedEffect] | None:
    """Name the best of the refined candidates that may be named, and return the fit with it; None if none may.

    A candidate may be named if its evidence suffices, also over a model without it that was fitted anew where evidence
    is weak, if it is large enough to be believed and no larger than an instrument can err, and if it foretells held-out
    blocks. One that is too small is added to `negligible`; candidates that may stand for the same effect are then
    passed over.
    """
    refined.sort(key=lambda each: -standing(each))
    for best in refined:
        needed = needed_nats(named, best.candidate, best.fit)
        if standing(best) < needed:
            return None
        if best.nats < NAMING.checked and _regained(best, fit) < needed:
            continue
        if is_tiny(best):
            negligible.append(best.candidate)
            continue
        if is_beyond_instrument(best.candidate, best.fit):
            continue
        if any(is_like(best.candidate, other) for other in negligible):
            continue  # it may stand for an effect that is too small to be believed
        gain = held_out_gain(fit, best.fit, best.candidate.onset_columns)
        if gain.total > 0.0:
            added = NamedEffect(best.candidate, best.nats, _rivals(best, refined), gain)
            return best.fit, added
    return None


def _rivals(best: Refined, refined: Sequence[Refined]) -> tuple[NearRival, ...]:
    """Entries of the catalogue that explain nearly as much as the best candidate: its ambiguity set."""
    others = [
        each
        for each in refined
        if each is not best and each.candidate.entry.law is None and not is_beyond_instrument(each.candidate, each.fit)
    ]
    return tuple(
        NearRival(other.candidate, max(0.0, best.nats - other.nats))
        for other in others
        if best.nats - other.nats <= NAMING.ambiguity
    )


def _regained(refined: Refined, before: Fit) -> float:
    """Standing [nats] of a candidate over a model without it that starts at the fit with it and is fitted anew.

    What the smaller model gains merely because its own fit was not finished is thereby not counted for the candidate.
    before: the fit to which the candidate was added.
    """
    smaller = without(refined.fit, refined.candidate, before)
    nats = log_evidence(refined.fit) - log_evidence(smaller)
    return standing(replace(refined, nats=nats - held_against(refined.candidate, smaller, refined.fit)))


def _refined(fit: Fit, begun: Begun, base_evidence: float) -> Refined:
    """Refine a candidate, and take from its evidence the nats that count against it."""
    result = refine(begun, base_evidence)
    return replace(result, nats=result.nats - held_against(begun.candidate, fit, result.fit))


def _worth_refining(tested: Sequence[Screened]) -> list[Screened]:
    """Choose the candidates to fit: the leaders, and members of their confusable groups that explain something."""
    needed = max(SEARCH.worth_refining, SEARCH.hopeless * tested[0].nats) if tested else SEARCH.worth_refining
    leaders = [each for each in tested[: SEARCH.leaders] if each.nats > needed]
    groups = {each.candidate.entry.group for each in leaders if each.candidate.entry.group}
    more = [
        each
        for each in tested[SEARCH.leaders :]
        if each.candidate.entry.group in groups
        and each.nats > min(SEARCH.worth_refining, SEARCH.group_share * leaders[0].nats)
    ]
    return [*leaders, *more][: SEARCH.most_refined]
