"""Currents that thrusters make: each sucks water from its side and blows it backwards.

A thruster that pushes the robot with force F makes, F being multiplied by the strength of the wakes:
  F    in the patch beside the robot on the thruster's side, towards the robot;
  F/4  in each of the patches behind, behind and up, behind and down, behind and outwards, all pointing backwards.
One that pulls backwards does the same in front of the robot. Patches that would lie outside the water get nothing.
Source: Read et al. 2013, section 3.1 and figure 2a.
"""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.state.state import STATE_SIZE, YAW, X, Y, Z
from cocorosim_ros.world.water.patches import Patches, is_water, patch_at

# Columns of a jet: the actuator it belongs to (-1: none), its part of the actuator's force, the direction in which the
# actuator pushes and the direction outwards, both horizontal unit vectors [body].
JET_ACTUATOR, JET_PART, JET_PUSH, JET_OUT = 0, 1, 2, 4
JET_SIZE = 6


class Wake(NamedTuple):
    """How all jets blow."""

    strength: float  # force in the water over that of the thruster
    spread: float  # tangent of the angle under which the outer jet leaves


@kernel
def _blow(field: Floats, patches: Patches, place: Floats, toward: Floats, force: float) -> None:
    """Add a horizontal force [N] along the unit vector `toward` (2,) to the patch around `place` (3,) [m; world]."""
    k, j, i = patch_at(patches, place[0], place[1], place[2])
    if is_water(patches, k, j, i):
        field[0, k, j, i] += force * toward[0]
        field[1, k, j, i] += force * toward[1]


@kernel
def _one_jet(field: Floats, patches: Patches, row: Floats, jet: Floats, wake: Wake) -> None:
    force = row[STATE_SIZE + int(jet[JET_ACTUATOR])] * jet[JET_PART] * wake.strength
    if force == 0.0:
        return
    sine, cosine = sine_cosine(row[YAW])
    out, back, inward, place = stack_array(2), stack_array(2), stack_array(2), stack_array(3)
    ahead = -1.0 if force > 0.0 else 1.0
    back[0] = ahead * (jet[JET_PUSH] * cosine - jet[JET_PUSH + 1] * sine)
    back[1] = ahead * (jet[JET_PUSH] * sine + jet[JET_PUSH + 1] * cosine)
    out[0] = jet[JET_OUT] * cosine - jet[JET_OUT + 1] * sine
    out[1] = jet[JET_OUT] * sine + jet[JET_OUT + 1] * cosine
    inward[0], inward[1] = -out[0], -out[1]
    force, side = abs(force), patches.side
    place[0], place[1], place[2] = row[X] + side * out[0], row[Y] + side * out[1], row[Z]
    _blow(field, patches, place, inward, force)
    for part in range(4):
        aside = wake.spread if part == 3 else 0.0
        place[0] = row[X] + side * (back[0] + aside * out[0])
        place[1] = row[Y] + side * (back[1] + aside * out[1])
        place[2] = row[Z] + (side if part == 1 else -side if part == 2 else 0.0)
        _blow(field, patches, place, back, 0.25 * force)


@kernel
def blow_wakes(field: Floats, patches: Patches, state: Floats, jets: Floats, wake: Wake) -> None:
    """Add the wakes of all robots of one run to `field` (3, nz, ny, nx) [N].

    state (robots, columns); jets (robots, jets, JET_SIZE).
    """
    for robot in range(state.shape[0]):
        for index in range(jets.shape[1]):
            if jets[robot, index, JET_ACTUATOR] >= 0.0:
                _one_jet(field, patches, state[robot], jets[robot, index], wake)
