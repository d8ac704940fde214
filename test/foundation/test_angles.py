"""Angles on the circle, up to the last bit at its seam."""

from __future__ import annotations

import itertools
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st


@settings(deadline=None)  # the first call compiles
@given(st.floats(-1e6, 1e6), st.integers(-3, 3))
def test_it_is_the_same_direction(angle: float, turns: int) -> None:
    """Wrapped, an angle has the same sine and cosine, with whole turns added too."""
    from cocorosim_ros.foundation.compiling.angles import wrap_angle

    wrapped = wrap_angle(angle + 2.0 * math.pi * turns)
    assert math.cos(wrapped - angle) == pytest.approx(1.0, abs=1e-12)
    assert abs(wrapped) < math.pi + 1e-9


def test_it_never_leaves_the_half_open_interval() -> None:
    """The floating-point numbers next to odd multiples of pi wrap into (-pi, pi]."""
    from cocorosim_ros.foundation.compiling.angles import wrap_angle

    for half_turns, direction in itertools.product((-7, -1, 1, 5, 2001), (-math.inf, math.inf)):
        angle = half_turns * math.pi
        for _ in range(4):
            assert -math.pi < wrap_angle(angle) <= math.pi
            angle = math.nextafter(angle, direction)


@settings(deadline=None)  # the first call compiles
@given(st.floats(-1e5, 1e5))
def test_sine_and_cosine_are_those_of_extended_precision(angle: float) -> None:
    """Within three units in the last place of numpy's 80-bit functions, or a quadrillionth near the zeros."""
    import numpy as np

    from cocorosim_ros.foundation.compiling.angles import sine_cosine

    sine, cosine = sine_cosine(angle)
    for ours, exact in ((sine, np.sin(np.longdouble(angle))), (cosine, np.cos(np.longdouble(angle)))):
        assert abs(np.longdouble(ours) - exact) <= max(3 * np.spacing(abs(ours)), 1e-21)


def test_sine_and_cosine_at_the_quarters() -> None:
    """Exact at zero; at multiples of pi/2 in floating point as the system's functions; not a number of none."""
    from cocorosim_ros.foundation.compiling.angles import sine_cosine

    assert sine_cosine(0.0) == (0.0, 1.0)
    for quarters in range(-9, 10):
        angle = quarters * math.pi / 2
        assert sine_cosine(angle) == pytest.approx((math.sin(angle), math.cos(angle)), rel=1e-15, abs=1e-30)
    assert all(math.isnan(part) for part in sine_cosine(math.nan))
    assert sine_cosine(1e9) == (math.sin(1e9), math.cos(1e9))
