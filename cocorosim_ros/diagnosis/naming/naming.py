"""Which effects are missing: a contest of catalogue and laws, step by step, then pruned.

An effect is accused if its evidence passes the threshold (7 nats for 14 entries, more for a longer catalogue), if it
also foretells what its fit did not see, and if no rival explains more. Rivals within the ambiguity are named too.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import SENSOR_CHANNELS, Amplitude, Scene
from cocorosim_ros.diagnosis.catalogue.open_set import open_set
from cocorosim_ros.diagnosis.criteria.naming import NAMING, SEARCH
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, improved, information, settled, with_noise
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain, held_out_gain
from cocorosim_ros.diagnosis.fitting.screening import Screen, Screened
from cocorosim_ros.diagnosis.naming.contest import Begun, Refined, begin, log_evidence, refine
from cocorosim_ros.diagnosis.naming.quiet_pump import quiet_gain
from cocorosim_ros.diagnosis.naming.residual import scene_of, smoothed_tracks
from cocorosim_ros.diagnosis.tracks.columns import WATER_NOISE

Progress = Callable[[str, float], None]


@dataclass(frozen=True)
class Accused:
    """An effect that was added: where its unknowns stand in the fit, its evidence, its rivals."""

    candidate: Candidate
    first: int  # of its unknowns among the fit's laws
    count: int
    nats: float
    rivals: tuple[tuple[Candidate, float], ...]  # and how far behind
    held_out: HeldOutGain

    def in_fit(self, fit: Fit) -> Refined:
        """It as a part of a fit that has it."""
        return Refined(self.candidate, fit, self.first, self.count, self.nats)


@dataclass(frozen=True)
class Naming:
    """The recalibrated fit, the fit with all that is accused, and what the first screening saw."""

    base: Fit
    fit: Fit
    accused: tuple[Accused, ...]
    screened: tuple[Screened, ...]
    laws: tuple[Screened, ...]


def name_effects(base: Fit, progress: Progress) -> Naming:
    """The contest from the recalibrated model on."""
    fit = base
    accused: tuple[Accused, ...] = ()
    first: tuple[Screened, ...] = ()
    first_laws: tuple[Screened, ...] = ()
    for round_number in range(SEARCH.most_effects):
        progress("looking for what is missing", round_number / SEARCH.most_effects)
        scene = scene_of(fit.tracks, smoothed_tracks(fit))
        screen = Screen(fit, scene)
        taken = {key for part in accused for key in _keys(part.candidate)}
        entries: list[Candidate] = [part for part in expand(ENTRIES, fit.tracks, fit.rows) if not taken & _keys(part)]
        tested = _ranked(screen, entries)
        water = any(part.candidate.entry.water and part.nats > SEARCH.worth_refining for part in tested)
        found_laws = [part.candidate.entry for part in accused]
        laws = expand(open_set(scene, found_laws, base.rows, water=water), fit.tracks, base.rows)
        tested_laws = _ranked(screen, [part for part in laws if not taken & _keys(part)])
        if round_number == 0:
            first, first_laws = tested, tested_laws
        found = _best(fit, accused, screen, tested, tested_laws)
        if found is None:
            break
        fit, accused = settled(found[0], SEARCH.settling), found[1]
    fit, accused = _pruned(fit, accused, base)
    return Naming(base, fit, accused, first, first_laws)


def _keys(candidate: Candidate) -> set[tuple[str, str | None, str]]:
    return {(candidate.entry.id, candidate.entry.topic, robot) for robot in candidate.robots}


def _ranked(screen: Screen, candidates: Sequence[Candidate]) -> tuple[Screened, ...]:
    return tuple(sorted((screen.test(part) for part in candidates), key=lambda part: -part.nats))


def _best(
    fit: Fit, accused: tuple[Accused, ...], screen: Screen, tested: Sequence[Screened], laws: Sequence[Screened]
) -> tuple[Fit, tuple[Accused, ...]] | None:
    """The fit with the best addition, or None if none passes."""
    begun = _begun(fit, screen.scene, tested, [part for part in laws[:2] if part.nats > SEARCH.worth_refining])
    if not begun:
        return None
    base_evidence = log_evidence(fit)
    negligible: list[Candidate] = []  # they explain something but are too small to be believed
    for part in _by_promise(begun):
        refined = [_refined(fit, begun, base_evidence) for begun in part]
        found = _first_believed(fit, accused, refined, negligible)
        if found is not None:
            return found
    return None


def _begun(fit: Fit, scene: Scene, tested: Sequence[Screened], laws: Sequence[Screened]) -> list[Begun]:
    """All that is worth refining and these laws, let loose; who does not keep its promise makes room for the next.

    A slope at a kink, as of a reading on the edge between two commands, promises what no model reaches.
    """
    begun: dict[int, Begun] = {}
    while True:
        chosen = [part for part in (*_worth_refining(tested), *laws) if id(part) not in begun]
        begun |= {id(part): begin(fit, part, scene) for part in chosen}
        empty = {_fault(part) for part in chosen if begun[id(part)].gain < SEARCH.kept * part.nats}
        tested, before = [part for part in tested if _fault(part) not in empty], tested
        if len(tested) == len(before):
            return list(begun.values())


def _fault(screened: Screened) -> tuple[str, str | None]:
    """What it is, whosever."""
    return screened.candidate.entry.id, screened.candidate.entry.topic


def _by_promise(begun: Sequence[Begun]) -> tuple[list[Begun], list[Begun]]:
    """Those that may become the leader or its rival once noise is let loose, and the rest."""
    gains = [part.gain - part.candidate.entry.prior_nats for part in begun]
    needed = min(SEARCH.promising * max(gains), max(gains) - SEARCH.close)
    chosen: tuple[list[Begun], list[Begun]] = ([], [])
    for part, gain in zip(begun, gains, strict=True):
        chosen[gain < needed].append(part)
    return chosen


def _first_believed(
    fit: Fit, accused: tuple[Accused, ...], refined: list[Refined], negligible: list[Candidate]
) -> tuple[Fit, tuple[Accused, ...]] | None:
    """The fit with the best of these that may be accused; who is too small for that joins the negligible."""
    refined.sort(key=lambda part: -_standing(part))
    for best in refined:
        needed = _needed(accused, best)
        if _standing(best) < needed:
            return None
        if best.nats < NAMING.checked and _regained(best, fit) < needed:
            continue
        if _is_tiny(best):
            negligible.append(best.candidate)
            continue
        if any(_is_like(best.candidate, part) for part in negligible):
            continue  # the same by another name
        gain = held_out_gain(fit, best.fit, best.candidate.moments)
        if gain.total > 0.0:
            rivals = [(part.candidate, best.nats - part.nats) for part in refined if part is not best]
            near = tuple(
                (part, max(0.0, behind))
                for part, behind in rivals
                if behind <= NAMING.ambiguity and part.entry.law is None
            )
            added = Accused(best.candidate, best.first, best.count, best.nats, near, gain)
            return best.fit, (*accused, added)
    return None


def _regained(part: Refined, before: Fit) -> float:
    """Its evidence over a model without it that was let loose again from there, lest an unfinished fit be its merit."""
    without = _without(part.fit, part.first, part.count, before)
    nats = log_evidence(part.fit) - log_evidence(without) - _held_against(part.candidate, without, part.fit)
    return _standing(replace(part, nats=nats))


def _held_against(candidate: Candidate, without: Fit, fit: Fit) -> float:
    """Nats that do not count: what speaks against it from the outset, and what the water may have had a hand in."""
    return candidate.entry.prior_nats + (quiet_gain(without, fit) if candidate.entry.of_pump else 0.0)


def _is_tiny(part: Refined) -> bool:
    """Whether all of its amplitudes are too small to be believed."""
    mine = slice(part.first, part.first + part.count)
    values = [law.value(float(q)) for law, q in zip(part.fit.laws[mine], part.fit.q[mine], strict=True)]
    entry = part.candidate.entry
    amplitudes = [entry.amplitudes[index % len(entry.amplitudes)] for index in range(_amplitude_count(part))]
    return all(_is_negligible(part.candidate, each, value) for value, each in zip(values, amplitudes, strict=False))


def _is_negligible(candidate: Candidate, amplitude: Amplitude, value: float) -> bool:
    least = max(NAMING.least_share * candidate.large(amplitude), amplitude.adds_up / candidate.duration)
    low, high = amplitude.negligible
    return min(low, -least) < value - amplitude.neutral < max(high, least)


def _amplitude_count(part: Refined) -> int:
    owners = 1 if part.candidate.entry.water else len(part.candidate.tracks)
    return owners * len(part.candidate.entry.amplitudes)


def _is_like(candidate: Candidate, other: Candidate) -> bool:
    """Whether a candidate may stand for another one: a law on its side, or one of its group in its stream."""
    entry = candidate.entry
    if entry.law is not None:
        return _side(candidate) == _side(other)
    return bool(entry.group) and (entry.group, entry.topic) == (other.entry.group, other.entry.topic)


def _needed(accused: tuple[Accused, ...], part: Refined) -> float:
    """Nats that a candidate needs beside what is accused: more than a wrong form of another effect would leave over.

    That is one on the same side; a second fault of a sensor is no form of the first, only a law may be. An effect that
    does not look like another one at all is no rest of it either. A law of readings may be the rest of any motion.
    """
    candidate = part.candidate
    others = [each for each in accused if each.candidate.key != candidate.key]
    of_sensor, is_law = candidate.entry.channel in SENSOR_CHANNELS, candidate.entry.law is not None
    if of_sensor and not is_law:
        return NAMING.threshold
    shares = [
        (NAMING.law_rest if is_law else min(NAMING.form_share, _likeness(part, each))) * each.nats
        for each in others
        if _side(each.candidate) == _side(candidate)
    ]
    if of_sensor:
        shares += [
            NAMING.law_share * each.nats for each in others if each.candidate.entry.channel not in SENSOR_CHANNELS
        ]
    return max([NAMING.threshold, *shares])


def _likeness(part: Refined, other: Accused) -> float:
    """The greatest squared cosine between what numbers of the one and of the other change in the readings."""
    matrix = information(part.fit).matrix
    size = np.diag(matrix)
    mine, theirs = (slice(each.first, each.first + each.count) for each in (part, other))
    scale = np.outer(size[mine], size[theirs])
    return float((matrix[mine, theirs] ** 2 / np.maximum(scale, 1e-300)).max())


def _side(candidate: Candidate) -> str:
    """Which motion an effect acts on first, or which sensor."""
    channel = candidate.entry.channel
    return channel if channel in SENSOR_CHANNELS else "upright" if channel == "heave" else "level"


def _standing(part: Refined) -> float:
    """Evidence; a law outside the catalogue is believed only if it is clearly better than what is known."""
    return part.nats - (NAMING.law_margin if part.candidate.entry.law is not None else 0.0)


def _refined(fit: Fit, begun: Begun, base_evidence: float) -> Refined:
    result = refine(begun, base_evidence)
    return replace(result, nats=result.nats - _held_against(begun.candidate, fit, result.fit))


def _worth_refining(tested: Sequence[Screened]) -> list[Screened]:
    """The leaders, and of their groups whoever explains something."""
    needed = max(SEARCH.worth_refining, SEARCH.hopeless * tested[0].nats) if tested else SEARCH.worth_refining
    leaders = [part for part in tested[: SEARCH.leaders] if part.nats > needed]
    groups = {part.candidate.entry.group for part in leaders if part.candidate.entry.group}
    more = [
        part
        for part in tested[SEARCH.leaders :]
        if part.candidate.entry.group in groups
        and part.nats > min(SEARCH.worth_refining, SEARCH.group_share * leaders[0].nats)
    ]
    return [*leaders, *more][: SEARCH.most_refined]


def _pruned(fit: Fit, accused: tuple[Accused, ...], base: Fit) -> tuple[Fit, tuple[Accused, ...]]:
    """Take back what the others have made superfluous, the weakest first."""
    while len(accused) > 1:
        whole = log_evidence(fit)
        losses = []
        for part in accused:
            without = _without(fit, part.first, part.count, base)
            nats = whole - log_evidence(without) - _held_against(part.candidate, without, fit)
            losses.append((nats, part, without))
        kept = {part.candidate.key: change for change, part, _ in losses}
        accused = tuple(replace(part, nats=kept[part.candidate.key]) for part in accused)
        wanted = {part.candidate.key: _needed(accused, part.in_fit(fit)) for part in accused}
        losses.sort(key=lambda entry: entry[0] / wanted[entry[1].candidate.key])
        loss, weakest, without = losses[0]
        if loss >= wanted[weakest.candidate.key]:
            break
        fit, accused = without, _moved(accused, weakest)
    return fit, accused


def without_weakest(naming: Naming) -> Naming:
    """The naming without the accusation that has the least evidence."""
    weakest = min(naming.accused, key=lambda part: part.nats)
    fit = _without(naming.fit, weakest.first, weakest.count, naming.base)
    return replace(naming, fit=fit, accused=_moved(naming.accused, weakest))


def _without(fit: Fit, first: int, count: int, base: Fit) -> Fit:
    """The fit without so many of its laws from `first` on, the rest let loose again.

    What the laws explained passes for random force then: the noise may have to be what it was in `base`.
    """
    stays = np.ones(len(fit.laws), dtype=bool)
    stays[first : first + count] = False
    laws = tuple(law for law, keep in zip(fit.laws, stays, strict=True) if keep)
    smaller = evaluated(replace(fit, laws=laws, q=fit.q[stays]))
    noisy = evaluated(replace(smaller, q_noise=base.q_noise))
    smaller = improved(max(smaller, noisy, key=lambda each: each.objective), 2)
    return improved(with_noise(smaller, 2, WATER_NOISE), 2)


def _moved(accused: tuple[Accused, ...], gone: Accused) -> tuple[Accused, ...]:
    """The others, with their new places among the laws."""
    return tuple(
        replace(part, first=part.first - (gone.count if part.first > gone.first else 0))
        for part in accused
        if part.candidate.key != gone.candidate.key
    )
