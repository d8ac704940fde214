"""The covariance of the filter, which spreads from step to step and shrinks with each reading.

Matrices are flat. Rows of the horizontal ones are three vectors of four.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.filter import FILTER
from cocorosim_ros.diagnosis.filter.random_force import Fading
from cocorosim_ros.diagnosis.filter.row_sums import set_sum_of_rows, take_off_products
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import add_four, stack_array, unset_stack_array
from cocorosim_ros.world.terms.blocks import HFX, HGX, HORIZONTAL, VERTICAL, VFZ, VGZ

GATE = FILTER.gate
"""The gate [standard deviations], by a name that compiled functions can see."""


@kernel
def _add_row(target: Floats, at: int, source: Floats, first: int, factor: float) -> None:
    """target[at : at + HORIZONTAL] += factor * source[first : first + HORIZONTAL]."""
    add_four(target, np.uint64(at), source, np.uint64(first), factor)
    add_four(target, np.uint64(at + 4), source, np.uint64(first + 4), factor)
    add_four(target, np.uint64(at + 8), source, np.uint64(first + 8), factor)


@kernel
def _set_four(target: Floats, at: int, factors: Floats, begin: int, source: Floats, first: int) -> None:
    """target[at : at + 4] = factors[begin : begin + HORIZONTAL] times four columns of `source`, from `first` on."""
    set_sum_of_rows(target, at, factors, begin, source, first, 12, 12)


@kernel
def _set_last_four(target: Floats, at: int, factors: Floats, begin: int, source: Floats, first: int) -> None:
    """`_set_four` with the last six rows of `source` alone."""
    set_sum_of_rows(target, at, factors, begin, source, first, 12, 6)


@kernel
def transition(slope: Floats, step: float, fade: Fading, ahead: Floats, back: Floats) -> None:
    """ahead = exp(slope step) to second order, back its transpose.

    The random force fades without the other states, and acts by its mean over the step.
    slope (HFX, HORIZONTAL), ahead and back (HORIZONTAL, HORIZONTAL).
    """
    for i in range(HFX):
        for j in range(HORIZONTAL):
            ahead[i * HORIZONTAL + j] = step * slope[i * HORIZONTAL + j]
        for k in range(HFX):
            factor = 0.5 * step * step * slope[i * HORIZONTAL + k]
            if factor != 0.0:
                _add_row(ahead, i * HORIZONTAL, slope, k * HORIZONTAL, factor)
        for j in range(HFX, HGX):
            ahead[i * HORIZONTAL + j + 3] = 0.5 * fade.fed * ahead[i * HORIZONTAL + j]
            ahead[i * HORIZONTAL + j] *= 0.5 * (1.0 + fade.kept)
        ahead[i * HORIZONTAL + i] += 1.0
    for i in range(HFX, HGX):
        ahead[i * HORIZONTAL + i] = fade.kept
        ahead[i * HORIZONTAL + i + 3] = fade.fed
        ahead[(i + 3) * HORIZONTAL + i + 3] = fade.gust
    for i in range(HORIZONTAL):
        for j in range(HORIZONTAL):
            back[j * HORIZONTAL + i] = ahead[i * HORIZONTAL + j]


@kernel
def spread(covariance: Floats, ahead: Floats, back: Floats) -> None:
    """covariance = ahead covariance back, all (HORIZONTAL, HORIZONTAL)."""
    work = stack_array(144)
    for i in range(HFX):
        for k in range(HORIZONTAL):
            factor = ahead[i * HORIZONTAL + k]
            if factor != 0.0:
                _add_row(work, i * HORIZONTAL, covariance, k * HORIZONTAL, factor)
    for i in range(HFX, HORIZONTAL):
        _add_row(work, i * HORIZONTAL, covariance, i * HORIZONTAL, ahead[i * HORIZONTAL + i])
    for i in range(HFX, HGX):
        _add_row(work, i * HORIZONTAL, covariance, (i + 3) * HORIZONTAL, ahead[i * HORIZONTAL + i + 3])
    for i in range(HORIZONTAL):  # the lower triangle by fours
        _set_four(covariance, np.uint64(i * HORIZONTAL), work, np.uint64(i * HORIZONTAL), back, np.uint64(0))
    for i in range(4, HORIZONTAL):
        _set_four(covariance, np.uint64(i * HORIZONTAL + 4), work, np.uint64(i * HORIZONTAL), back, np.uint64(4))
    for i in range(8, HORIZONTAL):  # the first rows of `back` are zero there
        row = np.uint64(i * HORIZONTAL)
        _set_last_four(covariance, row + np.uint64(8), work, row + np.uint64(HFX), back, np.uint64(HFX * 12 + 8))
    for i in range(HORIZONTAL):
        for j in range(i):
            covariance[j * HORIZONTAL + i] = covariance[i * HORIZONTAL + j]


@kernel
def update(covariance: Floats, seen: Floats, noise: float, gain: Floats, gate: float) -> float:
    """Variance of the innovation; writes the gain (HORIZONTAL,), shrinks the covariance if the reading is within GATE.

    gate: the squared innovation.
    """
    for i in range(HORIZONTAL):
        gain[i] = 0.0
    count, felt = 0, stack_array(12)  # the columns that are not zero, without a branch on each
    for j in range(HORIZONTAL):
        felt[count] = j
        count += seen[j] != 0.0
    for place in range(count):
        _add_row(gain, 0, covariance, int(felt[place]) * HORIZONTAL, seen[int(felt[place])])
    variance = noise
    for place in range(count):
        variance += seen[int(felt[place])] * gain[int(felt[place])]
    doubted, share = gate > GATE * GATE * variance, unset_stack_array(12)
    for i in range(HORIZONTAL):
        share[i] = gain[i] / variance
    if not doubted:
        take_off_products(covariance, share, gain, 12)
    for i in range(HORIZONTAL):
        gain[i] = share[i]
    return variance


@kernel
def transition_upright(slope: Floats, step: float, fade: Fading, ahead: Floats) -> None:
    """Transition of the vertical block: slope (VFZ, VERTICAL), ahead (VERTICAL, VERTICAL)."""
    for i in range(VFZ):
        for j in range(VERTICAL):
            square = 0.0
            for k in range(VFZ):
                square += slope[i * VERTICAL + k] * slope[k * VERTICAL + j]
            ahead[i * VERTICAL + j] = step * slope[i * VERTICAL + j] + 0.5 * step * step * square
        ahead[i * VERTICAL + VGZ] = 0.5 * fade.fed * ahead[i * VERTICAL + VFZ]
        ahead[i * VERTICAL + VFZ] *= 0.5 * (1.0 + fade.kept)
        ahead[i * VERTICAL + i] += 1.0
    ahead[VFZ * VERTICAL + VFZ], ahead[VFZ * VERTICAL + VGZ] = fade.kept, fade.fed
    ahead[VGZ * VERTICAL + VGZ] = fade.gust


@kernel
def spread_upright(covariance: Floats, ahead: Floats) -> None:
    """covariance = ahead covariance ahead^T, all (VERTICAL, VERTICAL)."""
    work = stack_array(16)
    for i in range(VERTICAL):
        for j in range(VERTICAL):
            for k in range(VERTICAL):
                work[i * VERTICAL + j] += ahead[i * VERTICAL + k] * covariance[k * VERTICAL + j]
    for i in range(VERTICAL):
        for j in range(i + 1):
            total = 0.0
            for k in range(VERTICAL):
                total += work[i * VERTICAL + k] * ahead[j * VERTICAL + k]
            covariance[i * VERTICAL + j] = total
            covariance[j * VERTICAL + i] = total


@kernel
def update_upright(covariance: Floats, seen: Floats, noise: float, gain: Floats, gate: float) -> float:
    """`update` of the vertical block."""
    variance = noise
    for i in range(VERTICAL):
        total = 0.0
        for j in range(VERTICAL):
            total += covariance[i * VERTICAL + j] * seen[j]
        gain[i] = total
        variance += seen[i] * total
    doubted = gate > GATE * GATE * variance
    for i in range(0 if doubted else VERTICAL):
        for j in range(i + 1):
            covariance[i * VERTICAL + j] -= gain[i] * gain[j] / variance
            covariance[j * VERTICAL + i] = covariance[i * VERTICAL + j]
    for i in range(VERTICAL):
        gain[i] /= variance
    return variance
