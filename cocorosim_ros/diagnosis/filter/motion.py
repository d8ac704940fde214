"""Motion of the filter's mean: midpoint steps of the simulator's dynamics, and their slopes."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.filter.random_force import Fading
from cocorosim_ros.diagnosis.filter.records import Drive, Grid, Stretch
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.motion.dynamics import COUPLING_BITS, state_rate
from cocorosim_ros.world.motion.surroundings import LOOKING
from cocorosim_ros.world.state.state import HEAVE, MEMORY_SIZE, RATE, STATE_SIZE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.blocks import HFX, HFY, HN, HORIZONTAL, HR, HU, HV, HX, HY, HYAW, VERTICAL, VFZ, VW, VZ
from cocorosim_ros.world.vehicle_model.vehicles import BASIC_BITS, PATCH_FORCE_COLUMNS, Body

PUSH_X, PUSH_Y, PUSH_Z, PUSH_YAW = PATCH_FORCE_COLUMNS  # world x, y, z [N] and yaw [N m], behind each other
FORCE = PUSH_X  # the first of the four
ROW_SHARE = 2 + MEMORY_SIZE  # columns of a row for each actuator
NUDGE = 1e-4  # m, rad, m/s, rad/s, N, N m for slopes of the rate
AT_POINT = 2  # number of stages of a step before the rates at its end
HELD = Fading(1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0)  # random forces that stay as they are given


class Clock(NamedTuple):
    """A step of the grid."""

    time: float  # of its end [s]
    step: float  # its length [s]
    fade: Fading  # what becomes of random forces over it


class Motion(NamedTuple):
    """Working space: the moving row, a trial of it, and rates."""

    row: Floats
    trial: Floats
    rate: Floats  # at the grid point that was reached last, mean of just before it and just behind it
    leap: Floats  # by how much the rate is greater just behind it, where commands change
    gust: Floats  # (4,) what drives the random force, world x, y, z [N] and moment [N m]


@allocating_kernel
def make_motion(start: Floats, body: Body) -> Motion:
    """Working space for a robot in the state `start` (8,), with all actuators off and without random forces."""
    size = STATE_SIZE + ROW_SHARE * body.actuator_wrench.shape[0]
    motion = Motion(np.zeros(size), np.zeros(size), np.zeros(size), np.zeros(size), np.zeros(4))
    motion.row[:STATE_SIZE] = start
    body.parameters[FORCE : FORCE + 4] = 0.0
    return motion


@kernel
def put_drive(row: Floats, drive: Drive, point: int, earlier: int, body: Body) -> None:
    """Write forces and neighbours into the row: the mean of the drive at two grid points, which may be the same."""
    actuators = drive.force.shape[1]
    memory = STATE_SIZE + 2 * actuators
    for column in range(actuators):
        row[STATE_SIZE + column] = 0.5 * (drive.force[point, column] + drive.force[earlier, column])
        row[memory + MEMORY_SIZE * column + RATE] = 0.5 * (drive.rate[point, column] + drive.rate[earlier, column])
    if body.active & LOOKING == 0:
        return
    for other in range(body.neighbours.shape[0]):
        for column in range(body.neighbours.shape[1]):
            body.neighbours[other, column] = drive.around[point, other, column]


@kernel
def _fade(motion: Motion, fade: Fading, faded: Floats, body: Body) -> None:
    """Write the random forces at the end of the step into `faded`, and their mean over the step in their own place."""
    for column in range(4):
        force, gust = body.parameters[FORCE + column], motion.gust[column]
        faded[column] = fade.kept * force + fade.fed * gust
        body.parameters[FORCE + column] = 0.5 * (force + faded[column])
        motion.gust[column] = fade.gust * gust


@kernel
def _compare(motion: Motion, drive: Drive, point: int, body: Body) -> None:
    """Replace the rates just before and just behind a grid point by their mean and their difference."""
    for column in range(STATE_SIZE):
        before, behind = motion.leap[column], motion.rate[column]
        motion.rate[column], motion.leap[column] = 0.5 * (before + behind), behind - before
    put_drive(motion.row, drive, point, max(point - 1, 0), body)


@kernel
def advance(motion: Motion, clock: Clock, drive: Drive, point: int, body: Body) -> None:
    """Carry the row from the grid point before to `point`, by one midpoint step over which what acts holds.

    clock: of the step that ends at `point`. From point 0 on, nothing moves.
    """
    time, length, fade = clock.time, clock.step, clock.fade
    row, trial, rate, leap, faded = motion.row, motion.trial, motion.rate, motion.leap, stack_array(4)
    if point > 0:
        put_drive(row, drive, point - 1, point - 1, body)
        _fade(motion, fade, faded, body)
    for stage in range(0 if point > 0 else AT_POINT, AT_POINT + 2):
        if stage == AT_POINT and point > 0:
            for column in range(STATE_SIZE):
                row[column] += length * rate[column]
            for column in range(4):
                body.parameters[FORCE + column] = faded[column]
        if stage >= AT_POINT:
            acting = max(point - 1, 0) if stage == AT_POINT else point
            put_drive(row, drive, acting, acting, body)
        for column in range(row.shape[0]):
            trial[column] = row[column]
        if stage == 1:
            for column in range(STATE_SIZE):
                trial[column] += 0.5 * length * rate[column]
        back = length if stage == 0 else 0.5 * length if stage == 1 else 0.0
        state_rate(trial, time - back, body, rate if stage != AT_POINT else leap)
    _compare(motion, drive, point, body)


@kernel
def responses(motion: Motion, time: float, body: Body, response: Floats) -> None:
    """Write the acceleration (4,) by unit of force or moment along each body axis [1/kg, 1/kg, 1/kg, 1/(kg m^2)].

    response (4 + 9,): what stands behind these is written for a vehicle whose axes are coupled alone.
    """
    row, rate = motion.row, motion.rate
    cosine, sine = NUDGE * math.cos(row[YAW]), NUDGE * math.sin(row[YAW])
    for nudged in range(2):
        if nudged == 1:
            body.parameters[PUSH_X], body.parameters[PUSH_Y] = cosine - sine, sine + cosine
            body.parameters[PUSH_Z], body.parameters[PUSH_YAW] = NUDGE, NUDGE
        state_rate(row, time, body, rate)
        for axis in range(4):
            response[axis] = (rate[SURGE + axis] - response[axis]) / (NUDGE if nudged == 1 else 1.0)
    for column in range(4):
        body.parameters[FORCE + column] = 0.0
    if body.active & COUPLING_BITS != 0:
        _coupled_responses(motion, time, body, response)


@kernel
def _coupled_responses(motion: Motion, time: float, body: Body, response: Floats) -> None:
    """Write the accelerations (3, 3) of surge, sway and yaw by unit of X, Y and N, flat, behind the first four."""
    row, rate, base = motion.row, motion.rate, motion.trial
    cosine, sine = NUDGE * math.cos(row[YAW]), NUDGE * math.sin(row[YAW])
    state_rate(row, time, body, base)
    for force in range(3):
        body.parameters[PUSH_X] = cosine if force == 0 else -sine if force == 1 else 0.0
        body.parameters[PUSH_Y] = sine if force == 0 else cosine if force == 1 else 0.0
        body.parameters[PUSH_YAW] = NUDGE if force == 2 else 0.0
        state_rate(row, time, body, rate)
        for answer in range(3):
            column = YAW_RATE if answer == 2 else SURGE + answer
            response[4 + 3 * answer + force] = (rate[column] - base[column]) / NUDGE
    for column in range(4):
        body.parameters[FORCE + column] = 0.0


@kernel
def _put_coupled_slopes(yaw: float, response: Floats, across: Floats) -> None:
    """Write the derivatives of surge, sway and yaw rate by the random force of a vehicle whose axes are coupled."""
    sine, cosine = math.sin(yaw), math.cos(yaw)
    for answer in range(3):
        by, at = 4 + 3 * answer, (HU + answer) * HORIZONTAL
        across[at + HFX] = response[by] * cosine - response[by + 1] * sine
        across[at + HFY] = response[by] * sine + response[by + 1] * cosine
        across[at + HN] = response[by + 2]


@kernel
def _put_force_slopes(yaw: float, response: Floats, across: Floats, upright: Floats) -> None:
    sine, cosine = math.sin(yaw), math.cos(yaw)
    across[HU * HORIZONTAL + HFX], across[HU * HORIZONTAL + HFY] = response[0] * cosine, response[0] * sine
    across[HV * HORIZONTAL + HFX], across[HV * HORIZONTAL + HFY] = -response[1] * sine, response[1] * cosine
    across[HR * HORIZONTAL + HN] = response[3]
    upright[VW * VERTICAL + VFZ] = response[2]


@kernel
def write_slopes(motion: Motion, time: float, body: Body, response: Floats, across: Floats, upright: Floats) -> None:
    """Write the derivative of the rates by the state, flat: `across` (6, HORIZONTAL) and `upright` (2, VERTICAL)."""
    row, rate, base = motion.row, motion.trial, motion.rate
    placed = body.flow.shape[0] > 0 or body.active & ~BASIC_BITS != 0
    for place in range(-1, STATE_SIZE):
        if X <= place <= Z and not placed:
            continue
        if place >= 0:
            kept = row[place]
            row[place] = kept + NUDGE
        state_rate(row, time, body, rate)
        if place < 0:
            for column in range(STATE_SIZE):
                base[column] = rate[column]
            continue
        row[place] = kept
        if place == Z or place == HEAVE:  # noqa: PLR1714
            column = VZ if place == Z else VW
            upright[VZ * VERTICAL + column] = (rate[Z] - base[Z]) / NUDGE
            upright[VW * VERTICAL + column] = (rate[HEAVE] - base[HEAVE]) / NUDGE
            continue
        column = place if place < Z else HR if place == YAW_RATE else place - 1
        across[HX * HORIZONTAL + column] = (rate[X] - base[X]) / NUDGE
        across[HY * HORIZONTAL + column] = (rate[Y] - base[Y]) / NUDGE
        across[HYAW * HORIZONTAL + column] = (rate[YAW] - base[YAW]) / NUDGE
        across[HU * HORIZONTAL + column] = (rate[SURGE] - base[SURGE]) / NUDGE
        across[HV * HORIZONTAL + column] = (rate[SWAY] - base[SWAY]) / NUDGE
        across[HR * HORIZONTAL + column] = (rate[YAW_RATE] - base[YAW_RATE]) / NUDGE
    _put_force_slopes(row[YAW], response, across, upright)
    if body.active & COUPLING_BITS != 0:
        _put_coupled_slopes(row[YAW], response, across)


@allocating_kernel
def run_free(drive: Drive, start: Floats, body: Body, grid: Grid, stretch: Stretch, push: Floats) -> Floats:
    """(points, 8) the course of the model alone over a stretch of the grid, from `start` (8,).

    push (points, 4): the random force that acts, world x, y, z [N] and moment [N m]; empty for none.
    """
    first, step = stretch.first, grid.step
    motion = make_motion(start, body)
    path = np.empty((stretch.points, STATE_SIZE))
    for point in range(stretch.points):
        if point > 0:
            if push.shape[0] > 0:
                body.parameters[FORCE : FORCE + 4] = push[point - 1]
            advance(motion, Clock(grid.begin + (first + point) * step, step, HELD), drive, first + point, body)
        path[point] = motion.row[:STATE_SIZE]
    return path
