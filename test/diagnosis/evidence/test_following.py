"""Actuators whose gain, dead time, lag and limit are known, found again in what they report."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.signal import lfilter

from cocorosim_ros.diagnosis.evidence.following.reports import actuator_reports
from cocorosim_ros.diagnosis.evidence.following.response import response
from cocorosim_ros.diagnosis.evidence.streams.feedback import Feedback
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog
from cocorosim_ros.diagnosis.findings import ActuatorReport
from cocorosim_ros.scenario.parts.platform import Platform, load_platform

Floats = NDArray[np.float64]
SPAN, RATE = 240.0, 10.0  # s, Hz


@pytest.fixture(scope="module")
def ferry() -> Platform:
    """Four thrusters, each turned about the vertical by half a turn at most."""
    return load_platform("milliampere_ferry")


def steps(rng: np.random.Generator, least: float, most: float, hold: float = 4.0) -> tuple[Floats, Floats]:
    """Times and values of commands that hold for `hold` seconds and a little more."""
    count = int(SPAN / hold)
    return np.arange(count) * hold + rng.uniform(0.0, 0.5, count), rng.uniform(least, most, count)


def integrated(time: Floats, command: Floats, moments: Floats, delay: float, lag: float, rate: float) -> Floats:
    """x' = (u(t - delay) - x)/lag, no faster than rate, by Euler steps of 1 ms: a calculation of its own."""
    fine = np.arange(0.0, SPAN, 1e-3)
    held = command[np.clip(np.searchsorted(time, fine - delay, side="right") - 1, 0, None)]
    value, course = held[0], np.empty(len(fine))
    for place, asked in enumerate(held.tolist()):
        course[place] = value
        value += 1e-3 * min(max((asked - value) / lag, -rate), rate)
    return np.interp(moments, fine, course)


def test_a_step_has_the_closed_form() -> None:
    """1 - exp(-(t - delay)/lag) behind the dead time, nothing before."""
    moments = np.linspace(0.0, 10.0, 201)
    shown = response(moments, np.array([0.0, 2.0]), np.array([0.0, 3.0]), np.array([0.5, 0.8, np.inf]))
    expected = np.where(moments > 2.5, 3.0 * -np.expm1(-(moments - 2.5) / 0.8), 0.0)
    np.testing.assert_allclose(shown, expected, atol=1e-14)


def test_a_limited_step_is_a_line_and_then_an_exponential() -> None:
    """With 1/s at most and a lag of 0.5 s: straight to 0.5 below the target, which takes 2.5 s, then exponential."""
    moments = np.linspace(0.0, 8.0, 161)
    shown = response(moments, np.array([0.0, 1.0]), np.array([0.0, -3.0]), np.array([0.0, 0.5, 1.0]))
    after = moments - 1.0
    expected = np.where(after < 2.5, -np.clip(after, 0.0, None), -3.0 + 0.5 * np.exp(-(after - 2.5) / 0.5))
    np.testing.assert_allclose(shown, expected, atol=1e-14)


def test_the_response_is_that_of_an_integration() -> None:
    """Many steps, before earlier ones are over, against Euler steps of a millisecond."""
    rng = np.random.default_rng(3)
    time, command = steps(rng, -1.0, 1.0, hold=1.0)
    moments = np.sort(rng.uniform(0.0, SPAN, 500))
    lateness = 0.33, 0.7, 0.4
    expected = integrated(time, command, moments, *lateness)
    np.testing.assert_allclose(response(moments, time, command, np.array(lateness)), expected, atol=2e-3)


def told(platform: Platform, commands: tuple[Floats, Floats], feedback: Feedback, *, parts: int = 1) -> ActuatorReport:
    """What is told of one report; the log may be given as several recordings."""
    time, command = commands
    table = np.zeros((len(time), len(platform.actuators)))
    table[:, platform.actuator_names.index(feedback.actuator)] = command
    logs = []
    for part in range(parts):
        low, high = SPAN * part / parts, SPAN * (part + 1) / parts
        mine, own = (time >= low) & (time < high), (feedback.time >= low) & (feedback.time < high)
        cut = replace(feedback, time=feedback.time[own], value=feedback.value[own])
        log = RobotLog("ferry", time[mine], table[mine], {}, feedback=(cut,))
        logs.append(RecordingLog(f"part_{part}", SPAN / parts, (log,)))
    (report,) = actuator_reports(Evidence(platform, tuple(logs)))
    return report


def moments_of(rng: np.random.Generator) -> Floats:
    """Uneven stamps of reports."""
    return np.sort(np.arange(0.0, SPAN, 1.0 / RATE) + rng.uniform(0.0, 0.02, int(SPAN * RATE)))


def coloured(rng: np.random.Generator, count: int, size: float, memory: float) -> Floats:
    """Noise of that standard deviation that hangs together over so many samples."""
    kept = math.exp(-1.0 / memory)
    return np.asarray(lfilter([size * math.sqrt(1 - kept**2)], [1.0, -kept], rng.standard_normal(count)))


def rotation(rng: np.random.Generator, platform: Platform, noise: float) -> ActuatorReport:
    """A motor with gain 90 rad/s at full command, dead time 0.4 s and lag 0.3 s, in coloured noise [rad/s]."""
    commands = steps(rng, -0.8, 0.8)
    moments = moments_of(rng)
    shown = 2.0 + 90.0 * response(moments, *commands, np.array([0.4, 0.3, np.inf]))
    return told(
        platform, commands, Feedback("bow_port", "rotation", moments, shown + coloured(rng, len(moments), noise, 10.0))
    )


def test_gain_dead_time_and_lag_without_noise(ferry: Platform) -> None:
    """All three to the accuracy of the search; no offset passes for a gain."""
    report = rotation(np.random.default_rng(1), ferry, 0.0)
    found = {name: estimate.value for name, estimate in report.numbers.items()}
    assert found == pytest.approx({"gain": 90.0, "delay": 0.4, "time_constant": 0.3, "lateness": 0.7}, rel=2e-3)
    assert report.numbers["gain"].unit == "rad/s"
    assert "rate_limit" not in report.numbers and not report.of_amount


def test_intervals_hold_the_truth_in_coloured_noise(ferry: Platform) -> None:
    """Of twenty recordings with noise that hangs together over a second, 95 % intervals miss in few.

    Four or more misses of twenty have a probability of 1.6 % each at 95 %.
    """
    truth = {"gain": 90.0, "delay": 0.4, "time_constant": 0.3, "lateness": 0.7}
    reports = [rotation(np.random.default_rng(100 + seed), ferry, 6.0) for seed in range(20)]
    for name, value in truth.items():
        missed = sum(not report.numbers[name].holds(value) for report in reports)
        assert missed <= 3, name
    widths = [report.numbers["lateness"].high - report.numbers["lateness"].low for report in reports]
    assert 0.005 < np.median(widths) < 0.15


def test_several_recordings_are_told_together(ferry: Platform) -> None:
    """Each has a start of its own; all have one dead time."""
    rng = np.random.default_rng(5)
    commands, moments = steps(rng, -0.8, 0.8), moments_of(rng)
    shown = 50.0 * response(moments, *commands, np.array([0.6, 0.2, np.inf]))
    report = told(ferry, commands, Feedback("bow_port", "rotation", moments, shown), parts=3)
    assert report.numbers["lateness"].value == pytest.approx(0.8, abs=0.01)


def test_a_limited_angle_in_degrees_over_the_seam(ferry: Platform) -> None:
    """A servo of 40 deg/s that turns over 180 deg: its limit and dead time, whatever turn its angle is reported in."""
    rng = np.random.default_rng(2)
    time, asked = steps(rng, 2.4, 3.9, hold=6.0)  # rad, about half a turn
    moments = moments_of(rng)
    limit = math.radians(40.0)
    shown = response(moments, time, asked, np.array([0.5, 0.1, limit])) + 0.005 * rng.standard_normal(len(moments))
    wrapped = (asked + math.pi) % (2 * math.pi) - math.pi
    feedback = Feedback("bow_port_angle", "angle", moments, shown % (2 * math.pi))
    report = told(ferry, (time, wrapped / math.pi), feedback)
    assert report.numbers["gain"].value == pytest.approx(1.0, abs=0.02)
    assert report.numbers["delay"].value == pytest.approx(0.5, abs=0.03)
    assert report.numbers["rate_limit"].value == pytest.approx(limit, rel=0.03)
    assert report.numbers["rate_limit"].unit == "rad/s"


def test_an_angle_that_only_lags_has_no_limit(ferry: Platform) -> None:
    """As a share of the largest angle, by a lag of half a second: no rate limit is made up."""
    rng = np.random.default_rng(4)
    commands, moments = steps(rng, -0.3, 0.3), moments_of(rng)
    shown = 0.9 * response(moments, *commands, np.array([0.1, 0.5, np.inf])) + 0.002 * rng.standard_normal(len(moments))
    report = told(ferry, commands, Feedback("bow_port_angle", "fraction", moments, shown))
    assert "rate_limit" not in report.numbers
    assert report.numbers["gain"].holds(0.9) and not report.numbers["gain"].holds(1.0)


@pytest.mark.parametrize(("largest", "unit"), [(1.0, "1"), (None, "rad")])
def test_the_gain_of_an_angle_has_no_unit_where_its_largest_is_known(
    ferry: Platform, largest: float | None, unit: str
) -> None:
    """A servo of 1 rad at most comes to what is commanded; a thruster that reports an angle has no largest one."""
    rng = np.random.default_rng(10)
    commands, moments = steps(rng, -0.5, 0.5), moments_of(rng)
    shown = response(moments, *commands, np.array([0.2, 0.3, np.inf]))
    azimuth = replace(ferry.actuators[1], largest_angle=largest or math.pi)
    platform = replace(ferry, actuators=(ferry.actuators[0], azimuth, *ferry.actuators[2:]))
    name = "bow_port_angle" if largest else "bow_port"
    report = told(platform, commands, Feedback(name, "angle", moments, shown))
    assert report.numbers["gain"].unit == unit
    assert report.numbers["gain"].value == pytest.approx(1.0, rel=1e-2)


def test_a_current_follows_the_amount(ferry: Platform) -> None:
    """Of motors that run both ways the current has one sign."""
    rng = np.random.default_rng(6)
    commands, moments = steps(rng, -0.8, 0.8), moments_of(rng)
    late = np.array([0.2, 0.3, np.inf])
    shown = 1.0 + 20.0 * response(moments, commands[0], np.abs(commands[1]), late)
    report = told(ferry, commands, Feedback("bow_port", "current", moments, shown))
    assert report.of_amount
    assert report.numbers["gain"].value == pytest.approx(20.0, rel=1e-2)
    assert report.numbers["lateness"].value == pytest.approx(0.5, abs=0.01)


def test_a_lost_line_does_not_spoil_it(ferry: Platform) -> None:
    """A second of -1091 rpm in minutes of sound reports is a fault of the instrument."""
    rng = np.random.default_rng(7)
    commands, moments = steps(rng, 0.3, 0.5), moments_of(rng)
    shown = 100.0 * response(moments, *commands, np.array([0.4, 0.3, np.inf])) + 0.2 * rng.standard_normal(len(moments))
    shown[1000:1010] = -114.0
    report = told(ferry, commands, Feedback("bow_port", "rotation", moments, shown))
    assert report.numbers["gain"].value == pytest.approx(100.0, rel=0.02)
    assert report.numbers["lateness"].value == pytest.approx(0.7, abs=0.05)


@pytest.mark.parametrize(
    ("change", "because"),
    [
        ("constant", "its command hardly changes"),
        ("once", "its command changes too seldom to tell by when it follows"),
        ("stuck", "what it reports never changes, though its command does"),
        ("noise", "it does not follow its command, which explains"),
        ("few", r"it has \d+ reports beside its commands, and 50 are needed"),
        ("late", "it follows by more than a dead time of 5 s"),
    ],
)
def test_what_does_not_tell_says_so(ferry: Platform, change: str, because: str) -> None:
    """Without enough excitation, or without a following, there is no number and a clause that says why."""
    rng = np.random.default_rng(8)
    (time, command), moments = steps(rng, -0.8, 0.8), moments_of(rng)
    if change == "constant":
        command = np.full_like(command, 0.4)
    if change == "once":
        command = np.where(time < 0.5 * SPAN, 0.2, 0.6)
    if change == "few":
        moments = moments[:: int(10 * RATE)]
    late = np.array([8.0 if change == "late" else 0.4, 0.3, np.inf])
    shown = 90.0 * response(moments, time, command, late) + 0.1 * rng.standard_normal(len(moments))
    if change == "stuck":
        shown = np.zeros(len(moments))
    if change == "noise":
        shown = rng.standard_normal(len(moments))
    report = told(ferry, (time, command), Feedback("bow_port", "rotation", moments, shown))
    assert not report.numbers
    assert re.match(because, report.because)


def test_nothing_is_told_where_nothing_is_reported(ferry: Platform) -> None:
    """Recordings without reports have none."""
    log = RobotLog("ferry", np.zeros(1), np.zeros((1, 8)), {})
    assert actuator_reports(Evidence(ferry, (RecordingLog("x", 1.0, (log,)),))) == ()
