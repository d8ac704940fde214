"""What corruptions of sensors and of links share while they work: whom each concerns, and its own random numbers."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from typing import TypeVar

import numpy as np

from cocorosim_ros.scenario.parts.corruption import Corruption, purposes
from cocorosim_ros.world.seeding.random_blocks import RandomBlocks, standard_normal, uniform

Kind = TypeVar("Kind", bound="CorruptionAtWork")


class CorruptionAtWork:
    """One corruption at work on some robots of some runs."""

    def __init__(self, corruption: Corruption, purpose: str, seed: int, robots: Sequence[str], runs: range) -> None:
        """`robots` are the names of all; `purpose` names the random numbers, which no other corruption shares."""
        self.channel = corruption.channel
        self._kind = corruption.kind
        self._numbers = corruption.numbers
        chosen = range(len(robots)) if corruption.robots is None else [robots.index(name) for name in corruption.robots]
        self._chosen = np.array(chosen, dtype=np.int64)
        self._source = (seed, f"corruption {purpose}", [robots[index] for index in chosen], runs)
        self._random: RandomBlocks | None = None

    def _blocks(self, width: int, *, normal: bool) -> RandomBlocks:
        """Its numbers, `width` for each robot and tick; a corruption asks for one width and one kind alone."""
        if self._random is None:
            self._random = RandomBlocks(*self._source, width, standard_normal if normal else uniform)
        return self._random


def corruptions_at_work(
    make: Callable[[Corruption, str, int, Sequence[str], range], Kind],
    channels: Collection[str],
    corruptions: Sequence[Corruption],
    source: tuple[int, Sequence[str], range],
) -> list[Kind]:
    """The corruptions of these channels at work, in their order; source: seed, names of all robots, runs."""
    return [
        make(corruption, purpose, *source)
        for corruption, purpose in zip(corruptions, purposes(corruptions), strict=True)
        if corruption.channel in channels
    ]
