"""What actuators report beside a diagnosis: sentences that a mechanic understands, and names that they explain."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.diagnose_against import diagnose_against
from cocorosim_ros.diagnosis.evidence.streams.feedback import Feedback
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.findings import ActuatorReport, Diagnosis, Estimate, FoundEffect
from cocorosim_ros.diagnosis.showing.actuator_changes import change_sentences
from cocorosim_ros.diagnosis.showing.actuator_names import name_sentences
from cocorosim_ros.diagnosis.showing.actuator_sentences import report_sentences, with_interval
from cocorosim_ros.diagnosis.showing.actuators import with_actuators
from cocorosim_ros.scenario.parts.platform import load_platform

SAID = Diagnosis("consistent", "", (), (), (), (), (), {}, remarks=("ferry/pose: it was so.",))


def numbers(lateness: float, gain: float = 1.0, width: float = 0.03, unit: str = "1") -> dict[str, Estimate]:
    """The numbers of a report, all times with one half-width [s]."""
    times = {"delay": 0.8 * lateness, "time_constant": 0.2 * lateness, "lateness": lateness}
    found = {name: Estimate(value, max(value - width, 0.0), value + width, "s") for name, value in times.items()}
    return {"gain": Estimate(gain, gain - 0.01, gain + 0.01, unit)} | found


def angle(name: str, lateness: float, gain: float = 1.0, before: dict[str, Estimate] | None = None) -> ActuatorReport:
    """An azimuth of the ferry."""
    return ActuatorReport("ferry", name, "angle", numbers(lateness, gain), before=before or {})


def named(identifier: str, parameter: str, seconds: float, topic: str | None = None) -> FoundEffect:
    """An effect with one number [s]."""
    estimate = {parameter: Estimate(seconds, seconds - 0.05, seconds + 0.05, "s")}
    return FoundEffect(identifier, "", "", ("ferry",), "confirmed", estimate, 50.0, topic=topic)


POSES = named("sensor_latency", "latency", 0.71, "pose")


def test_who_follows_by_how_much() -> None:
    """One sentence for each quantity: by what time with its interval, how far, and how fast."""
    limited = angle("azimuth_2", 0.75)
    limited = replace(limited, numbers={**limited.numbers, "rate_limit": Estimate(0.7, 0.68, 0.72, "rad/s")})
    reports = (angle("azimuth_1", 0.66), limited, angle("azimuth_3", 0.7, gain=0.9))
    assert list(report_sentences(reports)) == [
        "ferry, angle as reported: azimuth_1 follows its command by 0.66 s (0.63 to 0.69); azimuth_2 by 0.75 s (0.72 "
        "to 0.78), at most 40.1 deg/s; azimuth_3 by 0.70 s (0.67 to 0.73), and comes to 0.900 (0.890 to 0.910) of it."
    ]


def test_what_does_not_tell_is_said_once() -> None:
    """Actuators with one reason share a sentence; that a battery's voltage follows nothing is no remark."""
    still = [ActuatorReport("ferry", name, "rotation", because="its command hardly changes") for name in ("a", "b")]
    battery = ActuatorReport("ferry", "a", "voltage", because="it does not follow its command")
    assert list(report_sentences([*still, battery])) == [
        "ferry, rotation as reported: a, b does not tell how it follows, since its command hardly changes."
    ]


@pytest.mark.parametrize(
    ("estimate", "words"),
    [
        (Estimate(0.6612, 0.6411, 0.6893, "s"), "0.66 s (0.64 to 0.69)"),
        (Estimate(2.96, 1.4, 4.5, "s"), "3.0 s (1.4 to 4.5)"),
        (Estimate(102.01, 74.8, 129.2, "rad/s"), "102 rad/s (75 to 129)"),
        (Estimate(0.5, 0.5, 0.5, "s"), "0.50 s (0.50 to 0.50)"),
    ],
)
def test_digits_are_those_of_the_interval(estimate: Estimate, words: str) -> None:
    """One digit of the half-width, no more than what is known."""
    assert with_interval(estimate) == words


def test_late_poses_are_explained_by_late_actuators() -> None:
    """0.71 s between the 0.66 and 0.77 s of the servos; motors that report much later do not hide that."""
    motors = ActuatorReport("ferry", "bow", "rotation", numbers(1.9, 100.0, unit="rad/s"))
    (sentence,) = name_sentences([POSES], [angle("a", 0.66), angle("b", 0.77), motors], compared=False)
    assert sentence == (
        "Readings of pose of ferry are told to be 0.71 s late, and its actuators report that they follow their "
        "commands by 0.66 to 0.77 s (angle): late actuators look like late readings, so that the readings may well be "
        "in time."
    )


def test_late_poses_that_quick_actuators_do_not_explain() -> None:
    """Within a tenth of a second of their commands, they are not what is late."""
    (sentence,) = name_sentences([POSES], [angle("a", 0.1), angle("b", 0.08)], compared=False)
    assert "by 0.08 to 0.10 s (angle) only: they do not explain it." in sentence


@pytest.mark.parametrize(
    ("seconds", "end"),
    [(0.3, "this is where the lateness arises."), (1.2, "or in clocks and readings that are late."), (0.04, "")],
)
def test_a_lag_of_the_thrust_beside_motors(seconds: float, end: str) -> None:
    """Motors 0.25 s late explain 0.3 s, contradict 1.2 s, and say nothing to what no sentence is worth; servos none."""
    motor = ActuatorReport("ferry", "bow", "rotation", numbers(0.25, 100.0, unit="rad/s"))
    lag = named("thruster_lag", "time_constant", seconds)
    said = list(name_sentences([lag], [motor], compared=False))
    assert [each.endswith(end) for each in said] == ([True] if end else [])
    assert list(name_sentences([lag], [angle("a", seconds)], compared=False)) == []


def test_a_difference_is_explained_by_what_has_grown() -> None:
    """Commands told to act 0.3 s later than before: servos late by 0.66 s then, and by 0.96 s now, are the reason."""
    late = named("command_delay", "delay", 0.3)
    grown, same = angle("a", 0.96, before=numbers(0.66)), angle("a", 0.67, before=numbers(0.66))
    (explained,) = name_sentences([late], [grown], compared=True)
    assert "by 0.30 s (angle) more than before: this is where the lateness arises." in explained
    (contradicted,) = name_sentences([late], [same], compared=True)
    assert "by 0.01 s (angle) only more than before: look for it behind them" in contradicted
    assert list(name_sentences([late], [angle("a", 0.96)], compared=True)) == []  # nothing is known of before


def test_later_and_less_than_before() -> None:
    """Beyond both intervals only; what hardly moved is silent."""
    was = numbers(0.66)
    assert list(change_sentences([angle("a", 0.68, before=was)])) == []
    (later,) = change_sentences([angle("a", 0.95, before=was)])
    assert later == (
        "ferry: a (angle as reported) follows its command later than in the recordings of --against: by 0.95 s (0.92 "
        "to 0.98), and there by 0.66 s (0.63 to 0.69)."
    )
    (less,) = change_sentences([angle("a", 0.66, gain=0.8, before=was)])
    assert "follows its command less than in the recordings of --against: 0.800 (0.790 to 0.810) of what is" in less
    (lost,) = change_sentences([ActuatorReport("ferry", "a", "angle", because="it does not follow", before=was)])
    assert lost.endswith("in the recordings of --against, and now it does not tell, since it does not follow.")


def recording(late: float) -> Evidence:
    """A recording in which one servo of the ferry follows its steps by so much, as a share of half a turn."""
    rng = np.random.default_rng(9)
    time, moments = np.arange(0.0, 200.0, 4.0), np.arange(0.0, 200.0, 0.1)
    command = np.zeros((len(time), 8))
    command[:, 1] = rng.uniform(-0.3, 0.3, len(time))
    held = command[np.clip(np.searchsorted(time, moments - late, side="right") - 1, 0, None), 1]
    log = RobotLog("ferry", time, command, {}, feedback=(Feedback("bow_port_angle", "fraction", moments, held),))
    return Evidence(load_platform("milliampere_ferry"), (RecordingLog("x", 200.0, (log,)),))


def test_a_diagnosis_keeps_its_names_and_gains_remarks() -> None:
    """What actuators report is beside all else, before the other remarks; where they are silent nothing changes."""
    told = with_actuators(replace(SAID, effects=(POSES,)), recording(0.75))
    assert told.effects == (POSES,)
    assert [report.actuator for report in told.actuators] == ["bow_port_angle"]
    assert told.actuators[0].numbers["lateness"].value == pytest.approx(0.75, abs=0.06)  # a report every 0.1 s
    assert told.remarks[0].startswith("Readings of pose of ferry are told to be 0.71 s late, and its actuators report")
    assert told.remarks[1].startswith("ferry, fraction as reported: bow_port_angle follows its command by 0.7")
    assert told.remarks[-1] == SAID.remarks[0]
    silent = replace(recording(0.75), recordings=(RecordingLog("x", 1.0, ()),))
    assert with_actuators(SAID, silent) is SAID


def test_what_was_before_stands_beside_it() -> None:
    """Of the recordings that these are compared with."""
    told = with_actuators(SAID, recording(1.15), recording(0.75))
    assert told.actuators[0].before["lateness"].value == pytest.approx(0.75, abs=0.06)
    assert "follows its command later than in the recordings of --against" in told.remarks[0]


def with_few_readings(evidence: Evidence) -> Evidence:
    """The same with three readings of a compass: too few for any model."""
    (only,) = evidence.recordings
    stream = Stream(np.arange(3.0), np.zeros((3, 1)), np.array([0.01]))
    return replace(
        evidence, recordings=(replace(only, robots=(replace(only.robots[0], streams={"compass": stream}),)),)
    )


def test_a_recording_that_tells_nothing_of_motion_tells_of_its_actuators() -> None:
    """No physics is needed for it: alone, and beside recordings of before."""
    bad, good = with_few_readings(recording(1.15)), with_few_readings(recording(0.75))
    alone = diagnose(bad, lambda words, share: None)
    assert alone.verdict == "insufficient"
    assert [each.actuator for each in alone.actuators] == ["bow_port_angle"] and not alone.actuators[0].before
    beside = diagnose_against(bad, good, lambda words, share: None)
    assert beside.verdict == "insufficient" and beside.against is not None
    assert "follows its command later than in the recordings of --against" in beside.remarks[0]
