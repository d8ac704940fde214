"""Sizes from which differences would be named, by closed forms."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.against.out_of_sight import numbers_not_shown, sizes_seen
from cocorosim_ros.diagnosis.criteria.naming import NAMING


def number(name: str, scale: float, bounds: tuple[float, float] = (-10.0, 10.0), *, logarithmic: bool = False) -> Any:
    """An unknown that has what a size is told by."""
    owner = SimpleNamespace(parameter=name)
    return SimpleNamespace(owner=owner, scale=scale, bounds=bounds, logarithmic=logarithmic)


def screened(name: str, numbers: list[Any], information: list[float], **more: Any) -> Any:
    """A screened entry, whose numbers are told apart."""
    entry = SimpleNamespace(id=name, topic=more.pop("topic", None), law=None)
    candidate = SimpleNamespace(entry=entry, spread=more.pop("spread", 1.0), amplitudes=lambda: numbers)
    return SimpleNamespace(candidate=candidate, information=np.diag(information), felt=more.pop("felt", math.nan))


def test_a_number_that_nothing_shows_is_said_beside_those_that_are_shown() -> None:
    """A compass whose distortion the gyroscope shows, and whose offset nothing does."""
    compass = screened("compass_distortion", [number("offset", 0.2), number("sin", 0.2)], [1e-6, 1e4])
    assert numbers_not_shown([compass]) == ("compass_distortion:offset",)
    assert list(sizes_seen([compass])["compass_distortion"]) == ["sin"]
    assert numbers_not_shown([screened("camera_scale", [number("scale", 0.1)], [1e-6])]) == ()


def test_a_size_has_just_the_evidence_that_a_name_needs() -> None:
    """Half of the information times its square, less the odds of so wide a prior: the threshold.

    That is of an estimate so far below the size that one in twenty lies below it.
    """
    size = sizes_seen([screened("pressure_offset", [number("offset", 500.0)], [900.0])])["pressure_offset"]["offset"]
    own = 900.0**2 / 901.0
    estimate = size / 500.0 - 1.6449 / math.sqrt(own)
    evidence = 0.5 * own * estimate**2 - 0.5 * math.log(901.0)
    assert evidence == pytest.approx(NAMING.threshold, rel=1e-4)


def test_where_the_prior_rules_sizes_are_beyond_belief() -> None:
    """A hundredth of the prior's information: the estimate is a hundredth of what is there."""
    weak, strong = (sizes_seen([screened("wind", [number("force", 1.0, (-1e9, 1e9))], [each])]) for each in (0.01, 1e4))
    known = (0.01**2 / 1.01, 1e8 / 10001.0)
    least = [math.sqrt(2.0 * NAMING.threshold + math.log1p(each)) + 1.6449 for each in (0.01, 1e4)]
    for found, own, each in zip((weak, strong), known, least, strict=True):
        assert found["wind"]["force"] == pytest.approx(each / math.sqrt(own), rel=1e-4)


def test_recordings_that_differ_among_themselves_hide_more() -> None:
    """Nine times the spread, and nearly three times the size where the odds weigh little."""
    one, nine = (
        sizes_seen([screened("wind", [number("force", 1.0)], [9e3], spread=each)])["wind"]["force"]
        for each in (1.0, 9.0)
    )
    assert 2.0 < nine / one < 3.0


def test_a_delay_goes_by_what_is_felt_of_it_and_by_its_stream() -> None:
    """Slopes promise four times the information that trying shows, so the size is nearly twice as large."""
    late = number("latency", 0.15)
    promised = screened("sensor_latency", [late], [4e3], topic="imu")
    felt = screened("sensor_latency", [late], [4e3], topic="pressure", felt=0.5 * 0.25 * 1e3)
    sizes = sizes_seen([promised, felt])
    assert 1.7 < sizes["sensor_latency:pressure"]["latency"] / sizes["sensor_latency:imu"]["latency"] < 2.0


def test_a_factor_is_told_as_a_share_and_within_its_bounds() -> None:
    """A share of the logarithm is so much more of the thrust; what would have to be beyond its bounds is never seen."""
    information = 1e3
    share = sizes_seen([screened("wind", [number("force", 1.0)], [information])])["wind"]["force"]
    seen = sizes_seen([screened("thruster_gain:left", [number("left", 0.3, logarithmic=True)], [information])])
    assert seen["thruster_gain:left"]["left"] == pytest.approx(math.exp(0.3 * share) - 1.0)
    bound = number("left", 0.3, (-0.1, 0.1), logarithmic=True)
    assert sizes_seen([screened("thruster_gain:left", [bound], [information])]) == {"thruster_gain:left": {}}


def test_a_model_that_runs_away_along_its_slopes_tells_no_size() -> None:
    """Information that is no number: nothing is seen at any size, and no warning comes of it."""
    away = screened("tether", [number("stiffness", 1.0), number("x", 1.0)], [math.nan, 1e4])
    assert sizes_seen([away]) == {"tether": {}}
    assert numbers_not_shown([away]) == ()
