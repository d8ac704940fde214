"""Passes of the filter under many sets of noise at once, four in a vector, close to a pass that is known.

Sets that are hardly different lead along hardly different courses. So the motion and its slopes are those of the known
pass, and what a set of noise adds is carried to first order: by how much its mean is off, with a covariance of its own.
A reading counts as doubted, or as half a turn off, where it does in the known pass.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.diagnosis.filter.coloured import error_before, error_left, take_off_before
from cocorosim_ros.diagnosis.filter.correction import correct
from cocorosim_ros.diagnosis.filter.covariance import GATE
from cocorosim_ros.diagnosis.filter.filter import relative_velocity
from cocorosim_ros.diagnosis.filter.four_blocks import (
    Sight,
    carry_level,
    carry_upright,
    innovation_off,
    see_level,
    see_upright,
    transition_of_motion,
)
from cocorosim_ros.diagnosis.filter.layout import CORRELATION, SMOOTHNESS
from cocorosim_ros.diagnosis.filter.motion import (
    FORCE,
    Clock,
    Motion,
    advance,
    put_drive,
    responses,
    write_slopes,
)
from cocorosim_ros.diagnosis.filter.noise_sets import (
    Beliefs,
    Known,
    Noises,
    Space,
    covariances_of,
    fading_of,
    level_block,
    noises_in_fours,
    space_in_fours,
    upright_block,
)
from cocorosim_ros.diagnosis.filter.random_force import fading
from cocorosim_ros.diagnosis.filter.reading import (
    certainty_of_turn,
    deviation,
    expected,
    is_angle,
    is_of_water,
    is_upright,
    sensitivity,
    sensitivity_upright,
)
from cocorosim_ros.diagnosis.filter.records import Drive, Rates, Readings, Start, When
from cocorosim_ros.diagnosis.filter.spread_of_state import (
    NewVariance,
    add_force,
    let_wander,
    put_start,
    swollen,
)
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import everywhere, four, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel, outlined_kernel
from cocorosim_ros.foundation.compiling.stack import stack_array, stack_like
from cocorosim_ros.world.terms.blocks import HFX, HGX, HORIZONTAL, VERTICAL, VFZ
from cocorosim_ros.world.terms.motors import Motors
from cocorosim_ros.world.vehicle_model.vehicles import Body


class _Reading(NamedTuple):
    """A reading: its place in the order of the grid, that in the order of the track, and its kind."""

    place: int
    origin: int
    kind: int


@kernel
def _put_push(motion: Motion, body: Body, space: Space) -> None:
    """Write random forces and gusts of the known pass to where the blocks look for them."""
    level, upright = space.level_push, space.upright_push
    for place in range(3):
        column = 3 if place == 2 else place
        level[place], level[3 + place] = body.parameters[FORCE + column], motion.gust[column]
    upright[0], upright[1] = body.parameters[FORCE + 2], motion.gust[2]


@kernel
def _carry(motion: Motion, clock: Clock, body: Body, space: Space, noises: Noises, point: int) -> None:
    """Carry all blocks over the step that ends at a point of the grid; the motion still stands at the step's begin."""
    write_slopes(motion, clock.time - clock.step, body, space.response, space.level_slope, space.upright_slope)
    transition_of_motion(space.level_slope, HORIZONTAL, clock.step, HFX, HGX - HFX, space.level_ahead)
    transition_of_motion(space.upright_slope, VERTICAL, clock.step, VFZ, 1, space.upright_ahead)
    _put_push(motion, body, space)
    for group in range(space.fade.shape[0]):
        fade = fading_of(space, group)
        carry_level(level_block(space, group), fade, clock.fade)
        carry_upright(upright_block(space, group), fade, clock.fade)
        both, noise = covariances_of(space, group), noises.random_force[group]
        grown = NewVariance(fade.new_force, fade.new_common, fade.new_gust)
        add_force(both, noise, swollen(grown, noises.swell[group], point - 1))
        let_wander(both, noise, clock.step)


@kernel
def _turn_kept(
    readings: Readings, reading: _Reading, motion: Motion, known: Known, water: Floats, motors: Motors
) -> float:
    """Share of its pull that an angle keeps in the known pass (`certainty_of_turn`); 1 for all other readings."""
    kind, index = reading.kind, reading.place
    if not is_angle(kind):
        return 1.0
    innovation = known.past.innovation[reading.origin]
    if not known.past.believed[reading.origin]:  # it was cut at the gate
        when = When(readings.stamp[index], readings.after[index], readings.apart[index], readings.side[index])
        shown = expected(kind, when, motion.row, Rates(motion.rate, motion.leap), known.sensor, water, motors)
        innovation = deviation(kind, readings.value[index], shown)
        innovation -= error_left(readings, index, known.left[index], motion, known.sensor, water, motors)
    kept: float = certainty_of_turn(kind, innovation)
    return kept


@kernel
def _look(readings: Readings, reading: _Reading, motion: Motion, known: Known, space: Space) -> Sight:
    """How a reading whose error is white depends on its block."""
    kind, after, plain = reading.kind, readings.after[reading.place], stack_array(12)
    if is_upright(kind):
        sensitivity_upright(kind, after, motion.row, known.sensor, space.upright_slope, plain)
    else:
        sensitivity(kind, after, motion.row, known.sensor, space.level_slope, plain)
    count = 0
    for column in range(VERTICAL if is_upright(kind) else HORIZONTAL):
        space.felt[count], space.seen[count] = column, plain[column]
        count += plain[column] != 0.0
    return Sight(space.seen, space.felt, count)


@kernel
def _look_back(
    readings: Readings, reading: _Reading, motion: Motion, known: Known, space: Space, left: Floats
) -> Sight:
    """`_look` at a reading in which a share `left` (a four) of the error of the one before it is still left."""
    kind, whole = reading.kind, stack_like(space.seen, 12)
    count = _look(readings, reading, motion, known, space).columns
    for place in range(count):
        whole[space.felt[place]] = space.seen[place]
    slope = space.upright_slope if is_upright(kind) else space.level_slope
    take_off_before(readings, reading.place, left, motion.row, known.sensor, slope, whole)
    count = 0
    for column in range(VERTICAL if is_upright(kind) else HORIZONTAL):
        space.felt[count], space.seen[count] = column, whole[column]
        count += 0 if everywhere(abs(whole[column]) <= 0.0) else 1
    return Sight(space.seen, space.felt, count)


@kernel
def _begin(start: Start, noises: Noises, space: Space) -> None:
    """Write the covariances at grid point 0."""
    one = four(1.0, 1.0, 1.0, 1.0)
    for group in range(space.fade.shape[0]):
        both = covariances_of(space, group)
        put_start(both.wide, both.high, start.spread)
        begun = NewVariance(one, fading_of(space, group).common, one)
        add_force(both, noises.random_force[group], swollen(begun, noises.swell[group], 0))


@outlined_kernel
def passes_beside(
    readings: Readings, drive: Drive, start: Start, motion: Motion, body: Body, known: Known, sets: Noises,
    work: Space, found: Beliefs,
) -> None:  # fmt: skip
    """Run the filter under sets of noise that are close to that of a known pass; results are in `found`.

    motion: as `make_motion` makes it at the start; work: as `make_space` makes it.
    """
    noises, space = noises_in_fours(sets), space_in_fours(work)
    innovations, variances = in_fours(found.innovation), in_fours(found.variance)
    _begin(start, noises, space)
    row, past, water = motion.row, known.past, stack_array(4)
    motors = Motors(body.is_pump, body.actuator_curve, body.actuator_limit)
    fade = fading(readings.step, known.random_force[CORRELATION], known.random_force[SMOOTHNESS])
    gain, rates, is_coloured = stack_like(space.seen, 12), Rates(motion.rate, motion.leap), noises.left.shape[1] > 0
    responses(motion, readings.begin, body, space.response)
    for point in range(readings.first.shape[0] - 1):
        time = readings.begin + point * readings.step
        clock = Clock(time, readings.step, fade)
        if point > 0:
            put_drive(row, drive, point - 1, point - 1, body)
            _carry(motion, clock, body, space, noises, point)
        advance(motion, clock, drive, point, body)
        for index in range(readings.first[point], readings.first[point + 1]):
            kind, origin = readings.kind[index], readings.origin[index]
            reading, upright = _Reading(index, origin, kind), is_upright(kind)
            if is_of_water(kind):
                relative_velocity(row, time, body, water)
            kept = _turn_kept(readings, reading, motion, known, water, motors)
            sight, lasts = _look(readings, reading, motion, known, space), is_coloured and readings.before[index] >= 0
            before = error_before(readings, index, row, rates, known.sensor, water, motors) if lasts else 0.0
            for group in range(space.fade.shape[0]):
                block = upright_block(space, group) if upright else level_block(space, group)
                variance = noises.reading_variance[group, kind] * readings.share[index]
                innovation = past.innovation[origin] + 0.0 * variance
                if lasts:
                    left = noises.left[group, index]
                    sight = _look_back(readings, reading, motion, known, space, left)
                    innovation -= (left - known.left[index]) * before
                    variance *= 1.0 - left * left
                innovation = innovation_off(block, sight, innovation)
                doubted = kept < 1.0 or not past.believed[origin]
                if upright:
                    variance = see_upright(block, sight, variance, gain, doubted)
                else:
                    variance = see_level(block, sight, variance, gain, doubted)
                if not past.believed[origin]:
                    innovation = math.copysign(GATE, past.innovation[origin]) * math.sqrt(variance)
                innovations[group, origin], variances[group, origin] = innovation, variance
                for column in range(VERTICAL if upright else HORIZONTAL):
                    block.off[column] += kept * gain[column] * innovation
                    block.off[column] -= past.gain[origin, column] * past.innovation[origin]
            correct(motion, body, kind, past.gain[origin], past.innovation[origin])
