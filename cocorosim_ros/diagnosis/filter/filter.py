"""Continuous-discrete extended Kalman filter of one robot: the likelihood of a recording under a model.

State: pose, velocity through `state_rate` of the simulator, and the random force of the water on surge and sway (in
world axes), heave and yaw, each with the gust that drives it. The mean is carried by midpoint steps, the
covariance to second order in the step, in two blocks (horizontal and vertical) that are taken as independent of each
other. Readings between two steps are predicted by a Taylor series from the nearer one. A reading beyond GATE pulls as
one at the gate would (Huber's function): without its pull, a model in error would lose its robot for good, at a moment
that depends on the model's numbers, and the likelihood would jump. For the same reason an angle that is more than a
quarter turn off pulls less, and nothing at half a turn.

Source: Kristensen, Madsen and Jorgensen, Automatica 40 (2004) 225; Jazwinski, Stochastic Processes and Filtering
Theory (1970), section 8.3; Masreliez and Martin, IEEE Trans. Automatic Control 22 (1977) 361.
"""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.filter.coloured import error_left, take_off_before
from cocorosim_ros.diagnosis.filter.correction import correct
from cocorosim_ros.diagnosis.filter.covariance import (
    GATE,
    spread,
    spread_upright,
    transition,
    transition_upright,
    update,
    update_upright,
)
from cocorosim_ros.diagnosis.filter.layout import CORRELATION, SMOOTHNESS
from cocorosim_ros.diagnosis.filter.motion import (
    FORCE,
    Clock,
    Motion,
    advance,
    make_motion,
    put_drive,
    responses,
    write_slopes,
)
from cocorosim_ros.diagnosis.filter.random_force import fading
from cocorosim_ros.diagnosis.filter.reading import (
    certainty_of_turn,
    deviation,
    expected,
    is_of_water,
    is_upright,
    sensitivity,
    sensitivity_upright,
)
from cocorosim_ros.diagnosis.filter.records import (
    Belief,
    Drive,
    History,
    PassNumbers,
    Past,
    Rates,
    Readings,
    SlopeNumbers,
    Start,
    When,
)
from cocorosim_ros.diagnosis.filter.spread_of_state import (
    NewVariance,
    Spread,
    add_force,
    let_wander,
    make_spread,
    swollen,
)
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel, outlined_kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.motion import dynamics
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.terms.blocks import HORIZONTAL, VERTICAL
from cocorosim_ros.world.terms.motors import Motors
from cocorosim_ros.world.vehicle_model.vehicles import Body


@outlined_kernel
def relative_velocity(row: Floats, time: float, body: Body, relative: Floats) -> None:
    """`dynamics.relative_velocity`, out of line."""
    dynamics.relative_velocity(row, time, body, relative)


@kernel
def _remember(motion: Motion, body: Body, parts: Spread, point: int, history: History) -> None:
    """Write mean and covariance before the readings of a grid point into `history`."""
    _keep_mean(motion, body, history.before[point])
    _keep_wide(parts.wide, history.wide_before[point])
    _keep_wide(parts.wide_step, history.wide_step[point])
    for i in range(VERTICAL):
        for j in range(VERTICAL):
            history.high_before[point, i, j] = parts.high[i * VERTICAL + j]
            history.high_step[point, i, j] = parts.high_step[i * VERTICAL + j]


@kernel
def _remember_after(motion: Motion, body: Body, parts: Spread, point: int, history: History) -> None:
    """Write mean and covariance after the readings of a grid point into `history`."""
    _keep_mean(motion, body, history.after[point])
    _keep_wide(parts.wide, history.wide_after[point])
    for i in range(VERTICAL):
        for j in range(VERTICAL):
            history.high_after[point, i, j] = parts.high[i * VERTICAL + j]


@kernel
def _keep_wide(flat: Floats, kept: Floats) -> None:
    for i in range(HORIZONTAL):
        for j in range(HORIZONTAL):
            kept[i, j] = flat[i * HORIZONTAL + j]


@kernel
def _keep_mean(motion: Motion, body: Body, mean: Floats) -> None:
    for column in range(STATE_SIZE):
        mean[column] = motion.row[column]
    for column in range(4):
        mean[STATE_SIZE + column] = body.parameters[FORCE + column]
        mean[STATE_SIZE + 4 + column] = motion.gust[column]


@kernel
def _move(motion: Motion, parts: Spread, clock: Clock, drive: Drive, point: int, body: Body) -> None:
    """Carry mean and covariance from the grid point before to `point`, without what the random force adds."""
    step, fade = clock.step, clock.fade
    if point > 0:
        put_drive(motion.row, drive, point - 1, point - 1, body)
        write_slopes(motion, clock.time - step, body, parts.response, parts.wide_slope, parts.high_slope)
        transition(parts.wide_slope, step, fade, parts.wide_step, parts.back)
        transition_upright(parts.high_slope, step, fade, parts.high_step)
        spread(parts.wide, parts.wide_step, parts.back)
        spread_upright(parts.high, parts.high_step)
    advance(motion, clock, drive, point, body)


@outlined_kernel
def _filter(
    readings: Readings, drive: Drive, motion: Motion, parts: Spread, body: Body, numbers: PassNumbers,
    belief: Belief,
) -> None:  # fmt: skip
    sensor, noise, reading_variance = numbers.sensor, numbers.random_force, numbers.reading_variance
    row, seen, gain, water = motion.row, stack_array(12), stack_array(12), stack_array(4)
    motors = Motors(body.is_pump, body.actuator_curve, body.actuator_limit)
    fade = fading(readings.step, noise[CORRELATION], noise[SMOOTHNESS])
    grown = NewVariance(fade.new_force, fade.new_common, fade.new_gust)
    keep, keep_gain = belief.history.after.shape[0] > 0, belief.gain.shape[0] > 0
    responses(motion, readings.begin, body, parts.response)
    for point in range(readings.first.shape[0] - 1):
        time = readings.begin + point * readings.step
        _move(motion, parts, Clock(time, readings.step, fade), drive, point, body)
        if point > 0:
            add_force(parts, noise, swollen(grown, numbers.swell, point - 1))
            let_wander(parts, noise, readings.step)
        if keep:
            _remember(motion, body, parts, point, belief.history)
        for index in range(readings.first[point], readings.first[point + 1]):
            kind, after, origin = readings.kind[index], readings.after[index], readings.origin[index]
            if is_of_water(kind):
                relative_velocity(row, time, body, water)
            when = When(readings.stamp[index], after, readings.apart[index], readings.side[index])
            shown = expected(kind, when, row, Rates(motion.rate, motion.leap), sensor, water, motors)
            innovation = deviation(kind, readings.value[index], shown)
            variance = reading_variance[kind] * readings.share[index]
            left = numbers.left[index]
            innovation -= error_left(readings, index, left, motion, sensor, water, motors)
            variance *= 1.0 - left * left
            certain = certainty_of_turn(kind, innovation)
            if is_upright(kind):
                sensitivity_upright(kind, after, row, sensor, parts.high_slope, seen)
                if left > 0.0:
                    take_off_before(readings, index, left, row, sensor, parts.high_slope, seen)
                variance = update_upright(parts.high, seen, variance, gain, innovation * innovation)
            else:
                sensitivity(kind, after, row, sensor, parts.wide_slope, seen)
                if left > 0.0:
                    take_off_before(readings, index, left, row, sensor, parts.wide_slope, seen)
                squared = innovation * innovation if certain == 1.0 else math.inf
                variance = update(parts.wide, seen, variance, gain, squared)
                for column in range(0 if certain == 1.0 else HORIZONTAL):
                    gain[column] *= certain
            if innovation * innovation > GATE * GATE * variance:
                innovation = math.copysign(GATE * math.sqrt(variance), innovation)
            belief.innovation[origin], belief.variance[origin] = innovation, variance
            for column in range(0 if not keep_gain else VERTICAL if is_upright(kind) else HORIZONTAL):
                belief.gain[origin, column] = gain[column]
            correct(motion, body, kind, gain, innovation)
        if keep:
            _remember_after(motion, body, parts, point, belief.history)


def filter_pass(
    readings: Readings, drive: Drive, start: Start, body: Body, numbers: PassNumbers, belief: Belief
) -> None:
    """The whole filter over a recording; results are in `belief`.

    Not compiled itself: a compiled function that called the filter would hold all of it once more.
    """
    noise = numbers.random_force
    fade = fading(readings.step, noise[CORRELATION], noise[SMOOTHNESS])
    parts = make_spread(start.spread, noise, swollen(NewVariance(1.0, fade.common, 1.0), numbers.swell, 0))
    _filter(readings, drive, make_motion(start.mean, body), parts, body, numbers, belief)


@outlined_kernel
def _slope(
    readings: Readings, drive: Drive, motion: Motion, body: Body, numbers: SlopeNumbers, past: Past, slope: Floats,
) -> None:  # fmt: skip
    sensor, noise, step = numbers.sensor, numbers.random_force, numbers.step
    fade = fading(readings.step, noise[CORRELATION], noise[SMOOTHNESS])
    row, water = motion.row, stack_array(4)
    motors = Motors(body.is_pump, body.actuator_curve, body.actuator_limit)
    for point in range(readings.first.shape[0] - 1):
        time = readings.begin + point * readings.step
        advance(motion, Clock(time, readings.step, fade), drive, point, body)
        for index in range(readings.first[point], readings.first[point + 1]):
            kind, origin = readings.kind[index], readings.origin[index]
            if is_of_water(kind):
                relative_velocity(row, time, body, water)
            when = When(readings.stamp[index], readings.after[index], readings.apart[index], readings.side[index])
            shown = expected(kind, when, row, Rates(motion.rate, motion.leap), sensor, water, motors)
            # A reading beyond the gate pulls by the same amount under every model.
            innovation, slope[origin] = past.innovation[origin], 0.0
            if past.believed[origin]:
                innovation = deviation(kind, readings.value[index], shown)
                left = numbers.left[index]
                innovation -= error_left(readings, index, left, motion, sensor, water, motors)
                slope[origin] = deviation(kind, innovation, past.innovation[origin]) / step
            correct(motion, body, kind, past.gain[origin], innovation)


@allocating_kernel
def slope_pass(
    readings: Readings,
    drive: Drive,
    start: Floats,
    body: Body,
    numbers: SlopeNumbers,
    past: Past,
    slope: Floats,
) -> None:
    """Run the mean of the filter alone, with the gains of another pass, at a fraction of the cost.

    start (8,). Writes (m,) the change of the innovations over the step by which a number of this pass differs from that
    of the past one: what the number explains. 0 where not believed.
    """
    _slope(readings, drive, make_motion(start, body), body, numbers, past, slope)
