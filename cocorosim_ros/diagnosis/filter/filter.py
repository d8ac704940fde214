"""Continuous-discrete extended Kalman filter of one robot: the likelihood of a recording under a model.

State: pose, velocity through `state_rate` of the simulator, and the random force of the water on surge and sway (in
world axes), heave and yaw, each with the gust that drives it. The mean is carried by midpoint steps, the
covariance to second order in the step, in two blocks (horizontal and vertical) that are taken as independent of each
other. Readings between two steps are predicted by a Taylor series from the nearer one. A reading beyond GATE pulls as
one at the gate would (Huber's function): were it left out, a model in error would lose its robot for good, at a moment
that hangs on its numbers, and the likelihood would jump.

Source: Kristensen, Madsen and Jorgensen, Automatica 40 (2004) 225; Jazwinski, Stochastic Processes and Filtering
Theory (1970), section 8.3; Masreliez and Martin, IEEE Trans. Automatic Control 22 (1977) 361.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

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
from cocorosim_ros.diagnosis.filter.layout import CORRELATION, FORCE_XY, FORCE_Z, MOMENT_YAW, SMOOTHNESS
from cocorosim_ros.diagnosis.filter.motion import (
    FORCE,
    Motion,
    advance,
    make_motion,
    put_drive,
    responses,
    write_slopes,
)
from cocorosim_ros.diagnosis.filter.random_force import Fading, fading
from cocorosim_ros.diagnosis.filter.reading import (
    deviation,
    expected,
    is_of_water,
    is_upright,
    sensitivity,
    sensitivity_upright,
)
from cocorosim_ros.diagnosis.filter.records import Belief, Drive, History, Past, Readings
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel, outlined_kernel, stack_array
from cocorosim_ros.world.motion import dynamics
from cocorosim_ros.world.state.state import HEAVE, STATE_SIZE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.blocks import (
    HFX,
    HFY,
    HN,
    HORIZONTAL,
    VERTICAL,
    VFZ,
    VW,
)  # fmt: skip
from cocorosim_ros.world.vehicle_model.vehicles import Body


class Spread(NamedTuple):
    """The covariance and how it moves: slopes, transitions, all flat."""

    wide: Floats  # (HORIZONTAL, HORIZONTAL)
    wide_slope: Floats  # (HFX, HORIZONTAL)
    wide_step: Floats  # (HORIZONTAL, HORIZONTAL)
    back: Floats  # (HORIZONTAL, HORIZONTAL) transpose of wide_step
    high: Floats  # (VERTICAL, VERTICAL)
    high_slope: Floats  # (VFZ, VERTICAL)
    high_step: Floats  # (VERTICAL, VERTICAL)
    response: Floats  # (4,) acceleration by unit of force


@allocating_kernel
def _make_spread(deviation: Floats, noise: Floats, fade: Fading) -> Spread:
    """As the standard deviation of the state (8,) and the random force (WATER_NOISE) have it."""
    wide, high = np.zeros(HORIZONTAL * HORIZONTAL), np.zeros(VERTICAL * VERTICAL)
    places = (X, Y, YAW, SURGE, SWAY, YAW_RATE)
    for i in range(6):
        wide[i * HORIZONTAL + i] = deviation[places[i]] ** 2
    high[0], high[VW * VERTICAL + VW] = deviation[Z] ** 2, deviation[HEAVE] ** 2
    size = HORIZONTAL * HORIZONTAL
    parts = Spread(
        wide,
        np.zeros(HFX * HORIZONTAL),
        np.zeros(size),
        np.zeros(size),
        high,
        np.zeros(VFZ * VERTICAL),
        np.zeros(VERTICAL * VERTICAL),
        np.zeros(4),
    )
    _add_force(parts, noise, (1.0, fade.common, 1.0))
    return parts


@kernel
def _add_pair(matrix: Floats, at: int, size: int, apart: int, rms: float, new: tuple[float, float, float]) -> None:
    """Let variance into the force that stands at `at` of a matrix (size, size), and into its gust, `apart` further."""
    force, both, gust = new
    other = at + apart
    matrix[at * size + at] += rms * rms * force
    matrix[at * size + other] += rms * rms * both
    matrix[other * size + at] += rms * rms * both
    matrix[other * size + other] += rms * rms * gust


@kernel
def _add_force(parts: Spread, noise: Floats, new: tuple[float, float, float]) -> None:
    """Let variance into the random forces; new: of force, of both and of gust, for an rms of 1."""
    _add_pair(parts.wide, HFX, HORIZONTAL, 3, noise[FORCE_XY], new)
    _add_pair(parts.wide, HFY, HORIZONTAL, 3, noise[FORCE_XY], new)
    _add_pair(parts.wide, HN, HORIZONTAL, 3, noise[MOMENT_YAW], new)
    _add_pair(parts.high, VFZ, VERTICAL, 1, noise[FORCE_Z], new)


@outlined_kernel
def relative_velocity(row: Floats, time: float, body: Body, relative: Floats) -> None:
    """`dynamics.relative_velocity`, out of line."""
    dynamics.relative_velocity(row, time, body, relative)


@kernel
def _remember(motion: Motion, body: Body, parts: Spread, point: int, history: History) -> None:
    """Write down what is believed before the readings of a grid point."""
    _keep_mean(motion, body, history.before[point])
    _keep_wide(parts.wide, history.wide_before[point])
    _keep_wide(parts.wide_step, history.wide_step[point])
    for i in range(VERTICAL):
        for j in range(VERTICAL):
            history.high_before[point, i, j] = parts.high[i * VERTICAL + j]
            history.high_step[point, i, j] = parts.high_step[i * VERTICAL + j]


@kernel
def _remember_after(motion: Motion, body: Body, parts: Spread, point: int, history: History) -> None:
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
def _move(
    motion: Motion, parts: Spread, clock: tuple[float, float, Fading], drive: Drive, point: int, body: Body
) -> None:
    """Carry mean and covariance from the grid point before to `point`, without what the random force adds."""
    time, step, fade = clock
    if point > 0:
        put_drive(motion.row, drive, point - 1, point - 1, body)
        write_slopes(motion, time - step, body, parts.response, parts.wide_slope, parts.high_slope)
        transition(parts.wide_slope, step, fade, parts.wide_step, parts.back)
        transition_upright(parts.high_slope, step, fade, parts.high_step)
        spread(parts.wide, parts.wide_step, parts.back)
        spread_upright(parts.high, parts.high_step)
    advance(motion, clock, drive, point, body)


@outlined_kernel
def _filter(
    readings: Readings, drive: Drive, motion: Motion, parts: Spread, body: Body, numbers: tuple[Floats, Floats, Floats],
    belief: Belief,
) -> None:  # fmt: skip
    sensor, noise, reading_variance = numbers
    row, seen, gain, water = motion.row, stack_array(12), stack_array(12), stack_array(4)
    fade = fading(readings.step, noise[CORRELATION], noise[SMOOTHNESS])
    grown = fade.new_force, fade.new_common, fade.new_gust
    keep = belief.history.after.shape[0] > 0
    responses(motion, readings.begin, body, parts.response)
    for point in range(readings.first.shape[0] - 1):
        time = readings.begin + point * readings.step
        _move(motion, parts, (time, readings.step, fade), drive, point, body)
        if point > 0:
            _add_force(parts, noise, grown)
        if keep:
            _remember(motion, body, parts, point, belief.history)
        for index in range(readings.first[point], readings.first[point + 1]):
            kind, after, origin = readings.kind[index], readings.after[index], readings.origin[index]
            if is_of_water(kind):
                relative_velocity(row, time, body, water)
            when = readings.stamp[index], after, readings.apart[index], readings.side[index]
            shown = expected(kind, when, row, (motion.rate, motion.leap), sensor, water)
            innovation = deviation(kind, readings.value[index], shown)
            variance = reading_variance[kind] * readings.share[index]
            if is_upright(kind):
                sensitivity_upright(kind, after, row, sensor, parts.high_slope, seen)
                variance = update_upright(parts.high, seen, variance, gain, innovation * innovation)
            else:
                sensitivity(kind, after, row, sensor, parts.wide_slope, seen)
                variance = update(parts.wide, seen, variance, gain, innovation * innovation)
            if innovation * innovation > GATE * GATE * variance:
                innovation = math.copysign(GATE * math.sqrt(variance), innovation)
            belief.innovation[origin], belief.variance[origin] = innovation, variance
            for column in range(VERTICAL if is_upright(kind) else HORIZONTAL):
                belief.gain[origin, column] = gain[column]
            correct(motion, body, kind, gain, innovation)
        if keep:
            _remember_after(motion, body, parts, point, belief.history)


@allocating_kernel
def filter_pass(
    readings: Readings, drive: Drive, start: Floats, body: Body, numbers: tuple[Floats, Floats, Floats], belief: Belief
) -> None:
    """The whole filter over a recording.

    start (2, 8): state at grid point 0 and its standard deviation. numbers: the sensors' (SENSOR_COLUMNS), the random
    force's (WATER_NOISE) and the variance of a single reading of each kind (KINDS,). Results are in `belief`.
    """
    fade = fading(readings.step, numbers[1][CORRELATION], numbers[1][SMOOTHNESS])
    parts = _make_spread(start[1], numbers[1], fade)
    _filter(readings, drive, make_motion(start[0], body), parts, body, numbers, belief)


@outlined_kernel
def _slope(
    readings: Readings, drive: Drive, motion: Motion, body: Body, numbers: tuple[Floats, Fading, float], past: Past,
    slope: Floats,
) -> None:  # fmt: skip
    sensor, fade, step = numbers
    row, water = motion.row, stack_array(4)
    for point in range(readings.first.shape[0] - 1):
        time = readings.begin + point * readings.step
        advance(motion, (time, readings.step, fade), drive, point, body)
        for index in range(readings.first[point], readings.first[point + 1]):
            kind, origin = readings.kind[index], readings.origin[index]
            if is_of_water(kind):
                relative_velocity(row, time, body, water)
            when = readings.stamp[index], readings.after[index], readings.apart[index], readings.side[index]
            shown = expected(kind, when, row, (motion.rate, motion.leap), sensor, water)
            # What is not believed pulls as far as it may, whatever the model.
            innovation, slope[origin] = past.innovation[origin], 0.0
            if past.believed[origin]:
                innovation = deviation(kind, readings.value[index], shown)
                slope[origin] = deviation(kind, innovation, past.innovation[origin]) / step
            correct(motion, body, kind, past.gain[origin], innovation)


@allocating_kernel
def slope_pass(
    readings: Readings,
    drive: Drive,
    start: Floats,
    body: Body,
    numbers: tuple[Floats, Floats, float],
    past: Past,
    slope: Floats,
) -> None:
    """The filter with the gains of another pass, its mean alone, at a fraction of the cost.

    numbers: the sensors', the random force's (WATER_NOISE), and by how much the numbers of this pass differ from those
    of the past one. Writes (m,) the change of the innovations over that: what a number explains. 0 where not believed.
    """
    sensor, noise, step = numbers
    fade = fading(readings.step, noise[CORRELATION], noise[SMOOTHNESS])
    _slope(readings, drive, make_motion(start, body), body, (sensor, fade, step), past, slope)
