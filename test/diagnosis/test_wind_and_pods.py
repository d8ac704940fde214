"""Made boats in the wind, and with a thruster that turns and stands askew: named with their numbers, else silence.

The courses are SciPy's, of formulas written out in made/boats.py.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import boats

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.scenario.parts.platform import Platform

SECONDS, SEED = 160.0, 1
CHOPPY = 0.3  # N, at random; without it intervals are so narrow that the steps of the filter show, 0.3 % of the wind
DRAG = boats.KNOWN.replace(boats.KNOWN[boats.KNOWN.index("  thruster_lag") :], "")  # known, thrusters follow at once


def effects_of(platform: Platform, truth: boats.Truth, forces: boats.Forces = boats.pair) -> dict[str, Any]:
    """Numbers of what is named of one drive, by effect."""
    evidence = boats.recorded(platform, truth, SECONDS, SEED, forces=forces)
    found = diagnose(evidence, lambda words, share: None)
    return {effect.id: effect.parameters for effect in found.effects}


def test_wind_is_named_with_its_velocity(tmp_path: Path) -> None:
    """It alone; both parts of 5 m/s lie in their intervals, which are narrower than they are."""
    windy = boats.platform(tmp_path, boats.KNOWN, boats.in_the_wind())
    found = effects_of(windy, boats.Truth(wind=(3.0, -4.0), choppy=CHOPPY))
    assert set(found) == {"wind"}
    for name, true in (("x", 3.0), ("y", -4.0)):
        estimate = found["wind"][name]
        assert estimate.holds(true) and estimate.high - estimate.low < abs(true), (name, estimate)


def test_calm_air_has_no_name(tmp_path: Path) -> None:
    """The same boat on the same drive, with all that stands above the water."""
    assert effects_of(boats.platform(tmp_path, boats.KNOWN, boats.in_the_wind()), boats.Truth(choppy=CHOPPY)) == {}


def test_a_pod_that_stands_askew_is_named_with_its_angle(tmp_path: Path) -> None:
    """It alone; the angle lies in its interval, which is no wider than four spreads of 6 %: those of other forms."""
    found = effects_of(boats.platform(tmp_path, DRAG, boats.with_pod()), boats.Truth(lag=0.0, askew=0.1), boats.pod)
    assert set(found) == {"thruster_misalignment"}
    estimate = found["thruster_misalignment"]["angle"]
    assert estimate.holds(0.1) and estimate.high - estimate.low < 0.025, estimate


def test_a_pod_that_stands_right_has_no_name(tmp_path: Path) -> None:
    """The same drive with a thruster that turns as it is told."""
    found = effects_of(boats.platform(tmp_path, DRAG, boats.with_pod()), boats.Truth(lag=0.0), boats.pod)
    assert found == {}
