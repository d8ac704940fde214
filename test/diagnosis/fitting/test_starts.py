"""Starts of fits where the likelihood is flat but near the truth: a scale by exact readings, a dead band."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.candidate import expand
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit, first_fit
from cocorosim_ros.diagnosis.fitting.screening import Screen, further_starts
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.fitting.starts import best_start
from cocorosim_ros.diagnosis.naming import contest
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.effects.thruster_deadband import WIDTHS

EXACT = 0.05  # of the usual noise: a tenth of a millimetre


def with_lengths(evidence: Evidence, scale: float) -> Evidence:
    """The same recordings, of which the camera shows all lengths wrong by a factor."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    pose = replace(pose, value=pose.value * np.array([scale, scale, scale, 1.0]))
    robots = (replace(log, streams={**log.streams, "pose": pose}),)
    return replace(evidence, recordings=(replace(recording, robots=robots),))


@pytest.fixture(scope="module", params=[0.88, 1.12])
def wrong(request: pytest.FixtureRequest, swim: Callable[..., Any]) -> tuple[float, Fit]:
    """The scale of a camera, and the fit of the sound vehicle, with its noise, to what that camera shows."""
    sound = swim(load_platform("lily"), 60.0, 5, blur=EXACT)
    fit = base_fit(sound)
    tracks = first_fit(with_lengths(sound, request.param)).tracks
    return request.param, evaluated(replace(fit, tracks=tracks))


def begun(fit: Fit) -> float:
    """The scale that the fit of a candidate ends at, as it is begun in the contest."""
    entry = next(each for each in ENTRIES if each.id == "camera_scale")
    (candidate,) = expand([entry], fit.tracks, fit.rows)
    scene = scene_of(fit.tracks, smoothed_tracks(fit), drag_form_of(fit))
    found = contest.begin(fit, Screen(fit, scene).test(candidate), scene).fit
    return found.unknowns[-1].value(float(found.q[-1]))


def test_a_wrong_scale_is_found_by_exact_readings(wrong: tuple[float, Fit]) -> None:
    """Its readings lie hundreds of standard deviations off, so that most of them have no slope."""
    scale, fit = wrong
    assert np.mean(~fit.passes[0].believed) > 0.1
    assert begun(fit) == pytest.approx(scale, abs=0.003)


STAIRS = 0.025  # of q, from one command of a vehicle to the next larger one: a four-hundredth of the largest
SUMMIT = 10  # stairs below the dead band


def staircase(q: Any) -> Any:
    """A fit whose objective is level between one command and the next, and falls by 800 nats for each one passed."""
    stairs = np.floor(float(q[0]) / STAIRS + 1e-9)
    rough = 1e-3 * np.sin(300.0 * float(q[0]))
    return SimpleNamespace(q=q, objective=max(-800.0 * abs(stairs - SUMMIT), -3000.0) + rough)


def test_the_search_of_a_dead_band_ends_between_the_right_commands() -> None:
    """Though the likelihood is level around its slope at zero, where the fit would begin, and on every stair."""
    candidate: Any = SimpleNamespace(searched=lambda: [np.array([width]) for width in WIDTHS])
    found = best_start(staircase, np.array([0.02]), candidate)
    assert SUMMIT * STAIRS <= found.q[0] < (SUMMIT + 1) * STAIRS


def test_a_dead_band_is_searched_although_it_has_a_shape(wrong: tuple[float, Fit]) -> None:
    """Its shape, a jump or a ramp, is looked for on a grid alone; one whose place is fitted has no search."""
    _, fit = wrong
    scene = scene_of(fit.tracks, smoothed_tracks(fit), drag_form_of(fit))
    screen, entries = Screen(fit, scene), {each.id: each for each in ENTRIES}
    candidates = [expand([entries[name]], fit.tracks, fit.rows)[0] for name in ("thruster_deadband", "tether")]
    starts = [further_starts(screen.test(each)) for each in candidates]
    assert [float(start[0]) for start in starts[0]] == list(WIDTHS)
    assert starts[1] == []
