"""Random numbers tick by tick for many robots of many runs, drawn in blocks outside the compiled loops."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.seeding.seeding import generator

Draw = Callable[[np.random.Generator, tuple[int, int]], Floats]
NUMBERS_AT_ONCE = 4_000_000  # of all robots together; how many are drawn at once does not change them


def standard_normal(random: np.random.Generator, shape: tuple[int, int]) -> Floats:
    """Numbers of mean 0 and standard deviation 1."""
    return random.standard_normal(shape)


def uniform(random: np.random.Generator, shape: tuple[int, int]) -> Floats:
    """Numbers evenly from 0 to below 1."""
    return random.random(shape)


class RandomBlocks:
    """`width` numbers per tick for each of some robots in each of some runs.

    Each robot of each run has its own generator (seeding.seeding): its numbers depend on seed, purpose, its name
    and the run's number alone, not on who else is there. Ticks are asked for in ascending order.
    """

    def __init__(self, seed: int, purpose: str, robots: Sequence[str], runs: range, width: int, draw: Draw) -> None:
        self._generators = [[generator(seed, purpose, robot, run) for robot in robots] for run in runs]
        self._width = width
        self._draw = draw
        self._length = max(1, min(256, NUMBERS_AT_ONCE // max(1, len(robots) * len(runs) * width)))
        self._first = 0
        self._block = self._next_block()

    def at(self, tick: int) -> Floats:
        """(runs, robots, width) the numbers of a tick; not of one before the present block."""
        while tick >= self._first + self._length:
            self._first += self._length
            self._block = self._next_block()
        numbers: Floats = self._block[:, :, tick - self._first]
        return numbers

    def _next_block(self) -> Floats:
        shape = (self._length, self._width)
        return np.array([[self._draw(random, shape) for random in row] for row in self._generators])
