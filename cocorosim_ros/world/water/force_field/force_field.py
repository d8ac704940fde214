"""The force currents of one run: their present state and one step of theirs."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stretch import Stretch
from cocorosim_ros.foundation.processors import processors
from cocorosim_ros.foundation.side_by_side import SideBySide
from cocorosim_ros.scenario.parts.force_currents import ForceCurrents
from cocorosim_ros.world.water.force_field.arriving import Spots
from cocorosim_ros.world.water.force_field.cold_spots import new_places, no_spots, pull_of, spawn
from cocorosim_ros.world.water.force_field.parts_of_water import Spreading, keep_edges, spreading_parts
from cocorosim_ros.world.water.force_field.pulls import (
    Pulling,
    Stretches,
    pull_slab,
    pull_water,
    strength_at,
    stretches_of,
)
from cocorosim_ros.world.water.force_field.push import push_robots
from cocorosim_ros.world.water.force_field.spreading import spread_slab
from cocorosim_ros.world.water.force_field.stored_water import by_place, still_water
from cocorosim_ros.world.water.force_field.wakes import Wake, blow_wakes
from cocorosim_ros.world.water.force_field.walls import redirect_at_walls, wall_scratch
from cocorosim_ros.world.water.patches import Patches

PATCHES_FOR_THREADS = 1_000_000  # below, threads cost more than they save and many runs keep all processors busy
PARTS_OF_A_PROCESSOR = 2  # so that one that others use as well does not keep the others waiting for half of the water
PATCHES_NEAR = 60_000  # of one component that stay in a processor's second cache


@kernel
def _spread(water: Floats, spreading: Spreading) -> None:
    """Diffusion and decay of one part."""
    for component in range(3):
        for y in range(spreading.first, spreading.last):
            spread_slab(water[component], y, component, spreading)


@kernel
def _spread_and_pull(water: Floats, spreading: Spreading, pulling: Pulling) -> None:
    """Diffusion, decay and cold spots of one part, a few slabs after the other while they are near the processor."""
    slabs = max(1, PATCHES_NEAR // water.shape[2])
    for first in range(spreading.first, spreading.last, slabs):
        last = min(first + slabs, spreading.last)
        for component in range(3):
            for y in range(first, last):
                spread_slab(water[component], y, component, spreading)
        for y in range(first, last):
            pull_slab(water, y, pulling)


class ForceField:
    """Forces on all patches, at rest in the beginning.

    `field` (3, nz, ny, nx) [N; world], components x, y, z: a view of `water`, which is as memory has it.
    """

    def __init__(self, settings: ForceCurrents, patches: Patches, random: np.random.Generator) -> None:
        """`random` draws the cold spots and nothing else."""
        self.settings = settings
        self.patches = patches
        self.step = 0
        self.water: Floats = still_water(patches)
        self.field: Floats = by_place(self.water, patches)
        self._random = random
        parts = PARTS_OF_A_PROCESSOR * processors() if patches.total >= PATCHES_FOR_THREADS else 1
        self._parts = spreading_parts(settings, patches, min(parts, patches.ny))
        self._side_by_side = SideBySide(len(self._parts), at_a_time=1)
        self._taken = wall_scratch(patches.shape)
        self._spots: Spots | None = None
        self._stretches: Stretches | None = None
        if settings.cold_spots is not None:
            self._spots = no_spots(settings.cold_spots, settings.lifetime_steps, patches)
            self._stretches = stretches_of(pull_of(settings.cold_spots.neighbours), self._spots.shape)

    @property
    def spots_alive(self) -> int:
        """How many cold spots there are, those that appeared in this step included."""
        return 0 if self._spots is None else int(self._spots.number.sum())

    def advance(self, state: Floats, jets: Floats) -> None:
        """Take one step: diffusion, decay, cold spots, thrusters of the robots of `state` (robots, columns)."""
        self.spawn()
        pulling = self.pulling()
        if pulling is None:
            self.spread()
        else:
            self.spread_and_pull(pulling)
        wakes = self.settings.wakes
        if wakes is not None and wakes.strength > 0.0:
            blow_wakes(self.field, self.patches, state, jets, Wake(wakes.strength, math.tan(wakes.outer_angle)))
        self.step += 1

    def spread(self) -> None:
        """Diffusion and decay, and what walls do."""
        self._for_parts(lambda part: _spread(self.water, part))
        if self.settings.walls == "redirected":
            redirect_at_walls(self.field, self._taken)

    def _for_parts(self, work: Callable[[Spreading], None]) -> None:
        """Do the work for all parts of the water, those of large water side by side."""
        for part in self._parts:
            keep_edges(self.water, part)

        def work_on(which: Stretch | None) -> None:
            for part in self._parts if which is None else self._parts[which.first : which.last]:
                work(part)

        self._side_by_side.do(work_on)

    def spawn(self) -> None:
        """New cold spots in place of the oldest; the number of draws does not depend on their force."""
        if self._spots is not None and self.settings.cold_spots is not None:
            places = new_places(self.settings.cold_spots, self.patches, self._random)
            self._spots = spawn(self._spots, self.step, places)

    def pulling(self) -> Pulling | None:
        """What cold spots do at the present step; None without any."""
        if self._spots is None or self._stretches is None:
            return None
        return Pulling(self._spots, strength_at(self._spots, self.step), self._stretches)

    def spread_and_pull(self, pulling: Pulling) -> None:
        """Diffusion, decay, what walls do, and the pull of cold spots."""
        if self.settings.walls == "redirected":
            self.spread()
            pull_water(self.water, pulling)
            return
        self._for_parts(lambda part: _spread_and_pull(self.water, part, pulling))

    def push(self, state: Floats, push: Floats) -> None:
        """Write force [N; world] and yaw moment [N m] on the robots of `state` into `push` (robots, 4)."""
        push_robots(self.field, self.patches, self.settings.torque_lever, state, push)
