"""Currents against their formulas and against an independent interpolation."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.interpolate import RegularGridInterpolator

from cocorosim_ros.world.water.currents import CURRENTS


def velocity(name: str, numbers: list[float], place: list[float], time: float = 0.0) -> list[float]:
    """Velocity of one current."""
    total = np.zeros(3)
    CURRENTS[name].velocity(np.array(place), time, np.array(numbers), total)
    return [float(part) for part in total]


def test_shear_by_hand() -> None:
    """At (2, 3, -1) m: u = 0.1 + 0.02*3 + 0.03*(-1) = 0.13, v = 0.2 + 0.04*2 + 0.05*(-1) = 0.23."""
    found = velocity("sheared", [0.1, 0.2, 0.02, 0.03, 0.04, 0.05], [2.0, 3.0, -1.0])
    assert found == pytest.approx([0.13, 0.23, 0.0], abs=1e-15)


def test_tide_by_hand() -> None:
    """A quarter period after slack water it flows at full strength, half a period later the other way."""
    assert velocity("tidal", [0.1, -0.2, 40.0, 0.0], [0.0, 0.0, 0.0], 10.0) == pytest.approx([0.1, -0.2, 0.0])
    assert velocity("tidal", [0.1, -0.2, 40.0, math.pi], [0.0, 0.0, 0.0], 10.0) == pytest.approx([-0.1, 0.2, 0.0])


@pytest.mark.parametrize("radius", [1e-9, 0.05, 0.5, 3.0])
def test_vortex_circulation(radius: float) -> None:
    """Around a circle of radius r the circulation is Gamma (1 - exp(-r^2 / core^2)), counter-clockwise."""
    angle = np.linspace(0.0, 2.0 * math.pi, 16, endpoint=False)
    along = []
    for a in angle:
        u, v, w = velocity(
            "vortex", [1.0, -2.0, 0.3, 0.4], [1.0 + radius * math.cos(a), -2.0 + radius * math.sin(a), -1]
        )
        along.append(-u * math.sin(a) + v * math.cos(a))
        assert w == 0.0 and abs(u * math.cos(a) + v * math.sin(a)) < 1e-12
    expected = 0.3 * -math.expm1(-((radius / 0.4) ** 2))
    # 1.0 + 1e-9 keeps seven digits of the radius.
    assert 2.0 * math.pi * radius * np.mean(along) == pytest.approx(expected, rel=3e-7 if radius < 1e-3 else 1e-12)


def test_vortex_centre() -> None:
    """At the very centre the water is at rest."""
    assert velocity("vortex", [1.0, -2.0, 0.3, 0.4], [1.0, -2.0, -1.0]) == [0.0, 0.0, 0.0]


def test_grid_against_scipy() -> None:
    """Inside, it is scipy's multilinear interpolation; outside, its value at the nearest edge, in time too."""
    draw = np.random.default_rng(4)
    axes = [np.sort(draw.uniform(low, 0.0, n)) for low, n in ((-50.0, 4), (-2.0, 5), (-3.0, 6), (-3.0, 7))]
    table = draw.normal(size=(4, 5, 6, 7, 3))
    numbers = np.concatenate([table.shape[:4], *axes, table.ravel()])
    reference = RegularGridInterpolator(axes, table)
    for t, z, y, x in draw.uniform([-60, -2.5, -4, -4], [10, 0.5, 1, 1], (500, 4)):
        inside = [np.clip(value, axis[0], axis[-1]) for value, axis in zip((t, z, y, x), axes, strict=True)]
        found = velocity("gridded", list(numbers), [x, y, z], t)
        np.testing.assert_allclose(found, reference(inside)[0], rtol=0, atol=1e-12)
