"""The filter's covariance under four sets of noise at once, beside NumPy's matrices of each of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.filter.four_blocks import (
    Block,
    Sight,
    carry_level,
    carry_upright,
    innovation_off,
    see_level,
    see_upright,
    transition_of_motion,
)
from cocorosim_ros.diagnosis.filter.random_force import Fading, fading
from cocorosim_ros.foundation.compiling.four import LANES, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.blocks import HFX, HGX, HORIZONTAL, VERTICAL, VFZ, VGZ

STEP = 0.1
SHARED = fading(STEP, 2.5, 0.4)
FADES = [fading(STEP, time, smoothness) for time, smoothness in ((2.5, 0.4), (1.0, 0.9), (8.0, 0.05), (2.6, 1.0))]
SHAPES = {"level": (HFX, HGX - HFX), "upright": (VFZ, VGZ - VFZ)}


@kernel
def carry(level: bool, numbers: Any, ahead: Any, push: Any, fade: Any) -> None:
    """Carry a block that lies in `numbers` (size size + size + size size, 4)."""
    fours, fades, size = in_fours(numbers), in_fours(fade), HORIZONTAL if level else VERTICAL
    square = size * size
    block = Block(fours[:square], fours[square : square + size], fours[square + size :], ahead, push)
    of_each = Fading(fades[0], fades[1], fades[2], fades[3], fades[4], fades[5], fades[6])
    if level:
        carry_level(block, of_each, SHARED)
    else:
        carry_upright(block, of_each, SHARED)


@kernel
def see(level: bool, numbers: Any, seen: Any, felt: Any, results: Any, doubted: bool) -> None:
    """See a reading; results (2 + size, 4): variance of its errors, then that of the innovation, 1, then off; gain."""
    fours, size, found = in_fours(numbers), HORIZONTAL if level else VERTICAL, in_fours(results)
    square = size * size
    none = results[0, :0]
    block = Block(fours[:square], fours[square : square + size], fours[square + size :], none, none)
    sight = Sight(in_fours(seen), felt, felt.shape[0])
    found[1] = innovation_off(block, sight, found[1])
    if level:
        found[0] = see_level(block, sight, found[0], found[2:], doubted)
    else:
        found[0] = see_upright(block, sight, found[0], found[2:], doubted)


def transition(slope: Any, forces: int, fade: Any) -> Any:
    """I + h S + (h S)^2 / 2 of pose and velocity, on which random forces act by their mean over the step."""
    places, size = slope.shape[0], slope.shape[0] + 2 * forces
    own = slope[:, :places]
    ahead = np.eye(size)
    ahead[:places, :places] += STEP * own + 0.5 * STEP**2 * own @ own
    act = (STEP * np.eye(places) + 0.5 * STEP**2 * own) @ slope[:, places : places + forces]
    ahead[:places, places : places + forces] = 0.5 * (1.0 + fade.kept) * act
    ahead[:places, places + forces :] = 0.5 * fade.fed * act
    ahead[places : places + forces, places : places + forces] = fade.kept * np.eye(forces)
    ahead[places : places + forces, places + forces :] = fade.fed * np.eye(forces)
    ahead[places + forces :, places + forces :] = fade.gust * np.eye(forces)
    return ahead


def made(name: str) -> tuple[Any, Any, Any, Any]:
    """Slopes with some that are zero, covariances and means that are off, four of each, forces and gusts."""
    moved, pushed = SHAPES[name]
    size, rng = moved + 2 * pushed, np.random.default_rng(len(name))
    slope = rng.standard_normal((moved, size)) * (rng.random((moved, size)) < 0.7)
    slope[:, moved + pushed :] = 0.0
    roots = rng.standard_normal((LANES, size, size))
    return (
        slope,
        roots @ roots.swapaxes(1, 2) + np.eye(size),
        rng.standard_normal((LANES, size)),
        rng.random(2 * pushed),
    )


def laid(covariances: Any, off: Any) -> Any:
    """The numbers of a block, fours, nothing above the diagonals."""
    lower = np.tril(covariances).reshape(LANES, -1)
    return np.ascontiguousarray(np.concatenate([lower, off, np.zeros_like(lower)], axis=1).T)


@pytest.mark.parametrize("name", SHAPES)
def test_a_block_is_carried(name: str) -> None:
    """P becomes T P T^T with the T of each set, and a mean that is off ends where its own T takes it."""
    moved, pushed = SHAPES[name]
    size = moved + 2 * pushed
    slope, covariances, off, push = made(name)
    ahead, numbers = np.zeros(moved * (moved + pushed)), laid(covariances, off)
    transition_of_motion(slope.ravel(), size, STEP, moved, pushed, ahead)
    carry(name == "level", numbers, ahead, push, np.array(FADES).T.copy())
    base = np.concatenate([np.zeros(moved), push])  # what pose and velocity are does not matter to a difference
    for lane, fade in enumerate(FADES):
        own = transition(slope, pushed, fade)
        found = numbers[: size * size, lane].reshape(size, size)
        np.testing.assert_allclose(np.tril(found), np.tril(own @ covariances[lane] @ own.T), rtol=1e-12, atol=1e-12)
        expected = own @ (base + off[lane]) - transition(slope, pushed, SHARED) @ base
        np.testing.assert_allclose(numbers[size * size :, lane][:size], expected, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("doubted", [False, True])
@pytest.mark.parametrize("name", SHAPES)
def test_a_reading_is_seen(name: str, doubted: bool) -> None:
    """By Kalman's formulas; one that is doubted shrinks nothing."""
    size = SHAPES[name][0] + 2 * SHAPES[name][1]
    _, covariances, off, _ = made(name)
    rng, numbers, felt = np.random.default_rng(5), laid(covariances, off), np.array([0, 1, size - 2])
    seen = rng.standard_normal((3, LANES))
    results = np.zeros((2 + size, LANES))
    results[:2] = [[0.3, 0.4, 0.5, 0.6], [1.0, 2.0, 3.0, 4.0]]
    given = results.copy()
    see(name == "level", numbers, seen, felt, results, doubted)
    for lane in range(LANES):
        sight = np.zeros(size)
        sight[felt] = seen[:, lane]
        both = covariances[lane] @ sight
        variance = sight @ both + given[0, lane]
        np.testing.assert_allclose(results[0, lane], variance, rtol=1e-12)
        np.testing.assert_allclose(results[1, lane], given[1, lane] - sight @ off[lane], rtol=1e-12)
        np.testing.assert_allclose(results[2:, lane], both / variance, rtol=1e-12, atol=1e-14)
        left = covariances[lane] - (0.0 if doubted else np.outer(both, both) / variance)
        found = numbers[: size * size, lane].reshape(size, size)
        np.testing.assert_allclose(np.tril(found), np.tril(left), rtol=1e-10, atol=1e-12)
