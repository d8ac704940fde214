"""What metrics carry over from the tick before, or from one population to the other, changes no bit of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from cocorosim_ros.study.metrics import COLUMN, METRICS
from cocorosim_ros.study.metrics.kernel import measure_tick
from cocorosim_ros.study.metrics.memory import new_memory


def ticks_of(robots: int, ticks: int, spread: float, seed: int) -> tuple[Any, Any, Any]:
    """Places, headings and presence of robots that wander in a few shoals, and are absent now and then."""
    random = np.random.default_rng(seed)
    homes = random.choice([0.0, spread, 2.0 * spread], robots)[:, None] * np.array([1.0, 0.5, 0.0])
    place = homes + random.uniform(-0.3, 0.3, (ticks, robots, 3))
    return place, random.uniform(-3.0, 3.0, (ticks, robots)), random.random((ticks, robots)) < 0.9


def distances(places: Any, pairs: list[tuple[int, int]]) -> list[float]:
    """Of pairs [m]."""
    return [float(np.linalg.norm(places[i] - places[j])) for i, j in pairs]


def shoals_of(places: Any, there: list[int]) -> list[list[int]]:
    """Components of the graph of robots within 0.5 m, by joining as long as anything joins."""
    groups = [[robot] for robot in there]
    for i, j in ((i, j) for i in there for j in there if i < j):
        one, other = (next(group for group in groups if robot in group) for robot in (i, j))
        if one is not other and np.sum((places[i] - places[j]) ** 2) <= 0.25:
            groups.remove(other)
            one.extend(other)
    return groups


@given(robots=st.integers(2, 9), spread=st.sampled_from([0.0, 0.4, 0.8, 3.0]), seed=st.integers(0, 2**32))
@settings(max_examples=60, deadline=None)
def test_against_plain_definitions(robots: int, spread: float, seed: int) -> None:
    """Speeds of centres and separations within shoals, tick by tick, written as their definitions are."""
    places, yaw, present = ticks_of(robots, 6, spread, seed)
    memory, values = new_memory(1, robots), np.empty((1, len(METRICS)))
    before: list[int] = []
    for tick in range(6):
        elapsed = np.array([500_000_000 if tick else 0])
        measure_tick(places[tick][None], yaw[tick][None], present[tick][None], elapsed, memory, values)
        there = [robot for robot in range(robots) if present[tick, robot]]
        movers = [robot for robot in there if robot in before]
        speed, median_speed = np.nan, np.nan
        if movers and tick:
            now, then = places[tick][movers], places[tick - 1][movers]
            speed = np.linalg.norm(now.mean(axis=0) - then.mean(axis=0)) / 0.5
            median_speed = np.linalg.norm(np.median(now, axis=0) - np.median(then, axis=0)) / 0.5
        within = [(i, j) for group in shoals_of(places[tick], there) for i in group for j in group if i < j]
        expected = {
            "shoal_speed": speed,
            "shoal_speed_median_centre": median_speed,
            "separation_same_shoal": np.median(distances(places[tick], within)) if within else np.nan,
            "shoals": len(shoals_of(places[tick], there)) or np.nan,
        }
        for name, value in expected.items():
            np.testing.assert_allclose(values[0, COLUMN[name]], value, rtol=1e-12, atol=1e-12, err_msg=name)
        before = there


@given(robots=st.integers(2, 9), spread=st.sampled_from([0.0, 0.4, 3.0]), seed=st.integers(0, 2**32))
@settings(max_examples=60, deadline=None)
def test_the_largest_shoal_alone_has_the_values_of_the_largest(robots: int, spread: float, seed: int) -> None:
    """Without all other robots, what is said of all is to the last bit what was said of the largest shoal.

    Both moments are measured with and without the others, so that the tick before knows the same robots.
    """
    places, yaw, _ = ticks_of(robots, 2, spread, seed)
    groups = sorted(shoals_of(places[1], list(range(robots))), key=len)
    if len(groups[-1]) < 2 or (len(groups) > 1 and len(groups[-1]) == len(groups[-2])):
        return
    everybody, largest = np.ones((1, robots), np.bool_), np.isin(np.arange(robots), groups[-1])[None]
    found = []
    for present in (everybody, largest):
        memory, values = new_memory(1, robots), np.empty((1, len(METRICS)))
        for tick in range(2):
            elapsed = np.array([500_000_000 * tick])
            measure_tick(places[tick][None], yaw[tick][None], present, elapsed, memory, values)
        found.append(values[0])
    for name in (name for name in COLUMN if name.endswith("_largest")):
        whole = name.removesuffix("_largest")
        assert np.array_equal(found[0][COLUMN[name]], found[1][COLUMN[whole]], equal_nan=True), name
        assert np.array_equal(found[1][COLUMN[name]], found[1][COLUMN[whole]], equal_nan=True), name
