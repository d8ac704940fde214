"""Coloured errors of readings: what is left in a reading of the error of the one before it.

Errors e of a kind with memory T are e = k e_before + w with k = exp(-gap / T) and w white, of variance
(1 - k^2) var(e). So the reading less k times the one before has a white error again, and the filter takes this
difference: it is expected to be h(x) - k h(x_before), where the state at the reading before follows from the present
one by the same Taylor series that leads from a grid point to a reading. The random force that came in between the two
is neglected in it. The first reading behind a hole is taken as it is.
Source: Bryson and Henrikson, J. Spacecraft and Rockets 5 (1968) 662.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.diagnosis.criteria.filter import FILTER
from cocorosim_ros.diagnosis.filter.motion import Motion
from cocorosim_ros.diagnosis.filter.reading import deviation, expected, is_upright, sensitivity, sensitivity_upright
from cocorosim_ros.diagnosis.filter.records import Rates, Readings, When
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel, outlined_kernel
from cocorosim_ros.foundation.compiling.stack import stack_array, unset_stack_array
from cocorosim_ros.world.state.state import SURGE
from cocorosim_ros.world.terms.blocks import HORIZONTAL, VERTICAL
from cocorosim_ros.world.terms.motors import Motors

FORGOTTEN = FILTER.forgotten


@allocating_kernel
def shares_left(readings: Readings, memory: Floats) -> Floats:
    """Share k (m,) of the error of the reading before that is still in each; 0 where errors are white.

    memory (KINDS,): correlation time of the errors of readings of each kind [s].
    """
    left = np.zeros(readings.kind.shape[0])
    for index in range(left.shape[0]):
        memory_of_kind = memory[readings.kind[index]]
        if readings.before[index] >= 0 and not readings.gap[index] > FORGOTTEN * memory_of_kind:
            left[index] = math.exp(-readings.gap[index] / memory_of_kind)
    return left


@outlined_kernel
def _error_before(
    readings: Readings, index: int, row: Floats, rates: Rates, sensor: Floats, water: Floats, motors: Motors
) -> float:
    """Error of the reading of the same kind before this one, as the state at the grid point of this one has it."""
    kind, earlier = readings.kind[index], readings.before[index]
    after = readings.after[index] - readings.gap[index]
    when = When(readings.stamp[earlier], after, abs(after), math.copysign(1.0, after))
    behind, level, passed = unset_stack_array(8), stack_array(8), unset_stack_array(4)
    for column in range(8):  # forces change at grid points: the rates before this one led here
        behind[column] = rates.mean[column] - 0.5 * rates.leap[column]
    for column in range(4):  # readings of it are taken as if at their grid point
        passed[column] = water[column] - readings.gap[index] * behind[SURGE + column]
    shown = expected(kind, when, row, Rates(behind, level), sensor, passed, motors)
    error: float = deviation(kind, readings.value[earlier], shown)
    return error


@kernel
def error_left(
    readings: Readings, index: int, left: float, motion: Motion, sensor: Floats, water: Floats, motors: Motors
) -> float:
    """Part of this reading's error that the one before had: its share `left` times that error."""
    if left == 0.0:
        return 0.0
    rates = Rates(motion.rate, motion.leap)
    error: float = left * _error_before(readings, index, motion.row, rates, sensor, water, motors)
    return error


@outlined_kernel
def take_off_before(
    readings: Readings, index: int, left: float, row: Floats, sensor: Floats, slope: Floats, seen: Floats
) -> None:
    """Take `left` times the derivative of the reading before by the state off that of this one, `seen` (12,).

    slope: of the block of the state that the reading belongs to, as `sensitivity` takes it.
    """
    kind, after = readings.kind[index], readings.after[index] - readings.gap[index]
    earlier = unset_stack_array(12)
    if is_upright(kind):
        sensitivity_upright(kind, after, row, sensor, slope, earlier)
    else:
        sensitivity(kind, after, row, sensor, slope, earlier)
    for column in range(VERTICAL if is_upright(kind) else HORIZONTAL):
        seen[column] -= left * earlier[column]
