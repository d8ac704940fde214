"""The force currents of one run: their present state and one step of theirs."""

from __future__ import annotations

import math
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.force_currents import ForceCurrents
from cocorosim_ros.world.water.force_field.cold_spots import new_places, no_spots, pull_of, spawn
from cocorosim_ros.world.water.force_field.pulls import Spots, Stretches, pull_plane, pull_water, stretches_of
from cocorosim_ros.world.water.force_field.push import push_robots
from cocorosim_ros.world.water.force_field.spreading import (
    begin_spreading,
    spread,
    spread_plane,
    spreading_scratch,
    spreading_weights,
)
from cocorosim_ros.world.water.force_field.wakes import Wake, blow_wakes
from cocorosim_ros.world.water.force_field.walls import redirect_at_walls, wall_scratch
from cocorosim_ros.world.water.patches import Patches

PATCHES_FOR_THREADS = 1_000_000  # below, threads cost more than they save and many runs keep all processors busy


class Spreading(NamedTuple):
    """What force spreads with; only the weights hold anything between two steps."""

    weights: Floats  # (2, 28), see spreading_weights
    planes: Floats  # (4, ny * nx) of sums
    ends: Floats  # (2, ny) of every row


class Pulling(NamedTuple):
    """What cold spots do at a step."""

    spots: Spots
    step: int
    stretches: Stretches


class Components(NamedTuple):
    """Components x, y, z of a field, from the first to before the last."""

    first: int
    last: int


@kernel
def _spread(field: Floats, components: Components, spreading: Spreading) -> None:
    """Diffusion and decay."""
    weights, planes, ends = spreading
    for component in range(components.first, components.last):
        spread(field[component], weights, planes, ends)


@kernel
def _spread_and_pull(field: Floats, components: Components, spreading: Spreading, pulling: Pulling) -> None:
    """Diffusion, decay and cold spots, plane by plane while a plane is near the processor."""
    weights, planes, ends = spreading
    spots, step, stretches = pulling
    nz, ny, nx = field.shape[1:]
    for component in range(components.first, components.last):
        water = field[component].reshape(nz, ny * nx)
        begin_spreading(water, nx, planes)
        for z in range(nz):
            spread_plane(water, z, weights, planes, ends)
            pull_plane(water[z], z, component, step, spots, stretches)


class ForceField:
    """Forces on all patches, at rest in the beginning.

    `field` (3, nz, ny, nx) [N; world], components x, y, z.
    """

    def __init__(self, settings: ForceCurrents, patches: Patches, random: np.random.Generator) -> None:
        """`random` draws the cold spots and nothing else."""
        self.settings = settings
        self.patches = patches
        self.step = 0
        self.field: Floats = np.zeros((3, *patches.shape))
        self._random = random
        weights, threads = spreading_weights(settings), 3 if patches.total >= PATCHES_FOR_THREADS else 1
        self._spreading: list[Spreading] = [
            Spreading(weights, *spreading_scratch(patches.shape)) for _ in range(threads)
        ]
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
        if self._spots is None or self._stretches is None:
            self.spread()
        else:
            self.spawn()
            self._spread_and_chill(self._spots, self._stretches)
        wakes = self.settings.wakes
        if wakes is not None and wakes.strength > 0.0:
            blow_wakes(self.field, self.patches, state, jets, Wake(wakes.strength, math.tan(wakes.outer_angle)))
        self.step += 1

    def spread(self) -> None:
        """Diffusion and decay, and what walls do."""
        self._for_components(lambda components, own: _spread(self.field, components, own))
        if self.settings.walls == "redirected":
            redirect_at_walls(self.field, self._taken)

    def _for_components(self, work: Callable[[Components, Spreading], None]) -> None:
        """Do the work for all components. They do not know of each other, so that large ones go side by side."""
        if len(self._spreading) == 1:
            work(Components(0, 3), self._spreading[0])
            return
        with ThreadPoolExecutor(3) as threads:
            list(threads.map(work, [Components(each, each + 1) for each in range(3)], self._spreading))

    def spawn(self) -> None:
        """New cold spots in place of the oldest; the number of draws does not depend on their force."""
        if self._spots is not None and self.settings.cold_spots is not None:
            places = new_places(self.settings.cold_spots, self.patches, self._random)
            self._spots = spawn(self._spots, self.step, places)

    def _spread_and_chill(self, spots: Spots, stretches: Stretches) -> None:
        if self.settings.walls == "redirected":
            self.spread()
            pull_water(self.field, spots, self.step, stretches)
            return
        pulling = Pulling(spots, self.step, stretches)
        self._for_components(lambda components, own: _spread_and_pull(self.field, components, own, pulling))

    def push(self, state: Floats, push: Floats) -> None:
        """Write force [N; world] and yaw moment [N m] on the robots of `state` into `push` (robots, 4)."""
        push_robots(self.field, self.patches, self.settings.torque_lever, state, push)
