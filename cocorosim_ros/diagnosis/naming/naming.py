"""Search for missing effects: contests among catalogue and laws, one effect added in each, then pruned.

An effect is named if its evidence passes a threshold (7 nats for 14 entries, more for a longer catalogue), if it also
foretells data that its fit did not see, and if no rival explains more. Rivals within a few nats are named with it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.catalogue.open_set import open_set
from cocorosim_ros.diagnosis.criteria.naming import NAMING, SEARCH
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.coloured_readings import colours_of, robots_of
from cocorosim_ros.diagnosis.fitting.declared_numbers import declared_columns
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain, held_out_gain
from cocorosim_ros.diagnosis.fitting.polishing import polished
from cocorosim_ros.diagnosis.fitting.screening import Screen, Screened
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen
from cocorosim_ros.diagnosis.naming.choice import Choice, can_be_law, moves
from cocorosim_ros.diagnosis.naming.contest import Begun, Refined, begin, log_evidence, refine
from cocorosim_ros.diagnosis.naming.instruments import is_beyond_instrument
from cocorosim_ros.diagnosis.naming.known_effects import known_effects
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming, NearRival, Refused, Stage, onsets_of
from cocorosim_ros.diagnosis.naming.natural_limits import is_at_its_limit
from cocorosim_ros.diagnosis.naming.needed_evidence import (
    held_against,
    is_like,
    is_tiny,
    needed_nats,
    standing,
    usual_gain,
)
from cocorosim_ros.diagnosis.naming.parts_of_errors import parts_of_errors
from cocorosim_ros.diagnosis.naming.promising_laws import leading, pair_candidates
from cocorosim_ros.diagnosis.naming.pruning import pruned, without
from cocorosim_ros.diagnosis.naming.ranking import by_rank, near_rivals
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.naming.single_thrusters import looked_for_alone
from cocorosim_ros.diagnosis.naming.steering_trims import trim_entries
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE, WATER_RANDOM
from cocorosim_ros.world.terms.search import Scene

Progress = Callable[[str, float], None]


WITHOUT_MEMORY = (*WATER_RANDOM, *READING_NOISE)
"""Noise that is fitted with every addition. How long errors last is held as the fit before had it until the end."""


class PassedOver(NamedTuple):
    """Candidates of a round that explain something: too small to be believed, or contradicted by free runs.

    rests: those that explain more than the ones that come after them, and may be rests of effects that the model has.
    """

    negligible: list[Candidate]
    harmful: list[Candidate]
    rests: list[Refined]


def name_effects(base: Fit, progress: Progress, unseen: Unseen | None = None) -> Naming:
    """Name the effects that the recalibrated model `base` lacks; `progress` is told a task and the share done.

    unseen: parts of the recordings on which free runs choose among the effects; without, the likelihood alone does.
    Beside effects that another diagnosis found, one of motion has to make free runs better: what their forms leave has
    nats too.
    """
    fit = base
    named: tuple[NamedEffect, ...] = ()
    first: tuple[Screened, ...] = ()
    first_laws: tuple[Screened, ...] = ()
    refused: tuple[Refused, ...] = ()
    harmful: tuple[Refused, ...] = ()
    entries_of_catalogue = _undeclared(base)
    known = known_effects(base)
    free = unseen is not None and any(True for _ in unseen.windows())
    again = free and any(each.found_before and moves(each.candidate) for each in known)
    lasting = robots_of(colours_of(base))
    for round_number in range(SEARCH.most_rounds):
        progress("looking for what is missing", round_number / (round_number + SEARCH.pruned_from))
        courses = smoothed_tracks(fit)
        scene = scene_of(fit.tracks, courses, drag_form_of(base))
        screen = Screen(fit, scene)
        taken = {key for effect in named for key in keys_of(effect.candidate)}
        entries = [each for each in expand(entries_of_catalogue, fit.tracks, fit.rows) if not taken & keys_of(each)]
        tested = ranked(screen, entries)
        water = any(each.candidate.entry.water and each.nats > SEARCH.worth_refining for each in tested)
        found = [effect.candidate.entry for effect in named]
        laws = expand(open_set(scene, found, base.rows, water=water), fit.tracks, base.rows)
        tested_laws = ranked(screen, [each for each in laws if not taken & keys_of(each) and can_be_law(each, lasting)])
        choice = Choice(unseen, fit, onsets_of(named), must_gain=again) if unseen is not None else None
        pairs: tuple[Screened, ...] = ()
        if round_number == 0:
            pairs = ranked(screen, pair_candidates(screen, courses))
            tested_laws = _ordered((*leading(pairs, tested), *tested_laws))
            first, first_laws = tuple(map(screen.felt, tested)), tested_laws
        best = best_addition((*known, *named), screen, tested, tested_laws, choice)
        if best is None and pairs:
            best = _best_by_slopes(known, screen, (), pairs, choice)
        if best is None:
            refused = tuple(choice.refused) if choice is not None else ()
            break
        fit, named = settled(best[0], SEARCH.settling, WITHOUT_MEMORY), (*named, best[1])
        if len(named) >= SEARCH.pruned_from:
            fit, named, harmful = pruned(Stage(fit, named, harmful), base, known, unseen)
    fit, named, harmful = pruned(Stage(fit, named, harmful), base, known, unseen)
    left = {effect.candidate.key for effect in named}
    harmful = tuple(each for each in harmful if each.effect.candidate.key not in left)
    return Naming(
        base, polished(fit) if named else fit, named, first, first_laws, known=known, refused=refused, harmful=harmful
    )


def _undeclared(base: Fit) -> list[Entry]:
    """Choose the entries of which no number is one of the platform's own, fitted or held as given.

    They are those of the catalogue, of single thrusters, and of rudders and fins.
    """
    declared = declared_columns(base.tracks)
    every = (*ENTRIES, *parts_of_errors(base.tracks), *looked_for_alone(base.tracks), *trim_entries(base.tracks))
    return [entry for entry in every if not declared & {amplitude.column for amplitude in entry.amplitudes}]


def keys_of(candidate: Candidate) -> set[tuple[str, str | None, str]]:
    """Effect, topic and robot, for each robot of a candidate: two candidates that share one exclude each other."""
    return {(candidate.entry.id, candidate.entry.topic, robot) for robot in candidate.robots}


def ranked(screen: Screen, candidates: Sequence[Candidate]) -> tuple[Screened, ...]:
    """Screen candidates, and order them by evidence, the best first."""
    return _ordered(screen.test(each) for each in candidates)


def _ordered(tested: Iterable[Screened]) -> tuple[Screened, ...]:
    return tuple(sorted(tested, key=lambda screened: -screened.nats))


def best_addition(
    named: tuple[NamedEffect, ...],
    screen: Screen,
    tested: Sequence[Screened],
    laws: Sequence[Screened],
    choice: Choice | None = None,
) -> tuple[Fit, NamedEffect] | None:
    """Find the best addition to the fit of a screen: the fit with it and all named effects; None if none may be named.

    named: also the effects that the base model has already. tested, laws: screened entries of the catalogue and
    screened laws outside it, best first. choice: free runs among which the best is chosen, beside the likelihood.
    Where slopes lead to nothing, delays are searched before the search ends.
    """
    found = _best_by_slopes(named, screen, tested, laws, choice)
    if found is not None:
        return found
    passed_by = [each for each in tested if each.nats <= SEARCH.worth_refining]
    late = _ordered(each for each in map(screen.searched, passed_by) if each.nats > SEARCH.worth_refining)
    return _best_by_slopes(named, screen, late, (), choice) if late else None


def _best_by_slopes(
    named: tuple[NamedEffect, ...],
    screen: Screen,
    tested: Sequence[Screened],
    laws: Sequence[Screened],
    choice: Choice | None,
) -> tuple[Fit, NamedEffect] | None:
    wanted = [law for law in laws[:2] if law.nats > SEARCH.worth_refining]
    if choice is not None:
        wanted += choice.overlooked(screen, tested, _worth_refining(tested))
    begun = _begun(screen.fit, screen.scene, tested, wanted)
    if choice is not None:
        choice.begun.extend(begun)
    if not begun:
        return None
    base_evidence = log_evidence(screen.fit)
    passed_over = PassedOver([], [], [])
    for promising in _by_promise(begun, choice):
        refined = [_refined(screen.fit, each, base_evidence) for each in promising]
        found = _first_believed(Stage(screen.fit, named), refined, passed_over, choice)
        if found is not None:
            return found
        passed_over.rests.extend(_believed_rests(refined, passed_over))
    return None


def _believed_rests(refined: Sequence[Refined], passed_over: PassedOver) -> list[Refined]:
    """List candidates with evidence enough for a name, if it could not be left over by effects that the model has."""
    without_name = (*passed_over.negligible, *passed_over.harmful)
    return [
        each
        for each in refined
        if standing(each) >= NAMING.threshold and not any(each.candidate is other for other in without_name)
    ]


def _begun(fit: Fit, scene: Scene, tested: Sequence[Screened], wanted: Sequence[Screened]) -> list[Begun]:
    """Begin the fit of every entry that is worth refining, and of those that are wanted beside.

    A candidate whose fit finds hardly any of the nats that its screening promised makes room for the next one. A slope
    at a kink, as of a reading on the edge between two commands, promises what no model reaches.
    """
    begun: dict[int, Begun] = {}
    while True:
        chosen = [each for each in (*_worth_refining(tested), *wanted) if id(each) not in begun]
        begun |= {id(each): begin(fit, each, scene) for each in chosen}
        empty = {_fault(each) for each in chosen if begun[id(each)].gain < SEARCH.kept * each.nats}
        tested, before = [each for each in tested if _fault(each) not in empty], tested
        if len(tested) == len(before):
            return list(begun.values())


def _fault(screened: Screened) -> tuple[str, str | None]:
    """Identifier and topic of a screened candidate: the same for all choices of robots."""
    return screened.candidate.entry.id, screened.candidate.entry.topic


def _by_promise(begun: Sequence[Begun], choice: Choice | None) -> tuple[list[Begun], list[Begun]]:
    """Split candidates into those that may lead, or be a rival, once noise is fitted too, and the rest.

    Those also may lead whose free runs are better than those of the one with the greatest gain.
    """
    gains = [each.gain - each.candidate.entry.prior_nats for each in begun]
    needed = min(SEARCH.promising * max(gains), max(gains) - SEARCH.close)
    chosen: tuple[list[Begun], list[Begun]] = ([], [])
    for each, gain in zip(begun, gains, strict=True):
        chosen[gain < needed].append(each)
    if choice is None:
        return chosen
    leader = begun[gains.index(max(gains))]
    more = choice.promising(leader, chosen[1])
    return [*chosen[0], *more], [each for each in chosen[1] if not any(each is other for other in more)]


def _first_believed(
    stage: Stage, refined: list[Refined], passed_over: PassedOver, choice: Choice | None
) -> tuple[Fit, NamedEffect] | None:
    """Name the best of the refined candidates that may be named, and return the fit with it; None if none may.

    The best is the one with most evidence, or one that may be named too and foretells unseen data clearly better. One
    that makes free runs worse is not named. After it the order of evidence counts for less: what follows has to gain.
    """
    refined = by_rank(refined, stage)
    for place, leader in enumerate(refined):
        if standing(leader) < needed_nats(stage.named, leader.candidate, leader.fit):
            return None
        own = _held_out_if_nameable(leader, stage, passed_over, choice)
        if own is None:
            continue
        if choice is None or not moves(leader.candidate):
            return _addition(leader, near_rivals(leader, (*passed_over.rests, *refined), choice), own)
        others = (
            (each, _held_out_if_nameable(each, stage, passed_over, choice))
            for each in choice.better(leader, refined[place + 1 :])
        )
        best, held_out = next(((each, found) for each, found in others if found is not None), (leader, own))
        gain = choice.gain(best)
        if not choice.refuses(best.candidate, gain) and (gain.is_likely or not passed_over.harmful):
            return _addition(best, near_rivals(best, (*passed_over.rests, *refined), choice), held_out, gain)
        passed_over.harmful.append(best.candidate)
        choice.refused.append(Refused(*_addition(best, (), held_out, gain)))
    return None


def _held_out_if_nameable(
    refined: Refined, stage: Stage, passed_over: PassedOver, choice: Choice | None
) -> HeldOutGain | None:
    """Held-out gain of a candidate that may be named; None for one that may not.

    It may if its evidence suffices, also over a model without it that was fitted anew where evidence is weak, if it is
    large enough to be believed and no larger than such an effect or an instrument's error can be, and if it foretells
    held-out blocks. One that is too small is noted; candidates that may stand for what was passed over, or refused by
    free runs, are passed over too.
    """
    needed = needed_nats(stage.named, refined.candidate, refined.fit)
    if standing(refined) < needed or (refined.nats < NAMING.checked and _regained(refined, stage.fit) < needed):
        return None
    if is_tiny(refined):
        passed_over.negligible.append(refined.candidate)
        return None
    if is_beyond_instrument(refined.candidate, refined.fit) or is_at_its_limit(refined.candidate, refined.fit):
        return None
    if any(is_like(refined.candidate, other) for other in (*passed_over.negligible, *passed_over.harmful)):
        return None
    if choice is not None and choice.may_be_trace(refined.candidate, standing(refined)):
        choice.traces.append(refined.candidate)
        return None
    among = choice.judged if choice is not None else None
    held_out = held_out_gain(stage.fit, refined.fit, refined.candidate.onset_columns, among)
    return held_out if held_out.total > 0.0 else None


def _addition(
    best: Refined, rivals: Sequence[NearRival], held_out: HeldOutGain, gain: Gain | None = None
) -> tuple[Fit, NamedEffect]:
    return best.fit, NamedEffect(best.candidate, best.nats, tuple(rivals), held_out, gain)


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
    usual = usual_gain(begun.candidate, fit, result.fit)
    return replace(result, nats=result.nats - held_against(begun.candidate, fit, result.fit), usual=usual)


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
