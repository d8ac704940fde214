"""Cold spots: patches that pull the water around them, stronger and weaker again, and then are gone.

A spot of age a steps pulls with force * sin(pi a / lifetime); spots add up.
Source: Read et al. 2013, sections 3.1 and 5.1.
"""

from __future__ import annotations

import math
from itertools import product

import numpy as np

from cocorosim_ros.foundation.arrays import Integers
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.force_currents import ColdSpots
from cocorosim_ros.world.water.force_field.arriving import Spots, make_way, put_in_front
from cocorosim_ros.world.water.force_field.pulls import Pull
from cocorosim_ros.world.water.force_field.stored_water import row_width
from cocorosim_ros.world.water.patches import Patches

_SPARE = 10.0
_SLABS_REACHED = 3


def pull_of(kind: str) -> Pull:
    """The pull of `surrounding_26` (unit vectors towards the spot) or of `released_18`.

    released_18: faces 1; horizontal diagonals a unit vector; vertical diagonals 1 along both axes; no corners.
    """
    weight = np.zeros((3, 3, 3, 3))
    for offset in product((-1, 0, 1), repeat=3):
        distance = math.sqrt(sum(part * part for part in offset))
        axes = sum(part != 0 for part in offset)
        if not axes or (kind == "released_18" and axes == 3):
            continue
        length = 1.0 if kind == "released_18" and offset[0] != 0 else distance
        for component in range(3):
            place = (component, *(1 + part for part in offset))
            weight[place] = -offset[2 - component] / length if offset[2 - component] != 0 else 0.0
    return Pull(weight)


def no_spots(settings: ColdSpots, lifetime: int, patches: Patches) -> Spots:
    """Nothing alive yet, with room for the spots of `lifetime` steps."""
    mean = settings.probability * patches.total * (2.0 if settings.spawning == "released" else 1.0)
    entries = _SLABS_REACHED * mean * lifetime / patches.ny
    return Spots(
        np.zeros(lifetime, dtype=np.int64),
        settings.force * np.sin(np.pi * np.arange(lifetime) / lifetime),
        np.array([patches.ny, patches.nz, row_width(patches.nx)]),
        np.zeros((patches.ny, _room_for(int(entries + _SPARE * math.sqrt(entries) + _SPARE))), dtype=np.uint64),
        np.zeros(patches.ny, dtype=np.int64),
        np.zeros(patches.ny, dtype=np.int64),
        np.zeros((lifetime, patches.ny), dtype=np.int64),
    )


def _room_for(entries: int) -> int:
    """Room of a list in which so many entries seldom have to be moved."""
    return 2 * entries


def new_places(settings: ColdSpots, patches: Patches, random: np.random.Generator) -> Integers:
    """(n, 3) patches (z, y, x) that become cold spots in one step."""
    if settings.spawning == "released":
        expected = 2.0 * settings.probability * patches.total
        number = int(expected) if expected >= 1.0 else int(random.random() < expected)
        chosen = random.integers(0, patches.total, number)
    else:
        # The number of patches that draw a success, then which: the same as a draw for each of them.
        number = int(random.binomial(patches.total, settings.probability))
        chosen = random.choice(patches.total, number, replace=False, shuffle=False)
    places = np.empty((number, 3), dtype=np.int64)
    _write_places(chosen, patches.ny, patches.nx, places)
    return places


@kernel
def _write_places(chosen: Integers, ny: int, nx: int, places: Integers) -> None:
    """Write z, y, x of patches that are numbered in this order into `places` (n, 3)."""
    for spot in range(chosen.shape[0]):
        plane = chosen[spot] // nx
        places[spot, 0], places[spot, 1], places[spot, 2] = plane // ny, plane % ny, chosen[spot] % nx


def spawn(spots: Spots, step: int, places: Integers) -> Spots:
    """The spots with those of `step` in place of the oldest, who have lived out; room is added when it lacks."""
    row = step % len(spots.number)
    longest = make_way(spots, row, places)
    lack = _room_for(longest) - spots.reached.shape[1] if longest > spots.reached.shape[1] else 0
    if lack > 0:
        spots = spots._replace(reached=np.pad(spots.reached, ((0, 0), (0, lack))))
    put_in_front(spots, row, places)
    return spots
