"""Vanilla, BLC and NA against sums done by hand; what they share with BLT is tested there."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.controllers.request import DIVE, HEADING, SPEED

LEFT, RIGHT, BACK, UP, DOWN = range(5)
Make = Callable[..., Any]


def changed(lily: SimpleNamespace, **settings: float) -> list[float]:
    """The boids' settings of the paper with some replaced."""
    from cocorosim_ros.world.controllers.boids_rules import SETTINGS

    return [settings.get(name, value) for name, value in zip(SETTINGS, lily.boids, strict=True)]


def test_vanilla_cohesion_goes_to_the_median_place(decide_once: Make, lily: SimpleNamespace) -> None:
    """x of 0.2, 0.3, 0.4, y of 0.1, 0.2, -0.2, z of 0.05, 0.1, 0.2: median (0.3, 0.1, 0.1), not the mean."""
    places = [(0.2, 0.1, 0.05), (0.3, 0.2, 0.1), (0.4, -0.2, 0.2)]
    request = decide_once("boids_vanilla", changed(lily, cohesion_length=1.0), places=places)
    assert request[HEADING] == pytest.approx(math.atan2(0.1, 0.3))
    assert request[SPEED] == pytest.approx(math.hypot(0.3, 0.1) / 12.0)
    assert request[DIVE] == pytest.approx(0.1 * 0.1 / 12.0)


def test_vanilla_of_an_even_number_takes_the_middle_of_two(decide_once: Make, lily: SimpleNamespace) -> None:
    """Two at (0.2, 0.1) and (0.4, -0.3): (0.3, -0.1)."""
    request = decide_once("boids_vanilla", changed(lily), places=[(0.2, 0.1, 0.0), (0.4, -0.3, 0.0)], compass=1.0)
    assert request[HEADING] == pytest.approx(1.0 + math.atan2(-0.1, 0.3))


def test_vanilla_separation_pushes_from_each_that_is_near(decide_once: Make, lily: SimpleNamespace) -> None:
    """0.05 m ahead and 0.1 m left, no cohesion: (0.15-0.05) back and (0.15-0.1) right, over 11."""
    places = [(0.05, 0.0, 0.0), (0.0, 0.1, 0.0)]
    settings = changed(lily, cohesion_weight=0.0, cohesion_length=1.0)
    request = decide_once("boids_vanilla", settings, places=places)
    assert request[HEADING] == pytest.approx(math.atan2(-0.05, -0.1))
    assert request[SPEED] == pytest.approx(math.hypot(0.1, 0.05) / 11.0)


def test_vanilla_at_the_same_place_nobody_is_pushed(decide_once: Make, lily: SimpleNamespace) -> None:
    """Two robots in one place have no direction away from each other: the request stays finite."""
    request = decide_once("boids_vanilla", changed(lily), places=[(0.0, 0.0, 0.0)])
    assert np.isfinite(request[[SPEED, DIVE]]).all()


def test_vanilla_alignment_by_true_velocities(decide_once: Make, lily: SimpleNamespace) -> None:
    """Without cohesion: the median of (0.01, 0.02), (0.03, 0), (0.05, 0.05) is (0.03, 0.02), times 10/11."""
    settings = changed(lily, cohesion_weight=0.0, alignment_length=1.0)
    request = decide_once(
        "boids_vanilla",
        settings,
        places=[(0.2, 0, 0), (0.3, 0, 0), (0.4, 0, 0)],
        velocities=[(0.01, 0.02, 0), (0.03, 0, 0), (0.05, 0.05, 0)],
        compass=0.4,
    )
    assert request[HEADING] == pytest.approx(math.atan2(0.02, 0.03))
    assert request[SPEED] == pytest.approx(10.0 * math.hypot(0.02, 0.03) / 11.0)


def test_vanilla_with_270_degrees_of_view(decide_once: Make, lily: SimpleNamespace) -> None:
    """With observe_backwards off, 136 degrees off the bow is not seen, 134 degrees is."""
    for angle, speed in ((136.0, 0.08), (134.0, 0.3 / 12.0)):
        azimuth = math.radians(angle)
        place = (0.3 * math.cos(azimuth), 0.3 * math.sin(azimuth), 0.0)
        settings = changed(lily, observe_backwards=0.0, cohesion_length=1.0)
        assert decide_once("boids_vanilla", settings, places=[place])[SPEED] == pytest.approx(speed)


def test_vanilla_does_not_listen_nor_look(decide_once: Make, lily: SimpleNamespace) -> None:
    """Blue-light ranges and messages change nothing: it knows of nobody."""
    request = decide_once("boids_vanilla", lily.boids, ranges={LEFT: 0.2}, heard=[(0.05, 0, 0)], light=[(0.05, 0, 0)])
    assert request[SPEED] == 0.08


def test_blc_aligns_with_what_came_over_blue_light(decide_once: Make, lily: SimpleNamespace) -> None:
    """The radio says west, blue light (0.01, 0.02) and (0.03, 0): aligned with their median (0.02, 0.01)."""
    settings = changed(lily, alignment_length=1.0)
    request = decide_once("boids_blc", settings, heard=[(-0.05, 0, 0)], light=[(0.01, 0.02, 0), (0.03, 0.0, 0)])
    assert request[HEADING] == pytest.approx(math.atan2(0.01, 0.02))
    assert request[SPEED] == pytest.approx(10.0 * math.hypot(0.01, 0.02) / 12.0)


def test_blc_and_blt_agree_when_they_hear_the_same(decide_once: Make, lily: SimpleNamespace) -> None:
    """The same velocities by either medium give the same request to the last bit."""
    said = [(0.01, 0.02, 0.003), (0.03, -0.01, 0.0)]
    by_light = decide_once("boids_blc", lily.boids, ranges={LEFT: 0.3, UP: 0.1}, light=said)
    by_radio = decide_once("boids_blt", lily.boids, ranges={LEFT: 0.3, UP: 0.1}, heard=said)
    assert np.array_equal(by_light, by_radio)


@pytest.mark.parametrize(("keep", "divisor"), [(1.0, 12.0), (0.0, 2.0)])
def test_na_keeps_or_drops_the_weight_of_alignment(
    decide_once: Make, lily: SimpleNamespace, keep: float, divisor: float
) -> None:
    """Front left at 0.18 m in metres: 0.18/12 of the thrust with the divisor, 0.18/2 without."""
    settings = [*changed(lily, cohesion_length=1.0), keep]
    request = decide_once("boids_na", settings, ranges={LEFT: 0.18}, heard=[(0.07, 0, 0)], light=[(0.07, 0, 0)])
    assert request[HEADING] == pytest.approx(math.radians(60.0))
    assert request[SPEED] == pytest.approx(0.18 / divisor)


def test_na_alone_though_it_could_hear(decide_once: Make, lily: SimpleNamespace) -> None:
    """Nobody seen: 8 %, whatever the radio brings."""
    assert decide_once("boids_na", [*lily.boids, 1.0], heard=[(0.07, 0, 0)])[SPEED] == 0.08
