"""Pressure in the sea: 1025 kg/m^3 weigh 10055 Pa per metre, and no sound sensor reads 2.5 % too much there."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.gather import gather_recording
from cocorosim_ros.diagnosis.filter.layout import PRESSURE
from cocorosim_ros.diagnosis.filter.reading import NO_MOTORS, Along, expected_along
from cocorosim_ros.diagnosis.tracks.columns import SENSORS
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

SEA, FRESH = 1025.0 * 9.81, 1000.0 * 9.81  # Pa/m
SECONDS, SEED = 100.0, 31


def in_the_sea() -> Platform:
    """A Lily whose file says that she swims in the sea, with ballast that lets her float in it as in fresh water."""
    lily = load_platform("lily")
    return replace(lily, water_density=1025.0, mass=1.025 * lily.mass)


def pressed(evidence: Any, change: Callable[[Any], Any], **marks: Any) -> Any:
    """Evidence of the same swim, in which the pressures above that of the surface are what `change` makes of them."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    stream = log.streams["pressure"]
    stream = replace(stream, value=101325.0 + change(stream.value - 101325.0), **marks)
    robots = (replace(log, streams={**log.streams, "pressure": stream}),)
    return replace(evidence, recordings=(replace(recording, robots=robots),))


def test_a_sound_sensor_in_the_sea_is_not_accused(swim: Any) -> None:
    """Poses show the depth beside it, so that a wrong weight of water would be told as a gain of 1.025."""
    found = diagnose(swim(in_the_sea(), SECONDS, SEED), lambda words, share: None)
    assert (found.verdict, found.effects) == ("consistent", ())


@pytest.mark.parametrize(("make", "gain"), [(in_the_sea, 1.05), (lambda: load_platform("lily"), 1.05)])
def test_a_wrong_gain_is_told_in_multiples_of_the_waters_own(swim_with_log: Any, make: Any, gain: float) -> None:
    """It alone; the truth lies in the 95 % interval, which is narrower than the error.

    A speed log says that the camera's lengths are right, which would else be as good a reason.
    """
    evidence = pressed(swim_with_log(make(), SECONDS, SEED), lambda above: gain * above)
    (found,) = diagnose(evidence, lambda words, share: None).effects
    assert (found.id, found.topic) == ("pressure_gain", "pressure")
    estimate = found.parameters["gain"]
    assert estimate.holds(gain) and estimate.high - estimate.low < gain - 1.0, estimate


def test_what_is_simulated_is_what_the_filter_expects(make_simulation: Any) -> None:
    """A metre and a half down in the sea both show 101325 Pa and 1.5 times 10055.25 Pa."""
    simulation = make_simulation([[[0.0, 0.0, -1.5, 0.0]]])
    simulation.world.instruments.water_density[:] = 1025.0
    shown, state = np.empty(1), np.zeros((1, 8))
    state[0, 2] = -1.5
    row = vehicle_model(in_the_sea()).row
    expected_along(PRESSURE, Along(np.zeros(1), state, np.zeros((1, 4))), NO_MOTORS, row[SENSORS], shown)
    assert simulation.sense().pressure[0, 0] == shown[0] == pytest.approx(101325.0 + 1.5 * SEA, rel=1e-12)


def test_depths_that_a_map_made_pressures_are_depths(swim: Any) -> None:
    """Made by the contract's formula they are read by it, in the sea too; without the mark by the sea's weight."""
    as_depth = pressed(swim(in_the_sea(), 10.0), lambda above: above / SEA * FRESH, from_depth=True)
    (track,) = make_tracks(as_depth)
    assert track.vehicle.water_weight == FRESH
    assert make_tracks(swim(in_the_sea(), 10.0))[0].vehicle.water_weight == SEA


@pytest.mark.parametrize(
    ("number", "made"), [("depth: {column: p, unit: m}", True), ("pressure: {column: p, unit: bar}", False)]
)
def test_a_converted_recording_says_what_its_pressures_were(tmp_path: Path, number: str, made: bool) -> None:
    """Depths leave their mark in the recording, pressures that a sensor measured none."""
    rows = "".join(f"{k},{1.0 + 0.01 * k}\n" for k in range(30))
    (tmp_path / "log.csv").write_text(f"t,p\n{rows}", "utf-8")
    (tmp_path / "map.yaml").write_text(
        'name: sea\nformat: csv\ntables:\n  - {files: "*.csv", robot: boat, time: {column: t, unit: s}, '
        f"streams: {{pressure: {{{number}}}}}}}\n",
        "utf-8",
    )
    (done,) = convert(load_map(tmp_path / "map.yaml"), tmp_path / "log.csv", tmp_path / "bag")
    assert json.loads(done.conversion.metadata.get("pressure_from_depth", "[]")) == ["boat"] * made
    (log,) = gather_recording(done.folder, in_the_sea()).robots
    assert log.streams["pressure"].from_depth == made
