"""From a scenario to its water."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.ocean_current import OceanCurrent
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.scenario.parts.water import patch_counts
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.tick.water import Water
from cocorosim_ros.world.vehicle_model.plausible_body import displaced_mass
from cocorosim_ros.world.water.current_numbers import scenario_currents
from cocorosim_ros.world.water.flow import make_flow
from cocorosim_ros.world.water.force_field.wakes import JET_SIZE
from cocorosim_ros.world.water.layers import Layers
from cocorosim_ros.world.water.ocean.ocean_field import ocean_field
from cocorosim_ros.world.water.patches import Patches

_NO_JET = [-1.0, 0.0, 1.0, 0.0, 0.0, 1.0]
_HORIZONTAL = 1e-6


def build_water(scenario: Scenario, first_run: int = 0) -> Water:
    """The water of a scenario for runs that are numbered from `first_run`."""
    if scenario.water is None:
        return Water()
    forces = scenario.water.force_currents
    currents = scenario_currents(scenario)
    still = Water(
        flow=make_flow(currents),
        plume=scenario.water.plume,
        waves=tuple(numbers for name, numbers in currents if name == "waves"),
        layers=_layers(scenario),
    )
    if forces is None:
        return still
    return replace(
        still,
        forces=forces,
        patches=build_patches(scenario, forces.patch),
        jets=build_jets([robot.platform for robot in scenario.robots]),
        ticks_per_step=forces.step_ns // scenario.tick_ns,
        seed=scenario.seed,
        first_run=first_run,
    )


def _layers(scenario: Scenario) -> Layers | None:
    """The density of the water, if an ocean model gives it and it acts; the first such current's."""
    for current in () if scenario.water is None else scenario.water.currents:
        if isinstance(current, OceanCurrent) and current.buoyancy:
            platforms = [robot.platform for robot in scenario.robots]
            own = np.array([platform.water_density for platform in platforms])
            displaced = [displaced_mass(platform) or platform.mass for platform in platforms]
            return Layers(
                ocean_field(current, scenario.tank.size, scenario.duration).density,
                own if current.reference_density is None else np.full(len(platforms), current.reference_density),
                np.array([platform.gravity for platform in platforms]) * displaced / own,
            )
    return None


def build_patches(scenario: Scenario, side: float) -> Patches:
    """The patches [m] of a scenario's tank."""
    nx, ny, nz = patch_counts(scenario.tank.size, side)
    return Patches(np.array(scenario.tank.lower_corner()), side, nx, ny, nz)


def build_jets(platforms: Sequence[Platform]) -> Floats:
    """(robots, jets, JET_SIZE) the jets of all robots, see force_field.wakes."""
    rows = [platform_jets(platform) for platform in platforms]
    jets = np.tile(np.array(_NO_JET), (len(platforms), max(1, *(len(row) for row in rows)), 1))
    for robot, row in enumerate(rows):
        jets[robot, : len(row)] = np.reshape(row, (-1, JET_SIZE))
    return jets


def platform_jets(platform: Platform) -> list[list[float]]:
    """A jet for every thruster that pushes horizontally; one on the centre line makes half a jet to each side.

    Vertical thrusters and pumps make none: the paper says nothing of them.
    """
    jets: list[list[float]] = []
    for index, part in enumerate(platform.actuators):
        if not isinstance(part, Thruster) or math.hypot(*part.direction[:2]) < _HORIZONTAL:
            continue
        length = math.hypot(*part.direction[:2])
        push = (part.direction[0] / length, part.direction[1] / length)
        # How far to the left of its own line of action the thruster sits.
        aside = push[0] * part.position[1] - push[1] * part.position[0]
        sides = [math.copysign(1.0, aside)] if abs(aside) > _HORIZONTAL else [1.0, -1.0]
        jets += [[float(index), 1.0 / len(sides), *push, -side * push[1], side * push[0]] for side in sides]
    return jets
