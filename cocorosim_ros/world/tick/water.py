"""The water of a world: what does not change during a run, and what does."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.force_currents import ForceCurrents
from cocorosim_ros.scenario.parts.plume import Plume
from cocorosim_ros.world.seeding.seeding import generator
from cocorosim_ros.world.state.interval import Interval
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PATCH_FORCE_COLUMNS, Vehicles
from cocorosim_ros.world.water.currents.waves import add_wave_pressure
from cocorosim_ros.world.water.flow import make_flow
from cocorosim_ros.world.water.force_field.force_field import ForceField
from cocorosim_ros.world.water.force_field.wakes import JET_SIZE
from cocorosim_ros.world.water.layers import Layers, add_lift
from cocorosim_ros.world.water.patches import Patches
from cocorosim_ros.world.water.plume import Puffs, carry, concentrations, no_puffs, release


def _no_jets() -> Floats:
    return np.zeros((0, 0, JET_SIZE))


@dataclass(frozen=True)
class Water:
    """Still, unless told otherwise."""

    flow: Floats = field(default_factory=lambda: make_flow([]))  # velocity of the water
    forces: ForceCurrents | None = None
    patches: Patches | None = None  # of the forces
    jets: Floats = field(default_factory=_no_jets)  # (robots, jets, JET_SIZE), see force_field.wakes
    plume: Plume | None = None
    waves: tuple[Floats, ...] = ()  # the numbers of each sea, which pressure sensors feel
    layers: Layers | None = None  # of density
    ticks_per_step: int = 1  # of the forces
    seed: int = 0
    first_run: int = 0  # the number of the first of the runs, which with the seed decides their cold spots


class MovingWater:
    """The state of the force currents in all runs, and what they do to the robots.

    `vehicles`: the robots' numbers, of which those of the effect `patch_force` follow the water.
    """

    def __init__(self, water: Water, vehicles: Vehicles) -> None:
        """Currents begin at rest."""
        runs, robots = vehicles.active.shape
        self.water = water
        self.vehicles = vehicles
        self.fields: list[ForceField] = []
        self.puffs: Puffs = no_puffs()
        self.concentration: Floats = np.zeros((runs, robots))  # of the plume at every robot [kg/m^3]
        self._push = np.zeros((runs, robots, 4))
        if water.layers is None and (water.forces is None or water.patches is None):
            return
        self.vehicles = vehicles._replace(
            parameters=vehicles.parameters.copy(), active=vehicles.active | EFFECT_BIT["patch_force"]
        )
        if water.forces is None or water.patches is None:
            return
        draws = [generator(water.seed, "cold spots", run=water.first_run + run) for run in range(runs)]
        self.fields = [ForceField(water.forces, water.patches, random) for random in draws]

    def press(self, state: Floats, time: float, weight: Floats, pressure: Floats) -> None:
        """Add what waves do to the `pressure` (runs, robots) [Pa] of robots; `weight` (robots,) of the water [Pa/m]."""
        for sea in self.water.waves:
            add_wave_pressure(state, time, sea, weight, pressure)

    def begin(self, state: Floats) -> None:
        """Let the water act on robots that are where `state` (runs, robots, columns) says at time 0."""
        if self.water.layers is not None:
            self._act(state, 0.0)

    def advance(self, tick: int, state: Floats, tank: Tank, tick_ns: int) -> None:
        """Bring the water to the end of `tick`, at which robots are where `state` (runs, robots, columns) says."""
        if self.fields:
            self._advance_forces(tick, state)
        if self.fields or self.water.layers is not None:
            self._act(state, (tick + 1) * tick_ns * 1e-9)
        if self.water.plume is not None:
            self.puffs = advance_puffs(self.puffs, self.water.plume, self.water.flow, tank, Ticking(tick, tick_ns))
            concentrations(state, self.puffs, tank, self.concentration)

    def _advance_forces(self, tick: int, state: Floats) -> None:
        due = (tick + 1) % self.water.ticks_per_step == 0
        for run, forces in enumerate(self.fields):
            if due:
                forces.advance(state[run], self.water.jets)
            forces.push(state[run], self._push[run])

    def _act(self, state: Floats, time: float) -> None:
        """Write what pushes the robots from `time` [s] on where their numbers are."""
        if self.water.layers is not None:
            if not self.fields:
                self._push[...] = 0.0
            add_lift(state, time, self.water.layers, self._push)
        self.vehicles.parameters[..., PATCH_FORCE_COLUMNS] = self._push


class Ticking(NamedTuple):
    """Which tick it is, and how long ticks are [ns]."""

    tick: int
    tick_ns: int


def advance_puffs(puffs: Puffs, plume: Plume, flow: Floats, tank: Tank, ticking: Ticking) -> Puffs:
    """The puffs at the end of a tick: a new one where one is due at its beginning, and all of them carried along."""
    begin_ns = ticking.tick * ticking.tick_ns
    if begin_ns % plume.interval_ns == 0:
        puffs = release(puffs, np.array(plume.source), plume.initial_size, plume.rate * plume.interval_ns * 1e-9)
    carry(puffs, flow, tank, Interval(begin_ns * 1e-9, ticking.tick_ns * 1e-9), plume.diffusivity)
    return puffs
