"""Unknowns are selected by the effect, the robots and the parameter that they belong to, not by their place."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Owner, Unknown
from cocorosim_ros.world.terms.search import Scene

PERIODS = {name: (60.0, 400.0) for name in ("world_x", "world_y", "heave", "yaw", "surge", "sway", "waves", "current")}
SCENE = Scene((-1.0,) * 3, (1.0,) * 3, 600.0, 0.15, 0.0, PERIODS, (120.0,), {}, True)
ROBOTS, TRACKS = ("a", "b"), ((0, 2), (1,))


def entry_of(effect: str, topic: str | None = None) -> Any:
    """From the catalogue."""
    return next(entry for entry in ENTRIES if (entry.id, entry.topic) == (effect, topic))


def unknowns_of(candidate: Candidate) -> list[Unknown]:
    """All of a candidate, at the first point of its shapes."""
    values = next(iter(candidate.settings(SCENE)))
    return [*candidate.amplitudes(), *candidate.shape_unknowns(values, SCENE)]


def platform(robot: str) -> Unknown:
    """The drag of one robot."""
    return Unknown(Owner(PLATFORM, (robot,), "drag", "kg/m"), "drag", (0,), 1.8)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: f"{entry.id}-{entry.topic}")
def test_every_entry_owns_its_unknowns_and_no_others(entry: Any) -> None:
    """Between the platform's numbers and those of all other entries, in any order."""
    mine = unknowns_of(Candidate(entry, ROBOTS, TRACKS))
    others = [each for other in ENTRIES if other is not entry for each in unknowns_of(Candidate(other, ROBOTS, TRACKS))]
    everything = [platform("a"), *others[::2], *mine, platform("b"), *others[1::2]]
    shuffled = [everything[index] for index in np.random.default_rng(3).permutation(len(everything))]
    places = Candidate(entry, ROBOTS, TRACKS).places_among(shuffled)
    assert len(places) == len(mine)
    assert all(shuffled[place] in mine for place in places)


def test_what_is_each_robots_own_says_whose_it_is() -> None:
    """Linear drag has three numbers for each robot, in the catalogue's units, on that robot's tracks."""
    amplitudes = Candidate(entry_of("linear_drag"), ROBOTS, TRACKS).amplitudes()
    names = [amplitude.name for amplitude in entry_of("linear_drag").amplitudes]
    assert [each.owner.robots for each in amplitudes] == [("a",)] * len(names) + [("b",)] * len(names)
    assert [each.owner.parameter for each in amplitudes] == 2 * names
    assert {each.tracks for each in amplitudes} == {(0, 2), (1,)}


def test_what_is_of_the_water_is_shared() -> None:
    """One current for all."""
    amplitudes = Candidate(entry_of("steady_current"), ROBOTS, TRACKS).amplitudes()
    assert {each.owner.robots for each in amplitudes} == {ROBOTS}
    assert {each.tracks for each in amplitudes} == {(0, 2, 1)}


def test_the_same_effect_on_another_robot_is_another_candidate() -> None:
    """A lag of b alone, added after one of a alone: neither owns a number of the other."""
    entry = entry_of("thruster_lag")
    first, second = Candidate(entry, ("a",), ((0, 2),)), Candidate(entry, ("b",), ((1,),))
    unknowns = [platform("a"), *unknowns_of(first), *unknowns_of(second)]
    assert first.places_among(unknowns) == [1]
    assert second.places_among(unknowns) == [2]
    assert Candidate(entry, ROBOTS, TRACKS).places_among(unknowns) == [1, 2]


def test_the_same_error_of_another_stream_is_another_effect() -> None:
    """Poses and pressures that are late are told apart by their topic."""
    pose, pressure = (Candidate(entry_of("sensor_latency", topic), ("a",), ((0,),)) for topic in ("pose", "pressure"))
    unknowns = [*unknowns_of(pose), *unknowns_of(pressure)]
    assert (pose.places_among(unknowns), pressure.places_among(unknowns)) == ([0], [1])


def named(candidate: Candidate, nats: float) -> Any:
    """An effect with this evidence."""
    from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
    from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect

    return NamedEffect(candidate, nats, (), HeldOutGain(np.ones(10), 1e-3))


def fit_of(unknowns: list[Unknown], q: list[float]) -> Any:
    """A fit with these unknowns whose slopes never meet, each known to 0.1."""
    from cocorosim_ros.diagnosis.fitting.fit import Fit, Information
    from cocorosim_ros.diagnosis.tracks.columns import NEUTRAL

    fit = Fit((), np.array([NEUTRAL] * 3), tuple(unknowns), (), np.array(q), np.zeros(0), ())
    count = len(unknowns)
    fit.__dict__["information"] = Information((), 100.0 * np.eye(count), np.zeros(count), ())
    return fit


def test_estimates_find_their_numbers_wherever_they_stand() -> None:
    """Two effects and a platform's number, interleaved: every parameter has the value that was put in."""
    from cocorosim_ros.diagnosis.showing.estimates import fitted, found_effects, recalibrated

    lag = Candidate(entry_of("thruster_lag"), ROBOTS, TRACKS)
    tide = Candidate(entry_of("tidal_current"), ROBOTS, TRACKS)
    lags, tides = unknowns_of(lag), unknowns_of(tide)
    scattered = [tides[0], lags[1], platform("a"), *tides[1:], lags[0]]
    fit = fit_of(scattered, [0.1 * (index + 1) for index in range(len(scattered))])
    value = {id(unknown): unknown.value(float(q)) for unknown, q in zip(scattered, fit.q, strict=True)}
    first, *others = found_effects(fit, [named(lag, 20.0), named(tide, 90.0)], fitted(fit))
    assert (first.id, first.robots) == ("tidal_current", ROBOTS)
    assert {name: each.value for name, each in first.parameters.items()} == pytest.approx(
        {unknown.owner.parameter: value[id(unknown)] for unknown in tides}
    )
    assert [(each.id, each.robots) for each in others] == [("thruster_lag", ("a",)), ("thruster_lag", ("b",))]
    assert [next(iter(each.parameters.values())).value for each in others] == [value[id(lag)] for lag in lags]
    (drag,), _ = recalibrated(fitted(fit))
    assert (drag.parameter, drag.robots, drag.estimate.unit) == ("drag", ("a",), "kg/m")
    assert drag.estimate.value == value[id(scattered[2])]


def test_a_tiny_amplitude_is_seen_wherever_it_stands() -> None:
    """All amplitudes of the candidate at nothing, all other numbers far off: tiny; one of its own far off: not."""
    from cocorosim_ros.diagnosis.naming.contest import Refined
    from cocorosim_ros.diagnosis.naming.needed_evidence import is_tiny

    drag = Candidate(entry_of("linear_drag"), ("a",), ((0,),), duration=600.0)
    other = Candidate(entry_of("thruster_lag"), ("a",), ((0,),), duration=600.0)
    amplitudes = drag.amplitudes()
    unknowns = [*other.amplitudes(), *amplitudes, platform("a")]
    q = [1.0, *[0.0] * len(amplitudes), 1.0]
    assert is_tiny(Refined(drag, fit_of(unknowns, q), 50.0))
    q[2] = 1.0
    assert not is_tiny(Refined(drag, fit_of(unknowns, q), 50.0))


def test_a_noise_names_its_robots_and_the_unit_under_the_logarithm(swim: Any) -> None:
    """Of one robot: the random forces, their time and smoothness, and one number for each kind of reading."""
    from cocorosim_ros.diagnosis.fitting.base_model import base_rows, noise_unknowns
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
    from cocorosim_ros.scenario.parts.platform import load_platform

    tracks = make_tracks(swim(load_platform("lily"), 20.0))
    found = {each.column: each.owner for each in noise_unknowns(tracks, base_rows(tracks))}
    assert {owner.robots for owner in found.values()} == {("lily_01",)}
    assert {column: owner.unit for column, owner in found.items()} == {
        "random.force": "N", "random.heave_force": "N", "random.moment": "N m", "random.correlation": "s",
        "random.smoothness": "1", "reading.pose_xy": "m", "reading.pose_z": "m", "reading.pose_yaw": "rad",
        "reading.compass": "rad", "reading.pressure": "Pa", "reading.gyro_z": "rad/s",
    }  # fmt: skip
    assert all(column == f"{owner.effect}.{owner.parameter}" for column, owner in found.items())


def test_a_step_that_would_leave_the_bounds_goes_back() -> None:
    """At the upper bound of q slopes are taken from below."""
    unknown = replace(platform("a"), bounds=(-1.0, 1.0), step=0.05)
    assert (unknown.inward_step(1.0), unknown.inward_step(0.9)) == (-0.05, 0.05)


@pytest.mark.parametrize(("period", "duration"), [(60.0, 100.0), (60.0, 3000.0)])
def test_a_slope_by_a_period_hardly_moves_the_phase_at_the_end(period: float, duration: float) -> None:
    """By a tenth of a radian: a step of a tenth of the grid's spacing would be whole swings off after an hour."""
    candidate = replace(Candidate(entry_of("tidal_current"), ROBOTS, TRACKS), duration=duration)
    values = {"tidal_current.period": period, "tidal_current.phase": 0.0}
    (swing,) = (each for each in candidate.shape_unknowns(values, SCENE) if each.owner.parameter == "period")
    phases = [2.0 * np.pi * duration / swing.value(q) for q in (0.0, swing.step)]
    assert abs(phases[1] - phases[0]) == pytest.approx(0.1, rel=0.02)
