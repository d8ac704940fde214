"""Sets of noise in groups of four, and the working space of passes under them (`many_noises`)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.filter.four_blocks import Block
from cocorosim_ros.diagnosis.filter.layout import CORRELATION, SMOOTHNESS
from cocorosim_ros.diagnosis.filter.random_force import Fading, fading
from cocorosim_ros.diagnosis.filter.records import Past
from cocorosim_ros.diagnosis.filter.spread_of_state import Covariances
from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.four import LANES, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.blocks import HFX, HGX, HORIZONTAL, VERTICAL, VFZ, VGZ


class Known(NamedTuple):
    """The pass whose course all sets share: its numbers, and what it found."""

    sensor: Floats  # by SENSOR_COLUMNS
    random_force: Floats  # by WATER_NOISE and WANDER
    left: Floats  # (m,) share of the error of the reading before that is still in each, in the order of the grid
    past: Past


class Noises(NamedTuple):
    """Sets of noise in groups of four; each is what `PassNumbers` has of one.

    In kernels the last axis is gone, and each number is a four.
    """

    random_force: Floats  # (groups, by WATER_NOISE and WANDER, 4)
    reading_variance: Floats  # (groups, KINDS, 4)
    left: Floats  # (groups, m, 4); (groups, 0, 4) if no error lasts
    swell: Floats  # (groups, points, 4); (groups, 0, 4) if the random force is the same at all times


class Beliefs(NamedTuple):
    """What the passes found, (groups, m, 4) each, in the order of the track; in kernels as above."""

    innovation: Floats
    variance: Floats


class Space(NamedTuple):
    """Working space; of what has groups the last axis, of fours, is gone in kernels."""

    fade: Floats  # (groups, by Fading, 4)
    level: Floats  # (groups, 2 HORIZONTAL HORIZONTAL + HORIZONTAL, 4): covariance, work, how far the means are off
    upright: Floats  # the same of VERTICAL
    seen: Floats  # (HORIZONTAL, 4), as `Sight` has them
    felt: Integers  # (HORIZONTAL,)
    level_ahead: Floats  # (HFX, HGX), and so on: shared by all groups
    upright_ahead: Floats  # (VFZ, VGZ)
    level_push: Floats  # (6,)
    upright_push: Floats  # (2,)
    level_slope: Floats  # (HFX, HORIZONTAL)
    upright_slope: Floats  # (VFZ, VERTICAL)
    response: Floats  # (4 + 9,)


def make_space(noises: Noises, step: float) -> Space:
    """Working space for these sets, on a grid with this step [s]."""
    groups = len(noises.random_force)
    fades = [
        [fading(step, *noises.random_force[group, [CORRELATION, SMOOTHNESS], lane]) for lane in range(LANES)]
        for group in range(groups)
    ]
    return Space(
        np.ascontiguousarray(np.swapaxes(fades, 1, 2)),
        np.zeros((groups, 2 * HORIZONTAL * HORIZONTAL + HORIZONTAL, LANES)),
        np.zeros((groups, 2 * VERTICAL * VERTICAL + VERTICAL, LANES)),
        np.zeros((HORIZONTAL, LANES)),
        np.zeros(HORIZONTAL, dtype=np.int64),
        *(np.zeros(size) for size in (HFX * HGX, VFZ * VGZ, 6, 2, HFX * HORIZONTAL, VFZ * VERTICAL, 4 + 9)),
    )


@kernel
def noises_in_fours(noises: Noises) -> Noises:
    """The same sets, each number a four."""
    return Noises(
        in_fours(noises.random_force), in_fours(noises.reading_variance), in_fours(noises.left), in_fours(noises.swell)
    )


@kernel
def space_in_fours(space: Space) -> Space:
    """The same space, fours over all that has groups."""
    return Space(
        in_fours(space.fade), in_fours(space.level), in_fours(space.upright), in_fours(space.seen), space.felt,
        space.level_ahead, space.upright_ahead, space.level_push, space.upright_push, space.level_slope,
        space.upright_slope, space.response,
    )  # fmt: skip


@kernel
def _block(numbers: Floats, size: int, ahead: Floats, push: Floats) -> Block:
    square = size * size
    return Block(numbers[:square], numbers[2 * square :], numbers[square : 2 * square], ahead, push)


@kernel
def level_block(space: Space, group: int) -> Block:
    """The horizontal block of a group."""
    block: Block = _block(space.level[group], HORIZONTAL, space.level_ahead, space.level_push)
    return block


@kernel
def upright_block(space: Space, group: int) -> Block:
    """The vertical block of a group."""
    block: Block = _block(space.upright[group], VERTICAL, space.upright_ahead, space.upright_push)
    return block


@kernel
def covariances_of(space: Space, group: int) -> Covariances:
    """The covariances of a group."""
    return Covariances(level_block(space, group).covariance, upright_block(space, group).covariance)


@kernel
def fading_of(space: Space, group: int) -> Fading:
    """What becomes of the random forces of a group over a step."""
    row = space.fade[group]
    return Fading(row[0], row[1], row[2], row[3], row[4], row[5], row[6])
