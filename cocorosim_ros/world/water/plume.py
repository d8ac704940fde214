"""A plume: puffs of a substance that the water carries along and that diffuse while they go.

A puff is a Gaussian cloud of constant mass. Its centre moves with the water, its variance grows by 2 D dt in each
direction. Walls, floor and surface reflect it (mirror images), so that its whole mass stays in the tank.
Assumes: puffs that are small against the scale on which the velocity of the water changes (shear does not deform
them); obstacles do not disturb them. Forces on patches (the paper's currents) are not velocities and do not carry them.
Source: Csanady, Turbulent Diffusion in the Environment (1973), chapter 1.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.state.interval import Interval
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.water.flow import add_water_velocity

_FAR = 8.0  # standard deviations, beyond which a cloud has less than 1e-14 of its height


class Puffs(NamedTuple):
    """Clouds of a substance, oldest first."""

    centre: Floats  # (puffs, 3) [m; world]
    variance: Floats  # (puffs,) in each direction [m^2]
    mass: Floats  # (puffs,) [kg]


def no_puffs() -> Puffs:
    """Clean water."""
    return Puffs(np.zeros((0, 3)), np.zeros(0), np.zeros(0))


def release(puffs: Puffs, source: Floats, size: float, mass: float) -> Puffs:
    """The puffs with a new one at `source` (3,) [m; world], of standard deviation `size` [m] and `mass` [kg]."""
    return Puffs(
        np.concatenate([puffs.centre, source[None]]),
        np.append(puffs.variance, size * size),
        np.append(puffs.mass, mass),
    )


@kernel
def carry(puffs: Puffs, flow: Floats, tank: Tank, clock: Interval, diffusivity: float) -> None:
    """Move the puffs along with the water (fourth-order Runge-Kutta) and let them diffuse [m^2/s].

    clock: when the step begins, and its length. What the flow would carry out of the tank stays at its wall.
    """
    time, step = clock.begin, clock.length
    place, velocity, total = stack_array(3), stack_array(3), stack_array(3)
    for puff in range(puffs.mass.shape[0]):
        for axis in range(3):
            place[axis], total[axis] = puffs.centre[puff, axis], 0.0
        moment = time
        for stage in range(4):
            for axis in range(3):
                velocity[axis] = 0.0
            add_water_velocity(place, moment, flow, velocity)
            reach = step if stage == 2 else 0.5 * step
            moment = time + reach
            for axis in range(3):
                total[axis] += (1.0 if stage in (0, 3) else 2.0) * velocity[axis]
                place[axis] = puffs.centre[puff, axis] + reach * velocity[axis]
        for axis in range(3):
            moved = puffs.centre[puff, axis] + step / 6.0 * total[axis]
            puffs.centre[puff, axis] = min(max(moved, tank.lower[axis]), tank.upper[axis])
        puffs.variance[puff] += 2.0 * diffusivity * step


@kernel
def _between_walls(place: float, centre: float, variance: float, low: float, high: float) -> float:
    """Density [1/m] along one axis of a cloud whose tails two walls reflect."""
    width = high - low
    reach = _FAR * math.sqrt(variance)
    images = math.ceil(reach / (2.0 * width)) + 1
    density = 0.0
    for image in range(-images, images + 1):
        shift = 2.0 * width * image
        direct = place - (centre + shift)
        mirrored = place - (2.0 * low - centre + shift)
        density += math.exp(-0.5 * direct * direct / variance) + math.exp(-0.5 * mirrored * mirrored / variance)
    return density / math.sqrt(2.0 * math.pi * variance)


@kernel
def concentration_at(place: Floats, puffs: Puffs, tank: Tank) -> float:
    """Concentration [kg/m^3] of the substance at a place (3,) [m; world] in the tank."""
    total = 0.0
    for puff in range(puffs.mass.shape[0]):
        share, variance = puffs.mass[puff], puffs.variance[puff]
        for axis in range(3):
            share *= _between_walls(place[axis], puffs.centre[puff, axis], variance, tank.lower[axis], tank.upper[axis])
        total += share
    return total


@kernel
def concentrations(state: Floats, puffs: Puffs, tank: Tank, reading: Floats) -> None:
    """Write the concentration [kg/m^3] at every robot of `state` (runs, robots, columns) into `reading`."""
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            reading[run, robot] = concentration_at(state[run, robot, :3], puffs, tank)
