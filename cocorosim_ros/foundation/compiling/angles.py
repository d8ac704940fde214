"""Angles on the circle, and their sine and cosine with the same bits on every machine."""

from __future__ import annotations

import math

from cocorosim_ros.foundation.compiling.four import chosen, everywhere, whole_below
from cocorosim_ros.foundation.compiling.kernel import kernel


@kernel
def wrap_angle(angle: float) -> float:
    """The same direction in (-pi, pi]; `angle` in rad."""
    # Rounded up, without the detour by whole numbers that math.ceil takes.
    turns: float = -whole_below((math.pi - angle) / (2.0 * math.pi))
    wrapped = angle - 2.0 * math.pi * turns
    # Next to odd multiples of pi rounding can leave the interval by a hair.
    if wrapped > math.pi or wrapped <= -math.pi:
        return math.pi
    return wrapped


# pi/2 in three pieces of 33 bits and the rest, so that multiples up to 2**20 of the first ones are exact.
_QUARTERS_PER_RADIAN = 0.6366197723675814
_QUARTER = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
_REDUCIBLE = 1e6  # rad; beyond, the system's own functions are asked


@kernel
def sine_cosine(angle: float) -> tuple[float, float]:
    """Sine and cosine of `angle` [rad], each within three units in the last place up to 1e5 rad.

    Mathematical libraries round differently from version to version and from processor to processor; sums and
    products do not, and they take less than half of the time. Polynomials on |x| <= pi/4 and their coefficients after
    W. J. Cody and W. Waite, Software Manual for the Elementary Functions (1980), and fdlibm.
    """
    quarters = whole_below(angle * _QUARTERS_PER_RADIAN + 0.5)
    x = ((angle - quarters * _QUARTER[0]) - quarters * _QUARTER[1]) - quarters * _QUARTER[2]
    z = x * x
    odd = 2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)
    odd = 8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 + z * odd)
    even = -2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)
    even = -1.38888888888741095749e-03 + z * (2.48015872894767294178e-05 + z * even)
    sine = x + x * z * (-1.66666666666666324348e-01 + z * odd)
    cosine = 1.0 - (0.5 * z - z * z * (4.16666666666666019037e-02 + z * even))
    # No branch on the quarter: robots look anywhere, so that a processor would guess every other one wrong.
    halves = whole_below(0.5 * quarters)
    odd = quarters - 2.0 * halves
    sign = 1.0 - 2.0 * (halves - 2.0 * whole_below(0.5 * halves))
    turned_sine, turned_cosine = sign * chosen(odd > 0.0, cosine, sine), sign * chosen(odd > 0.0, -sine, cosine)
    near = abs(angle) <= _REDUCIBLE
    if everywhere(near):
        return turned_sine, turned_cosine
    return chosen(near, turned_sine, math.sin(angle)), chosen(near, turned_cosine, math.cos(angle))
