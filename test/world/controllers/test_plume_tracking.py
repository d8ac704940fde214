"""Plume tracking: surge, cast, stop; and the source is reached."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from cocorosim_ros.world.controllers.request import DIVE, HEADING, SPEED

# threshold, arrival, upstream, leg, speed, depth, gain
SETTINGS = (1e-6, 1e-3, 2.0, 20.0, 0.3, 1.2, 3.0)
Make = Callable[..., Any]


def test_it_surges_in_the_smell(decide_once: Make) -> None:
    """At the threshold and above: upstream, with the speed and depth of the settings."""
    for smell in (1e-6, 5e-4):
        request = decide_once("plume_tracking", SETTINGS, concentration=smell, time=3.0, compass=-1.0)
        assert (request[HEADING], request[SPEED], request[DIVE]) == (2.0, 0.3, 1.2)


def test_it_stops_at_the_source(decide_once: Make) -> None:
    """From the concentration of arrival on it swims no more, and on when it is carried away."""
    request = decide_once("plume_tracking", SETTINGS, concentration=1e-3, time=3.0)
    assert request[SPEED] == 0.0
    assert decide_once("plume_tracking", SETTINGS, request, concentration=9e-4, time=3.5)[SPEED] == 0.3


@pytest.mark.parametrize("smell", [0.0, 9.9e-7, math.nan])
def test_it_casts_in_growing_legs(decide_once: Make, smell: float) -> None:
    """Lost at 5 s: left until 25 s, right until 65 s, left until 125 s; found again it starts anew."""
    left, right = 2.0 + 0.5 * math.pi - 2.0 * math.pi, 2.0 - 0.5 * math.pi
    request = None
    for time, heading in ((5.0, left), (24.5, left), (25.0, right), (64.5, right), (65.0, left), (124.5, left)):
        request = decide_once("plume_tracking", SETTINGS, request, concentration=smell, time=time)
        assert request[HEADING] == pytest.approx(heading, abs=1e-12)
    request = decide_once("plume_tracking", SETTINGS, request, concentration=1e-4, time=125.0)
    assert decide_once("plume_tracking", SETTINGS, request, concentration=0.0, time=125.5)[HEADING] == (
        pytest.approx(left, abs=1e-12)
    )


def test_the_source_is_reached(nearest_to_the_leak: Callable[..., Any]) -> None:
    """From at least 19 of 20 places and headings up to 9 m downstream and 2 m aside, within ten minutes to 0.4 m."""
    assert (nearest_to_the_leak() < 0.4).sum() >= 19
