"""What corruptions of sensors and of links share while they work: whom each concerns, and its own random numbers."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from cocorosim_ros.scenario.parts.corruption import Corruption, purposes
from cocorosim_ros.world.seeding.random_blocks import RandomBlocks, standard_normal, uniform

Kind = TypeVar("Kind", bound="CorruptionAtWork")


@dataclass(frozen=True)
class Swarms:
    """All robots of some runs of one scenario, as far as their random numbers depend on them."""

    seed: int
    robots: Sequence[str]
    """Names of all."""
    runs: range


class CorruptionAtWork:
    """One corruption at work on some robots of some runs."""

    def __init__(self, corruption: Corruption, purpose: str, swarms: Swarms) -> None:
        """`purpose` names the random numbers, which no other corruption shares."""
        robots = swarms.robots
        self.channel = corruption.channel
        self._kind = corruption.kind
        self._numbers = corruption.numbers
        chosen = range(len(robots)) if corruption.robots is None else [robots.index(name) for name in corruption.robots]
        self._chosen = np.array(chosen, dtype=np.int64)
        self._purpose = f"corruption {purpose}"
        self._swarms = replace(swarms, robots=[robots[index] for index in chosen])
        self._random: RandomBlocks | None = None

    def _blocks(self, width: int, *, normal: bool) -> RandomBlocks:
        """Its numbers, `width` for each robot and tick; a corruption asks for one width and one kind alone."""
        if self._random is None:
            draw, swarms = standard_normal if normal else uniform, self._swarms
            self._random = RandomBlocks(swarms.seed, self._purpose, swarms.robots, swarms.runs, width, draw)
        return self._random


def corruptions_at_work(
    make: Callable[[Corruption, str, Swarms], Kind],
    channels: Collection[str],
    corruptions: Sequence[Corruption],
    swarms: Swarms,
) -> list[Kind]:
    """The corruptions of these channels at work, in their order."""
    return [
        make(corruption, purpose, swarms)
        for corruption, purpose in zip(corruptions, purposes(corruptions), strict=True)
        if corruption.channel in channels
    ]
