"""Going up the concentration without being told where the water comes from: what docs/the_paper.md says of it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from cocorosim_ros.world.state.state import YAW, X, Z
from cocorosim_ros.world.water.plume import concentration_at

Swim = Callable[..., Any]
REACHED = 0.4  # m
LEG = 20  # ticks, 10 s


class ExactGradient:
    """Every 2 s along the horizontal gradient where each robot is, by central differences of 4 cm; else straight on."""

    def __init__(self) -> None:
        self._heading: Any = None

    def __call__(self, tick: int, simulation: Any) -> Any:
        """The headings of all robots."""
        if self._heading is None:
            self._heading = simulation.state[0, :, YAW].copy()
        if tick % 4 == 0:
            for robot, state in enumerate(simulation.state[0]):
                around = np.tile(state[X : Z + 1], (4, 1))
                around[(0, 1, 2, 3), (0, 0, 1, 1)] += (0.02, -0.02, 0.02, -0.02)
                smell = [concentration_at(place, simulation.water.puffs, simulation.world.tank) for place in around]
                if smell[0] != smell[1] or smell[2] != smell[3]:
                    self._heading[robot] = math.atan2(smell[2] - smell[3], smell[0] - smell[1])
        return self._heading


class Comparing:
    """After each leg a heading at random where the smell is not stronger than before it, else the same again."""

    def __init__(self) -> None:
        self._random = np.random.default_rng(1)
        self._heading: Any = None
        self._before: Any = None

    def __call__(self, tick: int, simulation: Any) -> Any:
        """The headings of all robots."""
        smell = simulation.readings.concentration[0]
        if self._heading is None:
            self._heading, self._before = simulation.state[0, :, YAW].copy(), smell.copy()
        elif tick % LEG == 0:
            drawn = self._heading + self._random.uniform(-math.pi, math.pi, len(smell))
            self._heading = np.where(smell <= self._before, drawn, self._heading)
            self._before = smell.copy()
        return self._heading


class Weaving:
    """Legs across a course, to alternate sides; the course turns to the side that smelt stronger."""

    def __init__(self) -> None:
        self._course: Any = None
        self._side, self._sum = 1.0, 0.0
        self._before: Any = None

    def __call__(self, tick: int, simulation: Any) -> Any:
        """The headings of all robots."""
        if self._course is None:
            self._course = simulation.state[0, :, YAW].copy()
        elif tick % LEG == 0:
            mean, self._sum = self._sum / LEG, 0.0
            if self._before is not None:
                self._course = self._course + self._side * 1.5 * np.clip(mean - self._before, -1.0, 1.0)
            self._before, self._side = mean, -self._side
        self._sum = self._sum + np.log(np.maximum(simulation.readings.concentration[0], 1e-30))
        return self._course + self._side * 0.5 * math.pi


def test_the_exact_gradient_leads_to_the_source(nearest_to_the_leak: Swim) -> None:
    """Most arrive, so that it is not the plume that forbids it; no instrument shows the gradient, though."""
    assert (nearest_to_the_leak(ExactGradient()) < REACHED).sum() >= 12


def test_one_sensor_in_motion_leads_there_less_often(nearest_to_the_leak: Swim) -> None:
    """Two simple forms, neither tuned: a few of 20 arrive, and not most, where surge and cast brings at least 19."""
    compared, woven = (nearest_to_the_leak(steering()) for steering in (Comparing, Weaving))
    assert (compared < REACHED).sum() <= 6
    assert (woven < REACHED).sum() <= 12
