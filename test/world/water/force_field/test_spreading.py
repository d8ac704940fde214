"""Diffusion and decay against the equation as the paper prints it, computed with scipy's convolution."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st
from scipy import ndimage

from cocorosim_ros.scenario.parts.force_currents import ForceCurrents
from cocorosim_ros.world.water.force_field.parts_of_water import keep_edges, spreading_parts, spreading_weights
from cocorosim_ros.world.water.force_field.spreading import spread_slab
from cocorosim_ros.world.water.force_field.stored_water import by_place, still_water
from cocorosim_ros.world.water.patches import Patches

BLOCK = np.ones((3, 3, 3))
both_forms = pytest.mark.parametrize("form", ["paper_equation_5", "released"])


def settings(form: str, kappa: float = 0.6, gamma: float = 0.65) -> ForceCurrents:
    """Force currents with these choices."""
    return ForceCurrents(diffusion=form, diffusion_rate=kappa, decay_rate=gamma)  # type: ignore[arg-type]


def ours(field: Any, forces: ForceCurrents, steps: int = 1, parts: int = 1) -> Any:
    """The field (nz, ny, nx) after some steps, gone through in parts, the last of them first."""
    nz, ny, nx = field.shape
    patches = Patches(np.zeros(3), 0.1, nx, ny, nz)
    water, made = still_water(patches), spreading_parts(forces, patches, parts)
    by_place(water, patches)[0] = field
    for _ in range(steps):
        for part in made:
            keep_edges(water, part)
        for part in reversed(made):
            for y in range(part.first, part.last):
                spread_slab(water[0], y, 0, part)
    return by_place(water, patches)[0].copy()


def along(field: Any, axis: int) -> Any:
    """The sum of every patch and its two neighbours along an axis, neighbours first."""
    size, sums = field.shape[axis], field.copy()
    place = [slice(None)] * 3
    for index in range(size):
        beside = []
        for neighbour in (index - 1, index + 1):
            if 0 <= neighbour < size:
                place[axis] = neighbour
                beside.append(field[tuple(place)])
        place[axis] = index
        if beside:
            sums[tuple(place)] = sum(beside[1:], beside[0]) + field[tuple(place)]
    return sums


def plain_sweep(field: Any, forces: ForceCurrents) -> Any:
    """One step over the whole field, in the order of sums that all results of this project have: y, z, x."""
    number = ndimage.convolve(np.ones(field.shape, np.int64), BLOCK.astype(np.int64), mode="constant")
    keep, share = spreading_weights(forces)[:, number]
    return keep * field + share * along(along(along(field, 1), 0), 2)


def reference(field: Any, forces: ForceCurrents) -> Any:
    """One step written as the equations are."""
    kappa, gamma = forces.diffusion_rate, forces.decay_rate
    total = ndimage.convolve(field, BLOCK, mode="constant")
    number = ndimage.convolve(np.ones_like(field), BLOCK, mode="constant")
    if forces.diffusion == "released":
        return gamma * ((1.0 - kappa) * field + kappa * total / number)
    neighbours = (total - field) / np.maximum(number - 1.0, 1.0)
    return field + gamma * ((1.0 - kappa) * neighbours - kappa * field)


@both_forms
@pytest.mark.parametrize(
    "shape", [(5, 6, 7), (20, 50, 50), (2, 2, 2), (1, 4, 5), (4, 1, 5), (4, 5, 1), (1, 1, 1), (3, 2, 9)]
)
def test_it_is_the_equation(form: str, shape: tuple[int, int, int]) -> None:
    """For tanks of any shape, down to a single patch, at walls, edges and corners too."""
    field = np.random.default_rng(1).normal(size=shape)
    forces = settings(form)
    np.testing.assert_allclose(ours(field, forces), reference(field, forces), rtol=0, atol=1e-14)


@pytest.mark.parametrize(("form", "factor", "half_life"), [("paper_equation_5", 0.87, 4.98), ("released", 0.65, 1.61)])
def test_uniform_field(form: str, factor: float, half_life: float) -> None:
    """1 + .65 (.4 - .6) = .870 or .65 a step, to the walls; half-lives 4.98 and 1.61 steps; the growth says so too."""
    field = ours(np.full((6, 7, 8), 2.0), settings(form))
    np.testing.assert_allclose(field, 2.0 * factor, rtol=1e-14)
    assert settings(form).growth() == pytest.approx(factor, rel=1e-14)
    assert math.log(0.5) / math.log(settings(form).growth()) == pytest.approx(half_life, abs=0.005)


@pytest.mark.parametrize(("form", "gain"), [("paper_equation_5", 1 / 0.13), ("released", 1 / 0.35)])
def test_steady_gain(form: str, gain: float) -> None:
    """A constant force of 1 added after every step grows to 7.69 or 2.86."""
    field = np.zeros((3, 4, 5))
    for _ in range(400):
        field = ours(field, settings(form)) + 1.0
    np.testing.assert_allclose(field, gain, rtol=1e-12)


@pytest.mark.parametrize(("form", "least"), [("paper_equation_5", 0.51), ("released", 0.13)])
def test_fastest_decaying_pattern(form: str, least: float) -> None:
    """The checkerboard along one axis, uniform along the others, is multiplied by .51 or .13 away from walls."""
    field = np.ones((9, 9, 9)) * (-1.0) ** np.arange(9)
    assert ours(field, settings(form))[4, 4, 4] == pytest.approx(least, abs=1e-14)


def test_half_diffusion_keeps_the_sum_away_from_walls() -> None:
    """With kappa .5 in equation 5 as much arrives as leaves."""
    field = np.zeros((9, 9, 9))
    field[4, 4, 4] = 3.0
    assert ours(field, settings("paper_equation_5", kappa=0.5), 3).sum() == pytest.approx(3.0, rel=1e-14)


@both_forms
@pytest.mark.parametrize("nx", [1, 7, 8, 9, 16])
def test_the_void_after_a_row_stays_zero(form: str, nx: int) -> None:
    """However many patches a row has, so that nothing of a row gets into the next."""
    patches = Patches(np.zeros(3), 0.1, nx, 5, 4)
    water, (part,) = still_water(patches), spreading_parts(settings(form), patches, 1)
    by_place(water, patches)[...] = np.random.default_rng(4).normal(size=(3, 4, 5, nx))
    for _ in range(3):
        keep_edges(water, part)
        for y in range(5):
            spread_slab(water[0], y, 0, part)
    void = water.reshape(3, 5, 4, -1)[..., nx:]
    assert void.shape[-1] >= 1 and not void.any()


@both_forms
def test_mirrored_water_spreads_mirrored(form: str) -> None:
    """Along each axis, to the last bit."""
    field = np.random.default_rng(2).normal(size=(5, 6, 7))
    for axis in range(3):
        mirrored = ours(np.ascontiguousarray(np.flip(field, axis)), settings(form), 3)
        assert np.array_equal(np.flip(mirrored, axis), ours(field, settings(form), 3))


@given(
    shape=st.tuples(*[st.integers(1, 9)] * 2, st.integers(1, 20)),
    parts=st.integers(1, 4),
    form=st.sampled_from(["paper_equation_5", "released"]),
    seed=st.integers(0, 2**32),
)
@hypothesis_settings(max_examples=80, deadline=None)
def test_slab_by_slab_in_parts_is_the_plain_sweep(
    shape: tuple[int, int, int], parts: int, form: str, seed: int
) -> None:
    """To the last bit, for water of any shape, however many parts it is gone through in and in whatever order."""
    field, forces = np.random.default_rng(seed).normal(size=shape), settings(form)
    expected = field
    for _ in range(3):
        expected = plain_sweep(expected, forces)
    assert np.array_equal(ours(field, forces, 3, min(parts, shape[1])), expected)


@both_forms
@pytest.mark.parametrize("kappa", [0.5, 0.6, 1.0])
@pytest.mark.parametrize("gamma", [0.0, 0.35, 0.65, 1.0])
def test_nothing_grows(form: str, kappa: float, gamma: float) -> None:
    """Whatever passes the check of a scenario never raises the greatest force, whatever the field."""
    forces = settings(form, kappa, gamma)
    field = np.sign(np.random.default_rng(3).normal(size=(4, 5, 6)))
    for _ in range(30):
        field = ours(field, forces)
        assert np.abs(field).max() <= 1.0 + 1e-12
