"""A fit that has gone wrong is said in a sentence, and what it found is suspected at most."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, HeldOut
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, READING, Owner, Unknown
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.showing import hard_stops
from cocorosim_ros.diagnosis.showing.beside_a_law import beside_a_law, beside_an_error, beside_nameless
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.diagnosis.showing.coloured_innovations import coloured_innovations
from cocorosim_ros.diagnosis.showing.hard_stops import STOPS, objections, stopped
from cocorosim_ros.diagnosis.showing.lost import lost_robots


@pytest.fixture(scope="module")
def sound(swim: Any) -> Case:
    """A swim of a minute under the very model, its base fit and course, and nothing found."""
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.scenario.parts.platform import load_platform

    fit = base_fit(swim(load_platform("lily"), 60.0, seed=31))
    return Case(fit, (), (), smoothed_tracks(fit), {"position": row(0.01, 0.01)})


def row(nominal: float, recalibrated: float, augmented: float | None = None) -> HeldOut:
    """Errors of free runs, each known to a tenth; without effects the augmented model is the recalibrated one."""
    errors = {"nominal": nominal, "recalibrated": recalibrated, "augmented": augmented or recalibrated}
    intervals = {model: (0.9 * error, 1.1 * error) for model, error in errors.items()}
    return HeldOut(nominal, recalibrated, errors["augmented"], min(errors.values()), "m", intervals)


def named(case: Case, identifier: str, **parameters: float) -> Case:
    """The case with an effect that was found, its numbers as given, each known to one."""
    from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
    from cocorosim_ros.diagnosis.fitting.candidate import expand
    from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
    from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect

    candidates = expand(ENTRIES, case.final.tracks, case.final.rows)
    candidate = next(each for each in candidates if each.entry.id == identifier)
    units = {each.owner.parameter: each.owner.unit for each in candidate.amplitudes()}
    estimates = {name: Estimate(value, value - 1.0, value + 1.0, units[name]) for name, value in parameters.items()}
    found = FoundEffect(identifier, "", "", ("lily_01",), "confirmed", estimates, 100.0, topic=candidate.entry.topic)
    new = candidate.amplitudes()
    base = {each.name: each.neutral for each in candidate.entry.amplitudes}
    q = [(parameters.get(each.owner.parameter, base[each.owner.parameter]) - each.base) / each.scale for each in new]
    fit = replace(case.final, unknowns=(*case.final.unknowns, *new), q=np.concatenate([case.final.q, q]))
    effect = NamedEffect(candidate, 100.0, (), HeldOutGain(np.zeros(1), 0.01))
    return replace(case, final=fit, found=(found,), named=(effect,))


def sentences(stop: Callable[[Case], Any], case: Case) -> list[str]:
    """What a stop says of a case."""
    return [each.sentence for each in stop(case)]


def test_a_sound_fit_meets_no_objection(sound: Case) -> None:
    """Not one stop says anything of the right model."""
    assert objections(sound) == ()


def test_every_stop_is_in_the_table() -> None:
    """Functions of the module that object are the table, each once."""
    written = {name for name, each in vars(hard_stops).items()
               if callable(each) and (each.__doc__ or "").startswith("Object to")}  # fmt: skip
    assert sorted(written) == sorted(stop.__name__ for stop in STOPS)


def test_a_number_at_the_end_of_its_range(sound: Case) -> None:
    """The drag at its bound is said, with its value, for its robot alone."""
    place = next(index for index, each in enumerate(sound.final.unknowns) if each.owner.parameter == "drag")
    unknowns, q = list(sound.final.unknowns), sound.final.q.copy()
    unknowns[place] = replace(unknowns[place], bounds=(-1.0, math.log(2.0)))
    q[place] = math.log(2.0)
    case = replace(sound, final=replace(sound.final, unknowns=tuple(unknowns), q=q))
    (objection,) = hard_stops.number_at_a_bound(case)
    assert "drag of lily_01 stands at the end of its range, 3.56 kg/m" in objection.sentence  # twice 1.7778
    assert objection.robots == ("lily_01",)
    q[place] = 0.99 * math.log(2.0)
    assert sentences(hard_stops.number_at_a_bound, case) == []
    bias = replace(unknowns[place], column="torque_bias.torque", base=0.0, logarithmic=False, bounds=(0.0, 1.0))
    for value, said in ((0.0, 0), (1.0, 1)):  # an effect of the vehicle's own that is not there, and one at its most
        unknowns[place], q[place] = bias, value
        own = replace(sound, final=replace(sound.final, unknowns=tuple(unknowns), q=q.copy()))
        assert len(sentences(hard_stops.number_at_a_bound, own)) == said


@pytest.mark.parametrize(("end", "said"), [(-1.0, True), (1.0, False)])
def test_a_torque_that_is_as_small_as_may_be_hints_at_exchanged_commands(sound: Case, end: float, said: bool) -> None:
    """Left and right that are exchanged turn the model the other way; a large torque says no such thing."""
    unknowns, q = list(sound.final.unknowns), sound.final.q.copy()
    place = next(n for n, each in enumerate(unknowns) if each.owner.parameter == "drag")
    owner = replace(unknowns[place].owner, parameter="yaw_torque_gain", unit="1")
    unknowns[place] = replace(unknowns[place], owner=owner, bounds=(-1.0, 1.0))
    q[place] = end
    (told,) = sentences(
        hard_stops.number_at_a_bound, replace(sound, final=replace(sound.final, unknowns=tuple(unknowns), q=q))
    )
    assert told.endswith(", or columns or signs of the commands are exchanged in the map.") is said


def _asked(sentence: str) -> float:
    """Number that a sentence says is asked for, in its unit."""
    return float(sentence.partition("ask for ")[2].split()[0].replace("\u2212", "-"))


def test_less_than_none_of_an_effect_that_the_file_has(sound: Case, swim: Any) -> None:
    """A weight where the file's range has buoyancy alone is said; no buoyancy at all is not."""
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.quantity import Quantity
    from cocorosim_ros.scenario.reading.ranges import Range

    def lily(force: float) -> Any:
        return replace(
            load_platform("lily"), effect_quantities={"buoyancy_trim": {"force": Quantity(force, "N", "force")}}
        )

    declared = replace(lily(2e-4), ranges={"effects.buoyancy_trim.force": Range(0.0, 1e-3, "N")})
    for force, said in ((-3e-4, 1), (0.0, 0)):
        case = replace(sound, final=base_fit(swim(lily(force), 60.0, seed=31, base=declared)))
        told = [each for each in sentences(hard_stops.number_at_a_bound, case) if "force of buoyancy trim" in each]
        assert len(told) == said and all(-300.0 * 1.15 < _asked(each) < -300.0 / 1.15 for each in told)


@pytest.mark.parametrize(("times", "said"), [(2.5, 0), (3.5, 1)])
def test_free_runs_far_above_the_noise_floor(sound: Case, times: float, said: int) -> None:
    """What is named explains a part of something else at most; it is said with the channel."""
    far = replace(row(0.5, 0.5, 0.4), noise_floor=0.4 / times)
    case = replace(named(sound, "torque_bias", torque=1.5), table={"depth": far})
    told = sentences(hard_stops.beyond_the_floor, case)
    assert len(told) == said and all(
        "400\u00a0mm in depth, 3.50 times as much as with a force without a name" in each for each in told
    )
    by_course = replace(case, table={"depth": replace(far, against="course")})
    assert sentences(hard_stops.beyond_the_floor, by_course) == []
    of_readings = replace(named(sound, "pressure_offset", offset=50.0), table=case.table)
    assert sentences(hard_stops.beyond_the_floor, of_readings) == []


@pytest.mark.parametrize(
    ("errors", "best"),
    [
        ((0.1, 0.5, 0.4), "the platform as given"),
        ((0.5, 0.1, 0.4), "the fitted numbers alone"),
        ((0.5, 0.5, 0.4), None),
    ],
)
def test_a_floor_that_is_too_high_excuses_nothing(
    sound: Case, errors: tuple[float, float, float], best: str | None
) -> None:
    """Four times the error of another model is said, though a force without a name errs as much; the least is not."""
    case = replace(named(sound, "torque_bias", torque=1.5), table={"depth": replace(row(*errors), noise_floor=0.45)})
    told = sentences(hard_stops.beyond_the_floor, case)
    assert len(told) == (best is not None) and all(f"4.00 times as much as with {best}:" in each for each in told)


@pytest.mark.parametrize(
    ("before", "after", "said"), [(0.2, 0.19, 0), (0.2, 0.203, 0), (0.2, 0.23, 1), (1e-6, 2e-6, 0)]
)
def test_free_runs_that_are_worse_with_all_that_is_named(sound: Case, before: float, after: float, said: int) -> None:
    """However each effect did when it was named; not of a hundredth more, nor of what the filter's steps make."""
    table = {"position": replace(row(0.5, before, after), noise_floor=before)}
    case = replace(named(sound, "torque_bias", torque=1.5), table=table)
    told = sentences(hard_stops.foretold_no_better, case)
    assert len(told) == said and all("err more with all that is named" in each for each in told)
    by_course = replace(case, table={"position": replace(table["position"], against="course")})
    assert sentences(hard_stops.foretold_no_better, by_course) == []
    of_readings = replace(named(sound, "pressure_offset", offset=50.0), table=table)
    assert sentences(hard_stops.foretold_no_better, of_readings) == []


@pytest.mark.parametrize(("column", "said"), [("linear_drag.heave", 0), ("linear_drag.sway", 1)])
def test_numbers_of_the_motion_upwards_say_nothing_against_a_turn(sound: Case, column: str, said: int) -> None:
    """A drag upwards at the end of its range concerns a trim of the buoyancy, and no torque; one sideways does both."""
    torque, trim = named(sound, "torque_bias", torque=1.5), named(sound, "buoyancy_trim", force=1.5)
    both = replace(torque, found=(*torque.found, *trim.found), named=(*torque.named, *trim.named))
    number, *_ = (each for each in both.final.unknowns if each.owner.effect == PLATFORM)
    at_its_end = replace(number, column=column, base=0.0, logarithmic=False, bounds=(0.0, 1.0))
    unknowns, q = (*both.final.unknowns, at_its_end), np.append(both.final.q, 1.0)
    case = replace(both, final=replace(both.final, unknowns=unknowns, q=q))
    (objection,) = hard_stops.number_at_a_bound(case)
    assert [objection.concerns(each) for each in case.found] == [bool(said), True]


def test_an_effect_at_the_end_of_what_is_looked_for(sound: Case) -> None:
    """A dead band at its least is none, and neutral; one at its most is said."""
    case = named(sound, "thruster_deadband", width=0.2)
    assert sentences(hard_stops.effect_at_a_bound, case) == []
    unknowns = (*case.final.unknowns[:-1], replace(case.final.unknowns[-1], bounds=(0.0, float(case.final.q[-1]))))
    (said,) = sentences(hard_stops.effect_at_a_bound, replace(case, final=replace(case.final, unknowns=unknowns)))
    assert "width stands at the end of what is looked for, 0.200." in said
    unknowns = (*case.final.unknowns[:-1], replace(case.final.unknowns[-1], bounds=(0.0, 1.0)))
    q = np.append(case.final.q[:-1], 0.0)
    neutral = replace(case, final=replace(case.final, unknowns=unknowns, q=q))
    assert sentences(hard_stops.effect_at_a_bound, neutral) == []


def test_an_interval_that_holds_zero(sound: Case) -> None:
    """An effect stands as long as one of its amplitudes is clear."""
    assert len(sentences(hard_stops.interval_holds_zero, named(sound, "torque_bias", torque=0.5))) == 1
    assert sentences(hard_stops.interval_holds_zero, named(sound, "torque_bias", torque=1.5)) == []
    assert sentences(hard_stops.interval_holds_zero, named(sound, "steady_current", x=0.1, y=2.0)) == []
    assert len(sentences(hard_stops.interval_holds_zero, named(sound, "steady_current", x=0.1, y=-0.9))) == 1


@pytest.mark.parametrize(("x", "said"), [(0.9, 0), (1.05, 1), (1.2, 0)])
def test_one_clear_amplitude_of_several_is_chance(sound: Case, x: float, said: int) -> None:
    """Each is known to one at 95 %: of two, 2.241 / 1.960 = 1.144 is needed by the normal distribution.

    Below one the other stop speaks, and of a single amplitude one is enough.
    """
    current = named(sound, "steady_current", x=x, y=0.1)
    assert len(sentences(hard_stops.no_amplitude_is_clear, current)) == said
    assert sentences(hard_stops.no_amplitude_is_clear, named(sound, "torque_bias", torque=x)) == []


@pytest.mark.parametrize(("mean", "said"), [(-0.001, 1), (0.001, 0), (None, 0)])
def test_an_effect_that_foretells_nothing(sound: Case, mean: float | None, said: int) -> None:
    """Free runs that are no better with it are said; an error of readings, which they do not judge, is not."""
    case = named(sound, "torque_bias", torque=1.5)
    told = None if mean is None else Gain(mean, 0.01, 8)
    case = replace(case, named=tuple(replace(each, foretold=told) for each in case.named))
    assert len(sentences(hard_stops.foretells_nothing, case)) == said


@pytest.mark.parametrize(
    ("nominal", "recalibrated", "said"),
    [(0.1, 0.3, 1), (0.1, 0.105, 0), (0.3, 0.1, 0), (0.1, 0.1111, 0), (1e-6, 5e-6, 0)],
)
def test_a_collapsed_base(sound: Case, nominal: float, recalibrated: float, said: int) -> None:
    """Clearly worse than the platform as given, and by more than the steps of the filter err."""
    case = replace(sound, table={"depth": row(nominal, recalibrated)})
    assert len(sentences(hard_stops.collapsed_base, case)) == said


@pytest.mark.parametrize(("augmented", "said"), [(0.05, 0), (0.095, 1), (0.2, 1)])
def test_a_base_that_effects_cure_has_not_collapsed(sound: Case, augmented: float, said: int) -> None:
    """With them it foretells clearly better than the platform as given; as well as that is not enough."""
    case = replace(sound, table={"depth": row(0.1, 0.3, augmented)})
    assert len(sentences(hard_stops.collapsed_base, case)) == said


def test_a_course_that_leaves_its_readings(sound: Case) -> None:
    """Two centimetres deeper than the poses, which are exact to 2 mm, and the gauge says 196 Pa with 8 Pa of noise."""
    mean = sound.courses[0].mean.copy()
    mean[:, 2] -= 0.02
    said = sentences(hard_stops.strayed_course, replace(sound, courses=(replace(sound.courses[0], mean=mean),)))
    assert len(said) == 1 and "recordings" not in said[0]
    assert "the height of the pose by 21.0 mm, 10.5 times their noise; the pressure by 199 Pa, 24.9 times" in said[0]
    mean[:, 2] += 0.018  # 2 mm are within
    assert sentences(hard_stops.strayed_course, replace(sound, courses=(replace(sound.courses[0], mean=mean),))) == []


def test_predictions_that_err_to_one_side(sound: Case) -> None:
    """Innovations with a memory, and some three times as large as expected, are no noise."""
    (passed,), (track,) = sound.final.passes, sound.final.tracks
    chosen = track.timeline.kind == 0
    rng, count = np.random.default_rng(0), int(np.count_nonzero(chosen))

    def case(sizes: Any) -> Case:
        innovation = passed.innovation.copy()
        innovation[chosen] = sizes * np.sqrt(passed.variance[chosen])
        return replace(sound, final=replace(sound.final, passes=(replace(passed, innovation=innovation),)))

    slow = np.convolve(rng.standard_normal(count + 9), np.ones(10) / math.sqrt(10.0), "valid")  # correlation 0.9
    assert len(sentences(coloured_innovations, case(slow))) == 1
    assert sentences(coloured_innovations, case(0.1 * slow)) == []  # as of an exact simulation
    assert sentences(coloured_innovations, case(rng.standard_normal(count))) == []
    assert len(sentences(coloured_innovations, case(3.0 * rng.standard_normal(count)))) == 1


@pytest.mark.parametrize(
    ("column", "off", "words"),
    [
        # Poses are exact to 2 mm and 0.01 rad, and a Lily is 0.13 m long.
        (0, 0.3, "the pose along x by "),
        (0, 0.12, ""),
        (3, 1.5, "the heading of the pose by "),
        (3, 0.25, ""),
    ],
)
def test_a_course_that_follows_nothing(sound: Case, column: int, off: float, words: str) -> None:
    """A hundred times the noise, and more than the hull is long or 17 degrees: then the model is another vehicle's."""
    mean = sound.courses[0].mean.copy()
    mean[:, column] += off
    said = lost_robots(replace(sound, courses=(replace(sound.courses[0], mean=mean),)))
    begin = "The model does not follow the readings of lily_01: its most likely course leaves "
    assert len(said) == (1 if words else 0)
    assert all(words in each and each.startswith(begin) for each in said)
    assert lost_robots(sound) == ()


def test_a_random_force_that_grows_with_speed(sound: Case) -> None:
    """Innovations twice as large at speed are said of an effect by which free runs do not clearly gain, by how much."""
    (track,), (passed,), (course,) = sound.final.tracks, sound.final.passes, sound.courses
    speed = np.linalg.norm(course.mean[:, 4:7], axis=1)
    at = np.interp(track.timeline.stamp, course.time, (speed - speed.mean()) / speed.std())

    def case(growth: float, gain: float) -> Case:
        sizes = np.random.default_rng(1).standard_normal(len(at)) * np.sqrt(np.maximum(1.0 + growth * at, 0.05))
        passes = (replace(passed, innovation=sizes * np.sqrt(passed.variance)),)
        found = named(replace(sound, final=replace(sound.final, passes=passes)), "torque_bias", torque=1.5)
        return replace(found, named=tuple(replace(each, foretold=Gain(gain, 0.1, 8)) for each in found.named))

    (said,) = sentences(hard_stops.uneven_pushes, case(0.6, 0.1))
    assert "grows with speed" in said
    assert sentences(hard_stops.uneven_pushes, case(0.6, 0.5)) == []  # free runs gain five times their spread
    assert sentences(hard_stops.uneven_pushes, case(0.0, 0.1)) == []
    assert sentences(hard_stops.uneven_pushes, named(case(0.6, 0.1), "torque_bias", torque=1.5)) == []  # of no free run


def test_a_delay_beside_errors_that_last(sound: Case) -> None:
    """It may be a part of the filter's step, as a lag below one; nothing else is, nor a delay beside white errors."""
    owner = Owner(READING, ("lily_01",), "compass_memory", "s")
    memory = Unknown(owner, "memory.compass", (0,), base=math.log(0.5))

    def lasting(case: Case) -> Case:
        noise, q_noise = (*case.final.noise, memory), np.append(case.final.q_noise, 0.0)
        return replace(case, final=replace(case.final, noise=noise, q_noise=q_noise))

    late = named(sound, "sensor_latency", latency=1.5)
    assert len(sentences(hard_stops.lasting_errors, lasting(late))) == 1
    assert sentences(hard_stops.lasting_errors, late) == []
    assert sentences(hard_stops.lasting_errors, lasting(named(sound, "torque_bias", torque=1.5))) == []
    step = sound.final.tracks[0].timeline.grid.step
    for lag, said in ((0.4 * step, 1), (4.0 * step, 0)):
        slow = lasting(named(sound, "thruster_lag", time_constant=lag))
        assert len(sentences(hard_stops.lasting_errors, slow)) == said


def alone(case: Case) -> Case:
    """The case with poses as the only readings of its robots."""

    def with_poses(track: Any) -> Any:
        return replace(track, log=replace(track.log, streams={"pose": track.log.streams["pose"]}))

    return replace(case, final=replace(case.final, tracks=tuple(map(with_poses, case.final.tracks))))


def test_an_error_of_the_only_stream(sound: Case) -> None:
    """Nothing but the model speaks for it; another stream would, and of a torque or a clock it is not asked."""
    lever = named(sound, "pose_lever", ahead=2.0)
    (said,) = sentences(hard_stops.only_witness, alone(lever))
    assert "pose" in said and "which may be what is wrong" in said
    assert sentences(hard_stops.only_witness, lever) == []
    for other in (named(sound, "torque_bias", torque=1.5), named(sound, "clock_skew", skew=2.0)):
        assert sentences(hard_stops.only_witness, alone(other)) == []


def test_late_commands_beside_several_streams(sound: Case) -> None:
    """All of them may be late by as much; a difference from other recordings, whose stamps were the same, is none."""
    late = named(replace(sound, base=sound.final), "command_delay", delay=1.5)
    (said,) = sentences(hard_stops.only_clock, late)
    assert "all readings come late by as much" in said
    (said,) = sentences(hard_stops.only_clock, alone(late))
    assert "one stream, pose" in said
    assert sentences(hard_stops.only_clock, replace(late, base=None)) == []


def test_readings_of_the_only_stream_that_come_late(sound: Case) -> None:
    """Commands that act late by as much look the same; beside another stream they do not, nor is a torque a delay."""
    late = named(sound, "sensor_latency", latency=0.3)
    (said,) = sentences(hard_stops.only_clock, alone(late))
    assert "commands act late" in said
    (effect,) = late.named  # a comparison shows a part of its tracks, whose numbers were those of all
    elsewhere = replace(effect, candidate=replace(effect.candidate, tracks=((7,),)))
    assert sentences(hard_stops.only_clock, alone(replace(late, named=(elsewhere,)))) == [said]
    assert sentences(hard_stops.only_clock, late) == []
    assert sentences(hard_stops.only_clock, alone(named(sound, "torque_bias", torque=1.5))) == []
    for beside, count in (("thruster_lag", 2), ("torque_bias", 1)):
        other = named(sound, beside, **{"time_constant" if count == 2 else "torque": 1.5})
        both = replace(late, found=(*late.found, *other.found), named=(*late.named, *other.named))
        told = sentences(hard_stops.only_clock, alone(both))
        assert len(told) == count and ("hardly tell" in told[-1]) == (count == 2)
        assert sentences(hard_stops.only_clock, alone(other)) == []


@pytest.mark.parametrize(("difference", "said"), [(0.2, 1), (2.0, 0)], ids=["may be nothing", "clear"])
def test_a_loss_of_all_thrust_beside_sides_that_differ(sound: Case, difference: float, said: int) -> None:
    """Only where their difference may be nothing (its interval is known to one); without it nothing is said."""
    loss = named(sound, "battery_sag", fraction_lost=3.0)
    sides = named(loss, "thruster_asymmetry", difference=difference)
    both = replace(sides, found=(*loss.found, *sides.found), named=(*loss.named, *sides.named))
    assert len(sentences(hard_stops.one_side_alone, both)) == said
    assert sentences(hard_stops.one_side_alone, loss) == []
    assert all(each.effect is loss.found[0] for each in hard_stops.one_side_alone(both))


@pytest.mark.parametrize(
    ("nats", "equation", "said"), [(400.0, "world_x", 1), (50.0, "world_x", 0), (400.0, "heave", 0)]
)
def test_a_small_effect_beside_a_law_of_the_same_force(sound: Case, nats: float, equation: str, said: int) -> None:
    """A tether of 20 nats beside a law of the place of 400; not beside one that is hardly stronger, or acts upwards."""
    from cocorosim_ros.diagnosis.catalogue.law_forms import single
    from cocorosim_ros.world.laws.law import Law

    case = named(sound, "tether", stiffness=2.0)
    (tether,), (effect,) = case.found, case.named
    law = Law(equation, single("x"))
    entry = replace(effect.candidate.entry, id=f"unknown:{equation}~x", channel=equation, form=law, law="law_1")
    of_law = replace(effect, candidate=replace(effect.candidate, entry=entry), nats=nats)
    found = (replace(tether, nats=20.0), replace(tether, id=f"unknown:{equation}~x", nats=nats))
    both = replace(case, found=found, named=(effect, of_law))
    assert len(sentences(beside_a_law, both)) == said
    assert all(each.effect is found[0] for each in beside_a_law(both))


@pytest.mark.parametrize(
    ("reading", "nats", "said"), [("pose_z", 1000.0, 1), ("pose_z", 100.0, 0), ("pose_x", 1000.0, 0)]
)
def test_a_small_law_of_readings_beside_an_error_of_the_same_depth(
    sound: Case, reading: str, nats: float, said: int
) -> None:
    """A law of the pose's depth of 20 nats beside a drift of the pressure; one of its place is another matter."""
    from cocorosim_ros.world.laws.law import Law, Product

    case = named(sound, "pressure_drift", rate=2.0)
    (drift,), (effect,) = case.found, case.named
    entry = replace(
        effect.candidate.entry,
        id="unknown:pose~x*x",
        topic="pose",
        form=Law(reading, Product.parse("x*x")),
        law="law_1",
    )
    of_law = replace(effect, candidate=replace(effect.candidate, entry=entry), nats=20.0)
    found = (replace(drift, nats=nats), replace(drift, id="unknown:pose~x*x", topic="pose", nats=20.0))
    both = replace(case, found=found, named=(effect, of_law))
    assert len(sentences(beside_an_error, both)) == said
    assert all(each.effect is found[1] for each in beside_an_error(both))


@pytest.mark.parametrize(
    ("law", "said"), [("unknown:surge~|u|^0.5*u", 1), ("unknown:heave~w", 0), ("unknown:pressure~u*u", 0), ("", 0)]
)
def test_an_effect_beside_what_is_left_without_a_name(sound: Case, law: str, said: int) -> None:
    """A linear drag beside a force ahead of another form; not beside one upwards, or an error of readings."""
    drag = named(sound, "linear_drag", surge=2.0)
    assert drag.named[0].candidate.entry.channel in ("surge", "sway")
    assert len(list(beside_nameless(drag, law))) == said
    compass = named(sound, "compass_distortion", offset=1.5)
    assert list(beside_nameless(compass, law)) == []


@pytest.mark.parametrize(("level", "said"), [(1, 0), (2, 1), (4, 1)])
def test_an_angle_of_all_thrusters_of_many(sound: Case, level: int, said: int) -> None:
    """Of a single one in the level plane it is said as it is; of more one alone may be turned."""
    case = named(sound, "thruster_misalignment", angle=1.5)
    (track,) = case.final.tracks
    wrench = np.zeros((level + 1, 4))
    wrench[:level, 0], wrench[level, 2] = 1.0, 1.0
    vehicle = SimpleNamespace(actuator_wrench=wrench, is_thruster=np.ones(level + 1, dtype=bool))
    final: Any = SimpleNamespace(tracks=(SimpleNamespace(name=track.name, vehicle=vehicle),))
    many = replace(case, final=final)
    assert len(sentences(hard_stops.all_askew, many)) == said


@pytest.mark.parametrize(("surge", "sway", "said"), [(0.5, 3.0, 1), (1.5, 6.0, 0), (0.5, 1.4, 0)])
def test_a_linear_drag_that_does_not_brake_ahead(sound: Case, surge: float, sway: float, said: int) -> None:
    """It may be none ahead and is surely more across: a ratio of the axes by another law. Each is known to one."""
    case = named(sound, "linear_drag", surge=surge, sway=sway, heave=0.2, yaw=5.0)
    assert len(sentences(hard_stops.drag_but_ahead, case)) == said
    assert sentences(hard_stops.drag_but_ahead, named(sound, "anisotropic_drag", sway_ratio=3.0)) == []


@pytest.mark.parametrize(("loss", "said"), [(3.0, 1), (4.5, 1), (6.0, 0), (0.5, 0)])
def test_a_loss_that_takes_back_a_gain(sound: Case, loss: float, said: int) -> None:
    """Thrust that falls by 3 s/m rises by as much against the motion, each known to one; alone the loss is a loss."""
    against = named(sound, "crashback_loss", slope=loss)
    both = named(against, "advance_loss", slope=3.0)
    case = replace(both, found=(*against.found, *both.found), named=(*against.named, *both.named))
    assert len(sentences(hard_stops.gain_taken_back, case)) == said
    assert sentences(hard_stops.gain_taken_back, against) == []


def test_noise_that_is_a_guess(sound: Case) -> None:
    """A stream whose readings were interpolated is said, with its columns."""
    (track,) = sound.final.tracks
    streams = {**track.log.streams, "pose": replace(track.log.streams["pose"], filled_in=("x", "y"))}
    tracks = (replace(track, log=replace(track.log, streams=streams)),)
    (said,) = sentences(hard_stops.unknown_noise, replace(sound, final=replace(sound.final, tracks=tracks)))
    assert "x, y of lily_01/pose" in said


def test_what_is_objected_to_is_suspected_at_most() -> None:
    """The name and its numbers stay; a mix-up that was put right before any fit is as sure as it was."""
    one, other = (FoundEffect("torque_bias", "", "", (robot,), "confirmed", {}, 50.0) for robot in ("a", "b"))
    mixed = replace(one, id="frame_mixup", correction="x and y are exchanged")
    found = stopped((one, other, mixed), (Objection("Of a.", ("a",)), Objection("Of this.", effect=other)))
    assert [(each.tier, each.because) for each in found] == [
        ("suspected", ("Of a.",)),
        ("suspected", ("Of this.",)),
        ("confirmed", ()),
    ]
    assert stopped((one,), (Objection("Of all."),))[0].because == ("Of all.",)
    assert stopped((one,), ())[0] is one
    assert HARD_STOPS.worse > 1.0


def test_objections_to_an_effect_are_said_once(sound: Case, monkeypatch: pytest.MonkeyPatch) -> None:
    """An effect has parameters, which no set can hold; the same sentence of two stops is one."""
    effect = FoundEffect(
        "torque_bias", "", "", ("lily_01",), "confirmed", {"torque": Estimate(1.0, 0.9, 1.1, "N m")}, 9.0
    )

    def stop(case: Case) -> Iterator[Objection]:
        yield Objection("Its size may as well be nothing.", effect=effect)

    monkeypatch.setattr(hard_stops, "STOPS", (stop, stop))
    (objection,) = objections(sound)
    assert objection.concerns(effect)
