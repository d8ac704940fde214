"""The whole diagnosis: recalibrate, locate, name, show, advise."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy.stats import chi2

from cocorosim_ros.diagnosis.catalogue.catalogue import IDS
from cocorosim_ros.diagnosis.catalogue.manoeuvres import advised
from cocorosim_ros.diagnosis.criteria.fitting import RECALIBRATION
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.criteria.showing import VERDICT
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect, PassedOver, Recalibrated, Verdict
from cocorosim_ros.diagnosis.fitting.acting_angles import driven_as_shown
from cocorosim_ros.diagnosis.fitting.base_model import RECALIBRATED
from cocorosim_ros.diagnosis.fitting.borne_out import soundly_taken_in
from cocorosim_ros.diagnosis.fitting.coloured_readings import with_coloured_readings
from cocorosim_ros.diagnosis.fitting.drag_forms import ChosenForm, with_best_form
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance, finite
from cocorosim_ros.diagnosis.fitting.growing_force import with_growing_force
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit, nominal_fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.diagnosis.fitting.undeclared import not_looked_for
from cocorosim_ros.diagnosis.foretelling.collapse import collapsed_channels
from cocorosim_ros.diagnosis.foretelling.exactness import is_exact
from cocorosim_ros.diagnosis.foretelling.foreseeable import foreseeable_parts
from cocorosim_ros.diagnosis.foretelling.free_runs import HeldOutFreeRuns
from cocorosim_ros.diagnosis.foretelling.restraint import Restrained, mends, restrained
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen, seconds_of_free_runs
from cocorosim_ros.diagnosis.naming.detectability import is_blind, not_shown, screened_effects, shows_known
from cocorosim_ros.diagnosis.naming.named_effect import Naming
from cocorosim_ros.diagnosis.naming.naming import name_effects
from cocorosim_ros.diagnosis.naming.searched_again import better_foretelling
from cocorosim_ros.diagnosis.naming.single_thrusters import thruster_names, turned_remarks
from cocorosim_ros.diagnosis.report.headline import not_followed_headline, sentence_of, unable_sentence
from cocorosim_ros.diagnosis.showing.actuators import with_actuators
from cocorosim_ros.diagnosis.showing.beyond_the_floor import channels_beyond_the_floor
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.diagnosis.showing.course_velocity import course_velocities
from cocorosim_ros.diagnosis.showing.differing import as_asymmetries
from cocorosim_ros.diagnosis.showing.doubt import beyond_doubt, refused_effects, rests_of_found
from cocorosim_ros.diagnosis.showing.estimates import fitted, found_effects, recalibrated
from cocorosim_ros.diagnosis.showing.framing import mixed_up, unexplained
from cocorosim_ros.diagnosis.showing.gathered_evidence import gathered_evidence
from cocorosim_ros.diagnosis.showing.hard_stops import objections, stopped
from cocorosim_ros.diagnosis.showing.harm import (
    FORETOLD_WORSE,
    WORSE_BESIDE_KEPT,
    fewer_until,
    harmful,
    harmful_to_others,
    that_helps,
)
from cocorosim_ros.diagnosis.showing.lasting_errors import memory_remarks, wander_remarks
from cocorosim_ros.diagnosis.showing.location import locate
from cocorosim_ros.diagnosis.showing.lost import lost_robots
from cocorosim_ros.diagnosis.showing.noise_levels import noise_levels
from cocorosim_ros.diagnosis.showing.other_forms import TakenBack, told_at_last, without_other_forms
from cocorosim_ros.diagnosis.showing.regimes import unlike_regimes
from cocorosim_ros.diagnosis.showing.residual_force import residual_forces
from cocorosim_ros.diagnosis.showing.residual_reading import SmoothedFit, residual_readings
from cocorosim_ros.diagnosis.showing.uneven_noise import growth_remarks
from cocorosim_ros.diagnosis.showing.unrecorded import unrecorded
from cocorosim_ros.diagnosis.showing.unsteady_numbers import unsteady_numbers
from cocorosim_ros.diagnosis.showing.untold import untold_errors

Progress = Callable[[str, float], None]


def diagnose(evidence: Evidence, progress: Progress) -> Diagnosis:
    """Compare recordings with the platform's model; `progress` takes the present step in words, and the share done."""
    return with_actuators(_diagnosed(evidence, progress), evidence)


def _diagnosed(evidence: Evidence, progress: Progress) -> Diagnosis:
    progress("checking the recordings", 0.0)
    intake = soundly_taken_in(evidence)
    if intake.reasons:
        return abstained(evidence, intake.reasons)
    progress("fitting the platform's own numbers", 0.05)
    driven = driven_as_shown(intake.evidence, base_fit)
    base = driven.base
    if not finite(base):
        name = evidence.platform.name
        return abstained(
            evidence,
            (f"The model of '{name}' cannot be run through these recordings; check the numbers of its platform file.",),
        )
    form: ChosenForm | None = None
    if evidence.platform.drag_form is None:
        base, form = with_best_form(base, RECALIBRATION.most_rounds)
    steady, found = _steadily_searched(base, progress)
    base, naming, table, passed = found.base, found.naming, found.free.table, found.passed
    progress("locating what was missing", 0.9)
    courses = smoothed_tracks(base)
    located = locate(base, naming.screened, naming.laws, courses)
    progress("writing down", 0.95)
    passed = (*passed, *(() if is_exact(table) else refused_effects(naming)))
    numbers = fitted(naming.fit)
    effects = (*mixed_up(intake), *found_effects(naming.fit, naming.named, numbers))
    every, moved = recalibrated(numbers)
    moved = moved or (_strongest(every) if _shifted(base) else ())
    moved = () if is_exact(table) else moved
    silent = tuple(name for name in not_shown(naming.screened) if name not in {effect.id for effect in effects})
    # A fit none of whose numbers has clearly moved leaves the platform as given, which then foretells well.
    nameless = any(each.stands for each in passed)
    unknowable = bool(steady.held or (collapsed_channels(table) and (moved or effects or nameless)))
    blind = unknowable or (is_blind(silent, base.tracks) and not shows_known(naming))
    # What needs a topic that was not recorded, or a second robot, no manoeuvre shows.
    tried = {each.candidate.entry.id for each in naming.screened}
    manoeuvres = advised(effects, [name for name in silent if name in tried], evidence.platform)
    final_courses = smoothed_tracks(naming.fit)
    declared = evidence.platform.drag_form is not None
    case = Case(naming.fit, naming.named, effects, final_courses, table, naming.base, declared)
    if lost := lost_robots(case):
        return not_followed(intake.evidence, lost)
    against = (*unexplained(intake), *map(Objection, steady.sentences), *objections(case))
    effects = as_asymmetries(stopped(effects, against), thruster_names(base.tracks[0].vehicle))
    beyond = channels_beyond_the_floor(case)
    missing = nameless or (bool(beyond) and not blind)
    verdict = _verdict(effects, moved, missing=missing, blind=blind)
    unlike, nothing_shown = unlike_regimes(found.unseen), unrecorded(base.tracks)
    return Diagnosis(
        verdict,
        sentence_of(
            verdict,
            effects,
            moved,
            passed,
            collapsed=unknowable,
            beyond_floor=beyond,
        ),
        moved,
        located,
        effects,
        silent,
        manoeuvres,
        table,
        every,
        screened_effects(naming.screened),
        residual_forces(base, courses),
        residual_forces(naming.fit, final_courses),
        readings=residual_readings(SmoothedFit(base, courses), SmoothedFit(naming.fit, final_courses), effects),
        free_runs=found.free.runs,
        gathered=gathered_evidence(base, naming.fit),
        velocities=course_velocities(naming.fit, final_courses),
        remarks=(
            *intake.evidence.remarks,
            *driven.sentences,
            *_of_form(form),
            *turned_remarks(base.tracks[0].vehicle),
            *noise_remarks(naming.fit),
            *(() if is_exact(table) else rests_of_found(naming)),
        ),
        needed_nats=NAMING.threshold,
        noise=noise_levels(naming.fit),
        drag_form=form.name if form else "",
        step=min(track.timeline.grid.step for track in base.tracks),
        warnings=(
            *(each.sentence for each in against if each.effect is None),
            *(() if is_exact(table) else unsteady_numbers(naming.fit)),
            *unlike.values(),
        ),
        untold=untold_errors(base.tracks, nothing_shown.readings),
        passed_over=passed,
        unlike=tuple(unlike),
        beyond_floor=beyond,
        unrecorded=nothing_shown,
        screened_laws=screened_effects(naming.laws),
        not_looked_for=not_looked_for(evidence.platform),
        held=steady.held,
    )


def noise_remarks(fit: Fit) -> tuple[str, ...]:
    """Sentences on noise that is not plain: a random force that grows, errors of readings that last."""
    return (*growth_remarks(fit), *memory_remarks(fit), *wander_remarks(fit))


class Search(NamedTuple):
    """Findings of a search on top of a base, and its free runs; passed: effects that it took back."""

    base: Fit
    unseen: Unseen
    naming: Naming
    free: HeldOutFreeRuns
    passed: tuple[PassedOver, ...]


def _steadily_searched(base: Fit, progress: Progress) -> tuple[Restrained, Search]:
    """Search on top of a base; where what is found foretells worse than the platform as given, with numbers held."""
    found = _searched(base, progress)
    steady = restrained(base, found.free)
    if steady.base is not base:
        again = _searched(steady.base, progress)
        before = found.free.table
        naming, free = fewer_until(lambda table: mends(table, before), again.naming, again.unseen, again.free)
        if mends(free.table, before):
            passed = (*again.passed, *harmful(again.naming, naming, WORSE_BESIDE_KEPT))
            return steady, again._replace(naming=naming, free=free, passed=passed)
    return Restrained(base), found


def _searched(base: Fit, progress: Progress) -> Search:
    progress("choosing what no fit sees", 0.2)
    base, unseen, naming = _named_evenly(base, progress)
    progress("running free on what the fit did not see", 0.8)
    return Search(base, unseen, *_beyond_doubt(naming, unseen))


def _named_evenly(base: Fit, progress: Progress) -> tuple[Fit, Unseen, Naming]:
    """Name effects, on top of a model whose noise is as the recordings show it: of readings, and of the water.

    White errors of readings take slow ones for evidence of what acts slowly; a random force that is the same at all
    times takes errors that grow with speed for evidence of what acts at speed. Both are asked of the model with all
    its effects, since one that is missing shows there too; only then the search begins again.
    """
    unseen, naming = _named(base, progress, Shares(0.25, 0.35, 0.4))
    coloured = with_coloured_readings(base, naming.fit)
    if coloured is not None:
        base = coloured
        unseen, naming = _named(base, progress, Shares(0.4, 0.45, 0.5))
    grown = with_growing_force(base, naming.fit, smoothed_tracks(naming.fit))
    if grown is None:
        return base, unseen, naming
    return grown, *_named(grown, progress, Shares(0.5, 0.65, 0.7))


class Shares(NamedTuple):
    """Shares of the whole work that are done when effects begin to be named, are named once, and at last."""

    begin: float
    once: float
    end: float


def _named(base: Fit, progress: Progress, done: Shares) -> tuple[Unseen, Naming]:
    """Name effects, with free runs that are as long as the found vehicle coasts.

    A recalibrated model that lacks an effect may coast for a third of the time, as a blimp does whose drag has to stand
    for that sideways. So where the found model coasts for another time, the search begins again with free runs of
    its length: one that began with the found model would take these too.
    """
    wanted = seconds_of_free_runs(base)
    unseen = foreseeable_parts(base, wanted)
    naming = name_effects(base, _between(progress, done.begin, done.once), unseen)
    if not naming.named or (seconds := seconds_of_free_runs(naming.fit)) == wanted:
        return unseen, naming
    others = foreseeable_parts(base, seconds)
    if others.seconds == unseen.seconds:
        return unseen, naming
    again = name_effects(base, _between(progress, done.once, done.end), others)
    return others, better_foretelling(naming, again, others)


def _between(progress: Progress, low: float, high: float) -> Progress:
    """Make a progress of a part of the work, which takes the share done of this part."""
    return lambda words, share: progress(words, low + (high - low) * share)


def _beyond_doubt(naming: Naming, unseen: Unseen) -> tuple[Naming, HeldOutFreeRuns, tuple[PassedOver, ...]]:
    """Take back what makes free runs worse, is another form of a named effect, or may as well be nothing.

    All is asked again until nothing is taken back.
    """
    beside = harmful_to_others(naming)
    passed: tuple[PassedOver, ...] = ()
    forms: tuple[TakenBack, ...] = ()
    while True:
        before = naming
        naming, free = that_helps(naming, unseen)
        if not is_exact(free.table):
            passed = (*passed, *harmful(before, naming, FORETOLD_WORSE))
        naming, bent = without_other_forms(naming)
        naming, more = beyond_doubt(naming)
        if not (bent or more):
            return naming, free, (*told_at_last(naming, forms), *(() if is_exact(free.table) else beside), *passed)
        passed, forms = (*passed, *more), (*forms, *bent)


FORM_WORDS = {
    "own_speed": "each axis by its own speed (|u| u, |v| v, |w| w)",
    "strips": "each axis by its own speed, strip by strip along the hull",
}


def _of_form(form: ChosenForm | None) -> tuple[str, ...]:
    """Remark on a form of the drag that was chosen because the platform's file does not say it."""
    if form is None:
        return ()
    return (
        f"The platform's file does not say how quadratic drag goes with speed ('drag_form'); {FORM_WORDS[form.name]} "
        f"explains these recordings better than the total speed does, by {form.nats:.0f} nats, and is taken.",
    )


def abstained(evidence: Evidence, reasons: Sequence[str]) -> Diagnosis:
    """The diagnosis of evidence to which no model can be fitted."""
    everything = ("frame_mixup", *IDS)
    return Diagnosis(
        "insufficient",
        unable_sentence(reasons),
        (),
        (),
        (),
        everything,
        advised((), everything, evidence.platform),
        {},
        remarks=evidence.remarks,
        reasons=tuple(reasons),
    )


def not_followed(evidence: Evidence, lost: Sequence[str], *, against: bool = False) -> Diagnosis:
    """The diagnosis of evidence that the model does not follow, or not that of --against; lost: sentences on that."""
    return of_another_vehicle(evidence, lost, not_followed_headline(evidence.platform.name, against=against))


def of_another_vehicle(evidence: Evidence, reasons: Sequence[str], headline: str) -> Diagnosis:
    """The diagnosis of evidence that is none of the vehicle that is asked about: no manoeuvre helps."""
    return replace(abstained(evidence, reasons), sentence=headline, manoeuvres=())


def _verdict(effects: Sequence[FoundEffect], moved: Sequence[Recalibrated], *, missing: bool, blind: bool) -> Verdict:
    """The verdict; missing: that something is, although no name for it is beyond doubt."""
    if effects or missing:
        return "mismatch"
    if blind:
        return "insufficient"
    return "recalibrate" if moved else "consistent"


def _shifted(base: Fit) -> bool:
    """Tell whether the platform's own numbers, taken together, do not fit.

    By the likelihood ratio; and where the platform's file gives 95 % intervals, also by the distance from its numbers
    in standard deviations of both (Wald's test).
    """
    if not base.unknowns:
        return False
    surely = float(chi2.ppf(1.0 - VERDICT.sure, len(base.unknowns)))
    if 2.0 * (base.objective - nominal_fit(base).objective) <= surely:
        return False
    stated = np.array([unknown.stated for unknown in base.unknowns])
    return not stated.any() or float(base.q @ solve(covariance(base) + np.diag(stated**2), base.q)) > surely


def _strongest(every: Sequence[Recalibrated]) -> tuple[Recalibrated, ...]:
    """The number that moved most, of those whose interval excludes the nominal; used where no number alone is clear."""

    def moved(number: Recalibrated) -> float:
        width = number.estimate.high - number.estimate.low
        return abs(number.estimate.value - number.nominal) / width if width > 0.0 else 0.0

    names = {name for name, _ in RECALIBRATED.values()}
    own = [number for number in every if number.parameter in names and not number.estimate.holds(number.nominal)]
    return (max(own, key=moved),) if own else ()
