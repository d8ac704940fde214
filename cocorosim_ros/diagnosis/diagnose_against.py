"""The comparison of recordings with those of the same vehicle when it was well: only differences are named."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.against.axes import in_its_axes
from cocorosim_ros.diagnosis.against.comparable import comparable, taken_in
from cocorosim_ros.diagnosis.against.control import Alike
from cocorosim_ros.diagnosis.against.differences import Judged, name_differences
from cocorosim_ros.diagnosis.against.doubt_sentences import REFUSED, TRACE, VAGUE, doubts, names_of, of_unsettled
from cocorosim_ros.diagnosis.against.either_instrument import apart, of_either
from cocorosim_ros.diagnosis.against.halves import changed_halfway
from cocorosim_ros.diagnosis.against.joint import below, joint_fit, part_of, with_streams_of
from cocorosim_ros.diagnosis.against.learned_once import learned_once
from cocorosim_ros.diagnosis.against.learning import learned_effects
from cocorosim_ros.diagnosis.against.nameless import differ_namelessly, left_over_words
from cocorosim_ros.diagnosis.against.out_of_sight import numbers_not_shown, sizes_seen
from cocorosim_ros.diagnosis.against.running import Running, runnable, runs_away
from cocorosim_ros.diagnosis.against.stamps import other_clocks
from cocorosim_ros.diagnosis.against.torn import as_learned, is_torn, surer
from cocorosim_ros.diagnosis.catalogue.catalogue import IDS
from cocorosim_ros.diagnosis.catalogue.manoeuvres import advised
from cocorosim_ros.diagnosis.criteria.against import COMPARISON
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.diagnose import abstained, not_followed, of_another_vehicle
from cocorosim_ros.diagnosis.evidence.cleaning import is_noteworthy
from cocorosim_ros.diagnosis.evidence.intake import Intake
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis, FoundEffect, Recalibrated, Verdict
from cocorosim_ros.diagnosis.fitting.acting_angles import as_ordered, reports_act
from cocorosim_ros.diagnosis.fitting.drag_forms import word_of_form
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.fitting.undeclared import not_looked_for
from cocorosim_ros.diagnosis.foretelling.foreseeable import foreseeable_parts
from cocorosim_ros.diagnosis.foretelling.free_runs import held_out_free_runs
from cocorosim_ros.diagnosis.naming.detectability import (
    name_of,
    not_shown,
    screened_effects,
    streams_and_numbers_not_shown,
)
from cocorosim_ros.diagnosis.naming.named_effect import Naming
from cocorosim_ros.diagnosis.naming.single_thrusters import thruster_names
from cocorosim_ros.diagnosis.report.headline import difference_sentence, other_vehicle_headline
from cocorosim_ros.diagnosis.showing.actuators import with_actuators
from cocorosim_ros.diagnosis.showing.beside_a_law import beside_nameless
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.diagnosis.showing.course_velocity import course_velocities
from cocorosim_ros.diagnosis.showing.differing import (
    as_asymmetries,
    differing_effects,
    differing_numbers,
    with_spread_between,
)
from cocorosim_ros.diagnosis.showing.estimates import fitted, recalibrated
from cocorosim_ros.diagnosis.showing.framing import mixed_up, unexplained
from cocorosim_ros.diagnosis.showing.gathered_evidence import gathered_evidence
from cocorosim_ros.diagnosis.showing.hard_stops import objections, stopped
from cocorosim_ros.diagnosis.showing.learned_vehicle import case_of_learned, objection_to_learned
from cocorosim_ros.diagnosis.showing.lost import lost_robots
from cocorosim_ros.diagnosis.showing.noise_levels import noise_levels
from cocorosim_ros.diagnosis.showing.other_vehicle import Unlike, other_vehicle_sentence, other_vehicles, under_a_load
from cocorosim_ros.diagnosis.showing.residual_force import residual_forces
from cocorosim_ros.diagnosis.showing.residual_reading import SmoothedFit, residual_readings
from cocorosim_ros.diagnosis.showing.undone import undone
from cocorosim_ros.diagnosis.showing.unrecorded import unrecorded

Progress = Callable[[str, float], None]


def diagnose_against(bad: Evidence, good: Evidence, progress: Progress) -> Diagnosis:
    """Name what differs between recordings and those of the same vehicle when it was well.

    bad: what is to be judged; good: what it is compared with. Raises CocorosimError where nothing can be compared.
    """
    progress("checking the recordings", 0.0)
    bad, good = comparable(bad, good)
    return with_actuators(_compared(bad, good, progress), bad, good)


def _compared(bad: Evidence, good: Evidence, progress: Progress) -> Diagnosis:
    """Name what differs between recordings that were made comparable."""
    intake, well = taken_in(bad, good)
    if well.reasons or intake.reasons:
        return _with_files(abstained(bad, (*_of_good(well.reasons), *intake.reasons)), well)
    progress("learning the vehicle", 0.05)
    once = learned_once(well.evidence, lambda words, share: progress(words, 0.1 + 0.25 * share))
    if lost := lost_robots(case_of_learned(once.vehicle)):
        return _with_files(not_followed(bad, _of_good(lost), against=True), well)
    if not reports_act(track.log for track in once.vehicle.tracks):
        intake = replace(intake, evidence=as_ordered(intake.evidence))
    progress("fitting both together", 0.4)
    learned, joint, taken_back = _joined(once.vehicle, intake)
    turned = in_its_axes(learned, joint, intake)
    if turned is not intake:
        intake = turned
        learned, joint, more = _joined(learned, intake)
        taken_back += more
    if runs_away(joint):
        reason = f"The vehicle of --against cannot be run through these recordings of '{bad.platform.name}'."
        return _with_files(abstained(bad, (reason,)), well)
    alike = Alike(with_streams_of(learned, joint))
    progress("comparing the recordings of --against with each other", 0.5)
    control = _control(learned, alike)
    numbers = tuple(range(len(learned.tracks), len(joint.tracks)))
    judged = _judged(joint, numbers, alike)
    naming = name_differences(joint, judged, lambda words, share: progress(words, 0.55 + 0.2 * share))
    if is_torn(learned, joint):
        kept = as_learned(learned, joint)
        anew = _judged(kept, numbers, alike)
        naming = surer(naming, name_differences(kept, anew, lambda words, share: progress(words, 0.75 + 0.2 * share)))
    progress("writing down", 0.95)
    naming = replace(naming, screened=alike.all_weighed(naming.screened))
    against = replace(_against(well, learned, control, naming), taken_back=taken_back)
    clocks = tuple(other_clocks(intake.evidence, well.evidence))
    objection = objection_to_learned(learned, well, changed_halfway(once.base))
    told = _told(naming, judged, intake, against, clocks, objection)
    # The numbers of the model file are those of the learned vehicle, found with its steps and in its form of drag.
    form = word_of_form(learned) if bad.platform.drag_form is None else ""
    return replace(told, drag_form=form, step=min(track.timeline.grid.step for track in learned.tracks))


def _joined(learned: Fit, intake: Intake) -> Running:
    return runnable(learned, lambda vehicle: joint_fit(vehicle, intake.evidence))


def _of_good(reasons: Sequence[str]) -> tuple[str, ...]:
    return tuple(f"--against: {reason}" for reason in reasons)


def _of_taken_back(taken_back: Sequence[str]) -> tuple[str, ...]:
    """Remarks on what was learned from --against and does not hold in the recordings to be judged."""
    return tuple(
        f"'{name}' was learned from the recordings of --against, but with it the model runs away from the readings "
        "that are judged; it was taken back."
        for name in taken_back
    )


def _control(learned: Fit, alike: Alike) -> tuple[str, ...]:
    """Names of what every second track of the learned vehicle differs in from the others; () if in nothing."""
    half = tuple(range(1, len(learned.tracks), 2))
    if not half:
        return ()
    fit = replace(learned, rows=below(learned))
    found = name_differences(fit, _judged(fit, half, alike), lambda words, share: None)
    names = tuple(effect.candidate.entry.id for effect in found.named)
    return (*names, found.nameless) if found.nameless else names


def _judged(fit: Fit, numbers: tuple[int, ...], alike: Alike) -> Judged:
    return Judged(numbers, alike, foreseeable_parts(fit, among=numbers))


def _against(well: Intake, learned: Fit, control: tuple[str, ...], naming: Naming) -> Comparison:
    spreads = {effect.candidate.entry.id: effect.candidate.spread for effect in naming.named}
    every, _ = recalibrated(fitted(learned))
    named = {effect.candidate.entry.id for effect in naming.named}
    refused = dict.fromkeys(each.effect.candidate.entry.id for each in naming.refused)
    in_doubt = tuple(name for name in refused if name not in named)
    seen = sizes_seen(naming.screened)
    return replace(
        _of_files(well), learned=learned_effects(learned), control=control, spreads=spreads, before=every,
        seen_from=seen, in_doubt=in_doubt,
    )  # fmt: skip


def _of_files(well: Intake) -> Comparison:
    """Make a comparison with recordings of which nothing is known yet but what was odd about them."""
    remarks = _of_good([remark for remark in well.evidence.remarks_on_recordings if is_noteworthy(remark)])
    return Comparison(tuple(each.origin for each in well.evidence.recordings), (), (), remarks=remarks)


def _with_files(diagnosis: Diagnosis, well: Intake) -> Diagnosis:
    against = _of_files(well)
    return replace(diagnosis, remarks=(*diagnosis.remarks, *against.remarks), against=against)


def _told(
    naming: Naming,
    judged: Judged,
    intake: Intake,
    against: Comparison,
    clocks: tuple[FoundEffect, ...],
    to_learned: tuple[Objection, ...],
) -> Diagnosis:
    """Write the differences as findings: numbers of the platform by themselves, the rest as effects.

    clocks: differences of clocks. to_learned: objections to the learned vehicle.
    """
    numbers = with_spread_between(fitted(naming.fit), naming, judged.alike)
    moved, vague = _clearly_moved(differing_numbers(naming, numbers))
    effects: tuple[FoundEffect, ...] = (*mixed_up(intake), *clocks, *differing_effects(naming, numbers))
    if against.control:
        effects = tuple(replace(effect, tier="suspected") for effect in effects)
    effects, vaguely = _beyond_doubt(naming, effects)
    vague = (*vaguely, *vague)
    if unlike := other_vehicles(moved, effects):
        return _of_another(unlike, intake.evidence, against, to_learned)
    effects, either = apart(naming.named, effects)
    doubted = (*vague, *(name for names in either for name in names))
    base, final = (_judged_part(naming, fit, judged) for fit in (naming.base, naming.fit))
    table, runs, _ = held_out_free_runs(foreseeable_parts(base), final)
    courses = smoothed_tracks(base), smoothed_tracks(final)
    case = Case(final, naming.named, effects, courses[1], table)
    if lost := lost_robots(case):
        return replace(not_followed(intake.evidence, lost), against=against)
    of_vehicles = (*to_learned, *under_a_load(moved, effects), *undone(case, base))
    stops = (*of_vehicles, *unexplained(intake), *objections(case), *beside_nameless(case, naming.nameless))
    effects = as_asymmetries(stopped(effects, stops), thruster_names(base.tracks[0].vehicle))
    traces, unsettled = (names_of(naming, each) for each in (naming.traces, naming.unsettled))
    seen = {*(effect.id for effect in effects), *doubted, *(name.partition(":")[0] for name in doubted)}
    unseen = tuple(name for name in not_shown(naming.screened) if name not in seen)
    tried = {each.candidate.entry.id for each in naming.screened}
    nameless = "" if differ_namelessly(against.control) else naming.nameless
    verdict = _verdict((*effects, *doubted), moved, unseen, nameless)
    named = {*seen, *(each.parameter for each in moved)}
    silent = (
        *unseen,
        *(name for name in streams_and_numbers_not_shown(naming.screened) if name not in named),
        *(name for name in numbers_not_shown(naming.screened) if name.partition(":")[0] not in named),
    )
    return Diagnosis(
        verdict,
        difference_sentence(verdict, effects, moved, nameless, vague, either),
        moved,
        (),
        effects,
        silent,
        advised(effects, [name for name in unseen if name in tried], intake.evidence.platform),
        table,
        (),
        screened_effects(naming.screened),
        residual_forces(base, courses[0]),
        residual_forces(final, courses[1]),
        readings=residual_readings(SmoothedFit(base, courses[0]), SmoothedFit(final, courses[1]), effects),
        free_runs=runs,
        gathered=gathered_evidence(base, final),
        velocities=course_velocities(final, courses[1]),
        remarks=(*intake.evidence.remarks, *_of_taken_back(against.taken_back), *against.remarks),
        needed_nats=NAMING.threshold,
        noise=noise_levels(final),
        warnings=(
            *(each.sentence for each in stops if each.effect is None),
            *left_over_words(naming.nameless, against.control),
        ),
        untold=(
            *doubts(REFUSED, against.in_doubt),
            *doubts(VAGUE, vague),
            *map(of_either, either),
            *doubts(TRACE, traces),
            *of_unsettled(unsettled),
        ),
        against=replace(against, in_doubt=(*against.in_doubt, *doubted, *traces, *unsettled)),
        unrecorded=unrecorded(base.tracks),
        not_looked_for=not_looked_for(intake.evidence.platform),
    )


def _of_another(
    unlike: Sequence[Unlike], evidence: Evidence, against: Comparison, to_learned: Sequence[Objection]
) -> Diagnosis:
    """The diagnosis of recordings that do not look like the same vehicle: nothing is named, and no manoeuvre helps."""
    robots = tuple(each.robot for each in unlike)
    reasons = (*map(other_vehicle_sentence, unlike), *(each.sentence for each in to_learned))
    headline = other_vehicle_headline(unlike[0].robot, unlike[0].factors)
    return replace(
        of_another_vehicle(evidence, reasons, headline),
        remarks=(*evidence.remarks, *_of_taken_back(against.taken_back), *against.remarks),
        against=replace(against, unlike=robots),
    )


def _beyond_doubt(naming: Naming, effects: tuple[FoundEffect, ...]) -> tuple[tuple[FoundEffect, ...], tuple[str, ...]]:
    """Differences whose size is more than nothing, and the names of those whose size may as well be nothing.

    One whose 99 % interval holds nothing in each amplitude may explain readings by what stands beside it in the fit.
    """
    entries = {(each.candidate.entry.id, each.candidate.entry.topic): each.candidate.entry for each in naming.named}

    def is_doubted(effect: FoundEffect) -> bool:
        entry = entries.get((effect.id, effect.topic))
        surer = {name: each.wider(COMPARISON.surer) for name, each in effect.parameters.items()}
        return entry is not None and entry.may_be_nothing(surer)

    doubted = dict.fromkeys(name_of(effect.id, effect.topic) for effect in effects if is_doubted(effect))
    return tuple(effect for effect in effects if not is_doubted(effect)), tuple(doubted)


def _clearly_moved(numbers: Sequence[Recalibrated]) -> tuple[tuple[Recalibrated, ...], tuple[str, ...]]:
    """Numbers that are not what they were before, and the names of those whose 99 % interval holds that value."""
    vague = [each for each in numbers if each.estimate.wider(COMPARISON.surer).holds(each.nominal)]
    return tuple(each for each in numbers if each not in vague), tuple(each.parameter for each in vague)


def _judged_part(naming: Naming, fit: Fit, judged: Judged) -> Fit:
    """Take the judged tracks out of a fit; only what differs there goes on being fitted."""
    own = [unknown for unknown in fit.unknowns if any(each.candidate.owns(unknown) for each in naming.named)]
    return part_of(fit, judged.numbers, own)


def _verdict(
    differing: Sequence[FoundEffect | str], moved: Sequence[Recalibrated], unseen: Sequence[str], nameless: str
) -> Verdict:
    if differing or nameless:
        return "mismatch"
    if moved:
        return "recalibrate"
    return "insufficient" if len(set(IDS) - set(unseen)) < COMPARISON.least_shown else "consistent"
