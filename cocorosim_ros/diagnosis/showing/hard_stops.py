"""Hard stops: signs that a fit has gone wrong, each a sentence, under which no effect is more than suspected.

However strong its evidence, an effect that was found by a fit which stands at a bound, or whose course has left its
readings, explains the fault of that fit. Its name stays, since it may help; its tier does not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from scipy.stats import norm

from cocorosim_ros.diagnosis.against.numbers import DELAY
from cocorosim_ros.diagnosis.against.twins import LATE_READINGS, streams_of
from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.diagnosis.fitting.coloured_readings import memories_of, robots_of
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Z95, Unknown
from cocorosim_ros.diagnosis.foretelling.collapse import collapsed_channels
from cocorosim_ros.diagnosis.naming.steering_trims import pushes_upwards
from cocorosim_ros.diagnosis.showing.beside_a_law import beside_a_law, beside_an_error
from cocorosim_ros.diagnosis.showing.beyond_a_bound import beyond_a_bound
from cocorosim_ros.diagnosis.showing.beyond_the_floor import beyond_the_floor
from cocorosim_ros.diagnosis.showing.case import Case, Objection, Stop, effects_of
from cocorosim_ros.diagnosis.showing.coloured_innovations import coloured_innovations
from cocorosim_ros.diagnosis.showing.drag_but_ahead import drag_but_ahead
from cocorosim_ros.diagnosis.showing.gain_taken_back import gain_taken_back
from cocorosim_ros.diagnosis.showing.remainder import remainder
from cocorosim_ros.diagnosis.showing.slow_steering import slow_steering
from cocorosim_ros.diagnosis.showing.strayed_course import strayed_course
from cocorosim_ros.diagnosis.showing.uneven_noise import uneven_noise
from cocorosim_ros.diagnosis.showing.untold_advance import untold_advance
from cocorosim_ros.diagnosis.showing.untold_distortion import untold_distortion
from cocorosim_ros.diagnosis.showing.untold_form import untold_form
from cocorosim_ros.diagnosis.showing.untold_lever import untold_lever
from cocorosim_ros.diagnosis.showing.untold_turn import untold_turn
from cocorosim_ros.diagnosis.showing.whole_gain import foretold_no_better
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL, OF_TIME
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.units.quantity_text import said_quantity
from cocorosim_ros.world.effects import FINS
from cocorosim_ros.world.state.state import X, Y

_LAGS = ("thruster_lag", "pump_lag")
_LEVEL = ("sway", "yaw", "compass")
"""Channels of effects that the motion upwards hardly touches; what drives a vehicle ahead it does where it pitches."""
ALL_THRUST, ONE_SIDE = "battery_sag", "thruster_asymmetry"
ASKEW = "thruster_misalignment"

FORETELLS_NOTHING = "Free runs through data that no fit saw err no less with it than without it."


def number_at_a_bound(case: Case) -> Iterator[Objection]:
    """Object to numbers of the platform that stand at the end of their range, but for effects that are absent there.

    An effect is absent where the recordings do not ask for less than none of it, as for a weight where the file's range
    has buoyancy alone. Numbers of the motion upwards say nothing against what moves a vehicle sideways, turns it, or is
    of its compass.
    """
    level = tuple(found for found, named in effects_of(case) if named.candidate.entry.channel in _LEVEL)
    for place, (unknown, q) in enumerate(zip(case.final.unknowns, case.final.q.tolist(), strict=True)):
        if unknown.owner.effect == PLATFORM and any(unknown.at_ends(q)) and (asked := _asked_beyond(case.final, place)):
            yield Objection(
                f"The fit of {parameter_words(unknown.owner.parameter)} of {_listed(unknown.owner.robots)} "
                f"stands at the end of its range, {said_quantity(unknown.value(q), unknown.owner.unit)}; the "
                f"recordings ask for {asked} that the platform's file leaves out{_or_exchanged(unknown, q)}.",
                unknown.owner.robots,
                spared=level if _is_upright(unknown, case.final.tracks) else (),
            )


def _or_exchanged(unknown: Unknown, q: float) -> str:
    """Words for what else makes a torque as small as may be: commands whose sign is the other one turn the model."""
    low, _ = unknown.at_ends(q)
    if not low or unknown.owner.parameter != "yaw_torque_gain":
        return ""
    return ", or columns or signs of the commands are exchanged in the map"


def _asked_beyond(fit: Fit, place: int) -> str:
    """Words for what a number at a bound is asked to be; '' for that of no effect, if it is hardly asked to be less."""
    unknown = fit.unknowns[place]
    if "." not in unknown.column or unknown.value(float(fit.q[place])) != NEUTRAL[COLUMN[unknown.column]]:
        return "a number"
    beyond = beyond_a_bound(fit, place)
    return said_quantity(beyond.value, unknown.owner.unit) if beyond.nats > HARD_STOPS.pressed else ""


def _is_upright(unknown: Unknown, tracks: Sequence[Track]) -> bool:
    """Tell whether a number is of the motion upwards alone."""
    effect, _, name = unknown.column.partition(".")
    if effect in FINS:
        return all(pushes_upwards(tracks[number].vehicle, unknown.column) for number in unknown.tracks)
    return "heave" in name or unknown.column in ("buoyancy_gain", "net_buoyancy", "buoyancy_trim.force")


def effect_at_a_bound(case: Case) -> Iterator[Objection]:
    """Object to effects with a number at the end of what is looked for, but for one that is neutral there."""
    for found, named in effects_of(case):
        for unknown, q in zip(case.final.unknowns, case.final.q.tolist(), strict=True):
            if named.candidate.owns(unknown) and set(found.robots) <= set(unknown.owner.robots):
                neutral = {each.column: each.neutral for each in named.candidate.entry.amplitudes}
                if any(unknown.at_ends(q)) and not np.isclose(
                    unknown.value(q), neutral.get(unknown.column, np.nan), atol=1e-9 * abs(unknown.scale)
                ):
                    yield Objection(
                        f"Its {unknown.owner.parameter.replace('_', ' ')} stands at the end of what is looked for, "
                        f"{said_quantity(unknown.value(q), unknown.owner.unit)}.",
                        effect=found,
                    )


def interval_holds_zero(case: Case) -> Iterator[Objection]:
    """Object to effects each of whose amplitudes may as well be neutral."""
    for found, named in effects_of(case):
        if named.candidate.entry.may_be_nothing(found.parameters):
            yield Objection(
                "Its size may as well be nothing: the 95 % interval of each of its amplitudes holds the value at which "
                "it does nothing.",
                effect=found,
            )


def no_amplitude_is_clear(case: Case) -> Iterator[Objection]:
    """Object to effects of several amplitudes of which one is clear by itself, and none at 95 % for all together.

    Of six numbers that are nothing one in four times one is clear by itself. Bonferroni's bound holds for all together.
    """
    for found, named in effects_of(case):
        entry = named.candidate.entry
        count = len(entry.doubts(found.parameters))
        if count < 2 or entry.may_be_nothing(found.parameters):
            continue
        times = float(norm.isf(0.5 * HARD_STOPS.chance / count)) / Z95
        if entry.may_be_nothing({name: each.wider(times) for name, each in found.parameters.items()}):
            yield Objection(
                f"Of its {count} amplitudes each may as well be nothing, at 95 % for all of them together.",
                effect=found,
            )


def foretells_nothing(case: Case) -> Iterator[Objection]:
    """Object to effects by which free runs on unseen data gain nothing."""
    for found, named in effects_of(case):
        if named.foretold is not None and named.foretold.mean <= 0.0:
            yield Objection(FORETELLS_NOTHING, effect=found)


def uneven_pushes(case: Case) -> Iterator[Objection]:
    """Object to effects of motion that evidence alone speaks for, where the random force is not the same at all times.

    Free runs that clearly gain by an effect speak for it too.
    """
    uneven = uneven_noise(case.final.tracks, case.final.passes, case.courses)
    if not uneven:
        return
    growth = " and ".join(f"{each.quantity} (by {each.growth:.0%} for each standard deviation)" for each in uneven)
    for found, named in effects_of(case):
        if named.foretold is not None and not named.foretold.is_clear:
            yield Objection(
                f"What the model errs by grows with {growth}, which its evidence takes for the same at all times; free "
                "runs do not clearly gain by it.",
                effect=found,
            )


def collapsed_base(case: Case) -> Iterator[Objection]:
    """Object to a recalibrated model that foretells unseen data clearly worse than the platform as given."""
    for channel in collapsed_channels(case.table):
        row = case.table[channel]
        yield Objection(
            f"The recalibrated model foretells the {channel} worse than the platform as given does: it errs by "
            f"{said_quantity(row.recalibrated, row.unit)} instead of {said_quantity(row.nominal, row.unit)}; "
            "its fit has collapsed."
        )


def lasting_errors(case: Case) -> Iterator[Objection]:
    """Object to delays, skews and lags below a step, of robots whose readings have errors that last.

    The filter follows such errors from reading to reading by the rates at grid points, so that a part of a step may
    pass for a delay.
    """
    robots = robots_of(memories_of(case.final))
    for found, named in effects_of(case):
        is_delay = any(each.column in OF_TIME for each in named.candidate.entry.amplitudes)
        if not robots.isdisjoint(found.robots) and (is_delay or _is_below_a_step(case, found)):
            yield Objection(
                "Errors of these readings last, and the filter follows them from one reading to the next by whole "
                "steps, so that a part of a step may pass for a delay.",
                effect=found,
            )


def only_clock(case: Case) -> Iterator[Objection]:
    """Object to late readings of the only stream of a robot, to late commands, and to lags beside late streams.

    Nothing else there tells what time it is, and the sum of a delay and a lag is told far better than each of them.
    Where there are several streams all of them may be late, as after filters and buffers that are alike.
    """
    effects = [found for found, _ in effects_of(case)]
    late = [each for each in effects if each.id in (LATE_READINGS, DELAY) and _has_one_stream(case, each)]
    for found in late:
        (stream,) = streams_of(_tracks_of(case, found))
        yield Objection(
            f"All readings come from one stream, {stream}: whether it comes late or the commands act late by "
            "as much, as after a dead time of the actuators, these recordings cannot tell.",
            effect=found,
        )
    for found in effects:
        if found.id == DELAY and found not in late and case.base is not None:  # of differences stamps are as before
            yield Objection(
                "Whether the commands act late or all readings come late by as much, as after filters and buffers, "
                "these recordings cannot tell: flash a light on a command, and see when each instrument shows it.",
                effect=found,
            )
    for found in effects:
        if found.id in _LAGS and any(not set(each.robots).isdisjoint(found.robots) for each in late):
            yield Objection(
                "Beside it all readings, which come from one stream, are told to come late after their commands: how "
                "much of both together is the lag these recordings hardly tell.",
                effect=found,
            )


def only_witness(case: Case) -> Iterator[Objection]:
    """Object to errors, but those of stamps, of the readings of a robot's only stream: the model alone speaks for them.

    The lever of a pose, for one, and a moment that turns the vehicle both move what is shown beside the heading.
    """
    for found, named in effects_of(case):
        of_stamps = any(each.column in OF_TIME for each in named.candidate.entry.amplitudes)
        if named.candidate.entry.topic and not of_stamps and _has_one_stream(case, found):
            yield Objection(
                f"All readings come from one stream, {found.topic}: that it errs is told by how the model moves "
                "alone, which may be what is wrong.",
                effect=found,
            )


def _tracks_of(case: Case, found: FoundEffect) -> list[Track]:
    return [track for track in case.final.tracks if track.name in found.robots]


def _has_one_stream(case: Case, found: FoundEffect) -> bool:
    return len(streams_of(_tracks_of(case, found))) == 1


def _is_below_a_step(case: Case, found: FoundEffect) -> bool:
    """Tell whether a number of an effect is a time shorter than a step of the filter."""
    step = max(track.timeline.grid.step for track in _tracks_of(case, found))
    return any(each.unit == "s" and abs(each.value) < step for each in found.parameters.values())


def one_side_alone(case: Case) -> Iterator[Objection]:
    """Object to thrust that falls where the two sides differ by an amount that may be nothing.

    A thruster that fouls loses thrust alone: all of them together then seem to lose some, and one side to be weaker, by
    another amount in each part of the recording.
    """
    sides = [
        found
        for found, named in effects_of(case)
        if found.id == ONE_SIDE and named.candidate.entry.may_be_nothing(found.parameters)
    ]
    for found, _ in effects_of(case):
        if found.id == ALL_THRUST and any(not set(each.robots).isdisjoint(found.robots) for each in sides):
            yield Objection(
                "Beside it the sides differ in thrust, by another amount in each part of the recording: one thruster "
                "alone may lose thrust, as one that fouls does.",
                effect=found,
            )


def all_askew(case: Case) -> Iterator[Objection]:
    """Object to the one angle of all thrusters of a vehicle that has several in the level plane."""
    for found, _ in effects_of(case):
        if found.id == ASKEW and any(_level_thrusters(track) > 1 for track in _tracks_of(case, found)):
            yield Objection(
                "It turns all thrusters by the same angle, as a frame that is put in askew does. One of them alone, "
                "turned further, explains much of the same: look along each.",
                effect=found,
            )


def _level_thrusters(track: Track) -> int:
    """Count the thrusters of a vehicle that push in the level plane."""
    wrench = track.vehicle.actuator_wrench
    level = (wrench[:, X] != 0.0) | (wrench[:, Y] != 0.0)
    return int(np.count_nonzero(track.vehicle.is_thruster & level))


def unknown_noise(case: Case) -> Iterator[Objection]:
    """Object to readings many of which were interpolated or repeated, so that their noise is a guess."""
    for track in case.final.tracks:
        for topic, stream in track.log.streams.items():
            if stream.filled_in:
                yield Objection(
                    f"Many readings of {', '.join(stream.filled_in)} of {track.name}/{topic} were interpolated or "
                    "repeated; how exact the others are is not known well.",
                    (track.name,),
                )


STOPS: tuple[Stop, ...] = (
    number_at_a_bound,
    effect_at_a_bound,
    interval_holds_zero,
    no_amplitude_is_clear,
    foretells_nothing,
    foretold_no_better,
    uneven_pushes,
    collapsed_base,
    strayed_course,
    coloured_innovations,
    lasting_errors,
    only_clock,
    only_witness,
    beyond_the_floor,
    untold_lever,
    untold_distortion,
    untold_turn,
    untold_form,
    drag_but_ahead,
    gain_taken_back,
    untold_advance,
    slow_steering,
    one_side_alone,
    all_askew,
    beside_a_law,
    beside_an_error,
    unknown_noise,
    remainder,
)


def objections(case: Case) -> tuple[Objection, ...]:
    """All objections of all stops, each sentence once."""
    found: list[Objection] = []
    for each in (objection for stop in STOPS for objection in stop(case)):
        if each not in found:
            found.append(each)
    return tuple(found)


def stopped(found: Sequence[FoundEffect], against: Sequence[Objection]) -> tuple[FoundEffect, ...]:
    """Copy effects, each with the sentences that concern it, and suspected at most if there are any."""
    return tuple(_stopped(effect, [each.sentence for each in against if each.concerns(effect)]) for effect in found)


def _stopped(effect: FoundEffect, sentences: Sequence[str]) -> FoundEffect:
    return replace(effect, tier="suspected", because=tuple(sentences)) if sentences else effect


def _listed(robots: Sequence[str]) -> str:
    return ", ".join(robots)
