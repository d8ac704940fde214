"""What the controllers of a swarm ask for beyond the instruments that everybody has."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Flags


@dataclass(frozen=True)
class Wants:
    """Each (robots,): who knows its neighbours exactly, hears or speaks over blue light, hears or speaks by sound."""

    neighbours: Flags
    blue_light: Flags
    speaks_light: Flags
    sound: Flags
    speaks_sound: Flags


def nothing(robots: int) -> Wants:
    """Nobody wants anything."""
    return Wants(*(np.zeros(robots, dtype=bool) for _ in range(5)))
