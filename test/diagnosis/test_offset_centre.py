"""A boat whose centre of mass is a tenth of its length ahead: named with its number, or a number of its base.

The boat is SciPy's (made/boats.py), its law written about the centre of mass, not about the origin as the model's.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from boats import KNOWN, Truth, platform, recorded

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.streams.log import Stream
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.diagnosis.tracks.vehicle_size import sizes
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import config_names
from cocorosim_ros.scenario.reading.quantity import Quantity
from cocorosim_ros.world.effects.offset_centre import OFFSET_CENTRE
from cocorosim_ros.world.terms.search import Strength
from cocorosim_ros.world.vehicle_model.platform_effects import check_platform

AHEAD, SECONDS, SEED = 0.1, 150.0, 5
COMPASS_NOISE = 0.02  # rad
SWELL = 0.3  # N, at random: 0.015 of a thruster's full force
RANGED = """  offset_centre:
    ahead: {value: 0, unit: m, range: [-0.3, 0.3], source: made}
    left: {value: 0, unit: m, source: made}
"""


def diagnosed(evidence: Any) -> Any:
    """The diagnosis, without a word."""
    return diagnose(evidence, lambda words, share: None)


def test_it_is_named_with_its_number(tmp_path: Path) -> None:
    """It alone: 0.1 m ahead and nothing to the side, each in its 95 % interval, that of the first within 10 %."""
    found = diagnosed(recorded(platform(tmp_path, KNOWN), Truth(ahead=AHEAD, choppy=SWELL), SECONDS, SEED))
    assert [each.id for each in found.effects] == ["offset_centre"]
    ahead, left = (found.effects[0].parameters[name] for name in ("ahead", "left"))
    assert ahead.holds(AHEAD) and ahead.high - ahead.low < 0.1 * AHEAD, ahead
    assert left.holds(0.0) and left.high - left.low < 0.1 * AHEAD, left


def test_a_declared_one_is_a_number_of_the_base(tmp_path: Path) -> None:
    """Given with a range, it is fitted before anything is missing, and nothing is."""
    known = platform(tmp_path, KNOWN + RANGED)
    found = diagnosed(recorded(known, Truth(ahead=AHEAD, choppy=SWELL), SECONDS, SEED))
    assert found.effects == ()
    (ahead,) = [each for each in found.all_recalibrated if each.parameter == "offset_centre.ahead"]
    assert ahead.estimate.holds(AHEAD) and ahead.estimate.high - ahead.estimate.low < 0.1 * AHEAD


@pytest.mark.parametrize(
    ("lever", "with_compass", "named"), [(0.0, False, []), (0.1, False, []), (0.1, True, ["pose_lever"])]
)
def test_a_boat_without_one_is_not_said_to_have_it(
    tmp_path: Path, lever: float, with_compass: bool, named: list[str]
) -> None:
    """As its file says nothing is named; a marker 0.1 m ahead of the origin is, alone, where there is a compass."""
    evidence = recorded(platform(tmp_path, KNOWN), Truth(choppy=SWELL), SECONDS, SEED)
    found = diagnosed(_marked(evidence, lever, with_compass=with_compass))
    assert [each.id for each in found.effects] == named


@pytest.mark.parametrize("name", config_names("platforms"))
def test_what_is_looked_for_can_be_read_back(name: str) -> None:
    """A ship is far narrower than half its length, up to which both numbers are looked for."""
    vehicle = load_platform(name)
    assert len(OFFSET_CENTRE.parameters) == 2
    for number in OFFSET_CENTRE.parameters:
        assert isinstance(number.search, Strength)
        end = number.search.most * number.search.large * sizes(vehicle_model(vehicle))["m"]
        assert end == pytest.approx(0.5 * vehicle.hull.length)
        for offset in (-end, end):
            there = {"offset_centre": {number.name: Quantity(offset, "m", "length")}}
            check_platform(replace(vehicle, effect_quantities=there))


def _marked(evidence: Any, lever: float, *, with_compass: bool) -> Any:
    """The evidence of a marker that sits so far ahead of the origin [m], and perhaps of a compass."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    value = pose.value.copy()
    value[:, 0] += lever * np.cos(value[:, 3])
    value[:, 1] += lever * np.sin(value[:, 3])
    streams = {"pose": replace(pose, value=value)}
    if with_compass:
        noise = COMPASS_NOISE * np.random.default_rng([20261127, 5]).standard_normal((len(value), 1))
        streams["compass"] = Stream(pose.time, value[:, 3:] + noise, np.array([COMPASS_NOISE]))
    robots = (replace(log, streams=streams),)
    return replace(evidence, recordings=(replace(recording, robots=robots),))
