"""The filter's covariance under four sets of noise at once, one in each lane of `fours`, and how far each mean is off.

A block of the state holds `moved` poses and velocities, then `pushed` random forces and as many gusts. All sets share
the slopes of the motion, and so the transition of pose and velocity; random forces fade in each in its own way.
Matrices are flat, (size, size) with size = moved + 2 pushed; below the diagonal they are always right, above it after
`filled_above` alone.
"""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.diagnosis.filter.random_force import Fading
from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import kernel, outlined_kernel
from cocorosim_ros.world.terms.blocks import HFX, HGX, HORIZONTAL, VERTICAL, VFZ, VGZ


class Block(NamedTuple):
    """One block of the state under four sets of noise: all of fours but what is shared."""

    covariance: Floats  # (size, size) flat, of fours
    off: Floats  # (size,) of fours: mean of each set less the mean of the pass that all are compared with
    work: Floats  # (size, size) flat, of fours
    ahead: Floats  # (moved, moved + pushed) flat: transition of pose and velocity, shared; forces act as if they lasted
    push: Floats  # (2 pushed,) random forces and gusts of the pass that all are compared with, shared


@kernel
def transition_of_motion(slope: Floats, columns: int, step: float, moved: int, pushed: int, ahead: Floats) -> None:
    """ahead (moved, moved + pushed) = exp(slope step) to second order, for forces that last; slope (moved, columns)."""
    wide = moved + pushed
    for i in range(moved):
        for j in range(wide):
            ahead[i * wide + j] = step * slope[i * columns + j]
        for k in range(moved):
            factor = 0.5 * step * step * slope[i * columns + k]
            for j in range(0 if factor == 0.0 else wide):
                ahead[i * wide + j] += factor * slope[k * columns + j]
        ahead[i * wide + i] += 1.0


@kernel
def filled_above(covariance: Floats, size: int) -> None:
    """Copy what is below the diagonal to the places above it."""
    for i in range(size):
        for j in range(i):
            covariance[j * size + i] = covariance[i * size + j]


@kernel
def _carried_rows(block: Block, fade: Fading, moved: int, pushed: int) -> None:
    """work = transition times covariance, (size, size) both."""
    covariance, work, size, wide = block.covariance, block.work, moved + 2 * pushed, moved + pushed
    held, fed = 0.5 * (1.0 + fade.kept), 0.5 * fade.fed
    for force in range(pushed):
        at, gust = (moved + force) * size, (moved + pushed + force) * size
        for j in range(size):  # first the mean of the force over the step, then, below, the force at its end
            work[at + j] = held * covariance[at + j] + fed * covariance[gust + j]
            work[gust + j] = fade.gust * covariance[gust + j]
    for i in range(moved):
        for j in range(size):
            work[i * size + j] = block.ahead[i * wide + i] * covariance[i * size + j]
        for k in range(wide):
            factor = block.ahead[i * wide + k]
            if k == i or factor == 0.0:
                continue
            for j in range(size):
                work[i * size + j] += factor * (covariance[k * size + j] if k < moved else work[k * size + j])
    for force in range(pushed):
        at, gust = (moved + force) * size, (moved + pushed + force) * size
        for j in range(size):
            work[at + j] = fade.kept * covariance[at + j] + fade.fed * covariance[gust + j]


@kernel
def _carried_columns(block: Block, fade: Fading, moved: int, pushed: int) -> None:
    """covariance = work times the transposed transition, below the diagonal."""
    covariance, work, size, wide = block.covariance, block.work, moved + 2 * pushed, moved + pushed
    held, fed = 0.5 * (1.0 + fade.kept), 0.5 * fade.fed
    for i in range(size):
        row = i * size
        for force in range(pushed):
            at, gust = row + moved + force, row + moved + pushed + force
            force_end, gust_end = fade.kept * work[at] + fade.fed * work[gust], fade.gust * work[gust]
            work[at] = held * work[at] + fed * work[gust]  # its mean over the step
            if moved + force <= i:
                covariance[at] = force_end
            if moved + pushed + force <= i:
                covariance[gust] = gust_end
        for j in range(min(i + 1, moved)):
            total = block.ahead[j * wide + j] * work[row + j]
            for k in range(wide):
                factor = block.ahead[j * wide + k]
                if k != j and factor != 0.0:
                    total += factor * work[row + k]
            covariance[row + j] = total


@kernel
def _carried_off(block: Block, fade: Fading, shared: Fading, moved: int, pushed: int) -> None:
    """Carry by how much the means are off; shared: the fading of the pass that all are compared with."""
    off, push, before, wide = block.off, block.push, block.work, moved + pushed
    for force in range(pushed):
        at, gust = moved + force, moved + pushed + force
        pushing, driving = push[force] + off[at], push[pushed + force] + off[gust]
        before[force] = 0.5 * (pushing + fade.kept * pushing + fade.fed * driving)
        before[force] -= 0.5 * (push[force] + shared.kept * push[force] + shared.fed * push[pushed + force])
        off[at] = fade.kept * pushing + fade.fed * driving
        off[at] -= shared.kept * push[force] + shared.fed * push[pushed + force]
        off[gust] = fade.gust * driving - shared.gust * push[pushed + force]
    for i in range(moved):
        before[pushed + i] = off[i]
    for i in range(moved):
        total = block.ahead[i * wide + i] * before[pushed + i]
        for k in range(wide):
            factor = block.ahead[i * wide + k]
            if k != i and factor != 0.0:
                total += factor * (before[pushed + k] if k < moved else before[k - moved])
        off[i] = total


@kernel
def _carried(block: Block, fade: Fading, shared: Fading, moved: int, pushed: int) -> None:
    filled_above(block.covariance, moved + 2 * pushed)
    _carried_rows(block, fade, moved, pushed)
    _carried_columns(block, fade, moved, pushed)
    _carried_off(block, fade, shared, moved, pushed)


@outlined_kernel
def carry_level(block: Block, fade: Fading, shared: Fading) -> None:
    """Carry the horizontal block over a step of the grid, without what the random force adds.

    fade: of each of the four; shared: of the pass that all are compared with.
    """
    _carried(block, fade, shared, HFX, HGX - HFX)


@outlined_kernel
def carry_upright(block: Block, fade: Fading, shared: Fading) -> None:
    """`carry_level` of the vertical block."""
    _carried(block, fade, shared, VFZ, VGZ - VFZ)


class Sight(NamedTuple):
    """How a reading depends on its block of the state: the columns that it feels, first to last."""

    seen: Floats  # (HORIZONTAL,) of fours: derivatives of the reading by these columns
    felt: Integers  # (HORIZONTAL,) the columns
    columns: int  # how many there are


@kernel
def innovation_off(block: Block, sight: Sight, innovation: Floats) -> Floats:
    """An innovation (a four) less what the means that are off add to what is expected."""
    for place in range(sight.columns):
        innovation -= sight.seen[place] * block.off[sight.felt[place]]
    return innovation


@kernel
def _see(block: Block, sight: Sight, variance: Floats, gain: Floats, is_doubted: bool, size: int) -> Floats:
    covariance = block.covariance
    for i in range(size):
        gain[i] = 0.0
    for place in range(sight.columns):
        seen, j = sight.seen[place], sight.felt[place]
        for i in range(j):
            gain[i] += seen * covariance[j * size + i]
        for i in range(j, size):
            gain[i] += seen * covariance[i * size + j]
    for place in range(sight.columns):
        variance += sight.seen[place] * gain[sight.felt[place]]
    share = 1.0 / variance
    for i in range(0 if is_doubted else size):
        product = gain[i] * share
        for j in range(i + 1):
            covariance[i * size + j] -= product * gain[j]
    for i in range(size):
        gain[i] *= share
    return variance


@outlined_kernel
def see_level(block: Block, sight: Sight, variance: Floats, gain: Floats, is_doubted: bool) -> Floats:
    """Variances of the innovations of a horizontal reading (a four) by those of its errors (a four).

    Writes the gains (HORIZONTAL,), fours, and shrinks the covariance, but not for a doubted reading.
    """
    found: Floats = _see(block, sight, variance, gain, is_doubted, HORIZONTAL)
    return found


@outlined_kernel
def see_upright(block: Block, sight: Sight, variance: Floats, gain: Floats, is_doubted: bool) -> Floats:
    """`see_level` of a vertical reading; writes its gains (VERTICAL,)."""
    found: Floats = _see(block, sight, variance, gain, is_doubted, VERTICAL)
    return found
