"""What flows into a wall is turned along it."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.force_currents import ColdSpots, ForceCurrents
from cocorosim_ros.world.seeding.seeding import generator
from cocorosim_ros.world.water.force_field.force_field import ForceField
from cocorosim_ros.world.water.force_field.walls import redirect_at_walls, wall_scratch
from cocorosim_ros.world.water.patches import Patches


def redirected(field: np.ndarray) -> np.ndarray:
    """The field with its walls."""
    field = field.copy()
    redirect_at_walls(field, wall_scratch(field.shape[1:]))
    return field


def test_a_quarter_to_each_neighbour_along_the_wall() -> None:
    """Force 4 into the west wall becomes 1 away from the patch in each of the four neighbours."""
    field = np.zeros((3, 5, 5, 5))
    field[0, 2, 2, 0] = -4.0
    found = redirected(field)
    assert found[0].any() == np.False_
    assert [found[1, 2, 3, 0], found[1, 2, 1, 0], found[2, 3, 2, 0], found[2, 1, 2, 0]] == [1.0, -1.0, 1.0, -1.0]
    assert np.count_nonzero(found) == 4


def test_a_third_at_an_edge_a_half_in_a_corner() -> None:
    """Where neighbours lack the others take more."""
    field = np.zeros((3, 5, 5, 5))
    field[2, 4, 2, 0] = 3.0  # into the surface, beside the west wall
    field[1, 0, 4, 4] = 2.0  # into the north wall, in its lower east corner
    found = redirected(field)
    assert [found[0, 4, 2, 1], found[1, 4, 3, 0], found[1, 4, 1, 0]] == [1.0, 1.0, -1.0]
    assert [found[0, 0, 4, 3], found[2, 1, 4, 4]] == [-1.0, 1.0]
    assert np.count_nonzero(found) == 5


def test_what_flows_along_or_away_stays() -> None:
    """Only force into a wall is touched."""
    field = np.zeros((3, 4, 4, 4))
    field[0, :, :, 0], field[0, :, :, 3], field[1, 1:3, 1:3, 0] = 1.0, -1.0, 5.0
    assert np.array_equal(redirected(field), field)


def test_no_axis_is_special() -> None:
    """Exchanging x and y of the water exchanges them in the result, edges included."""
    field = np.random.default_rng(5).normal(size=(3, 4, 5, 5))
    swapped = np.ascontiguousarray(field[[1, 0, 2]].transpose(0, 1, 3, 2))
    np.testing.assert_allclose(redirected(swapped)[[1, 0, 2]].transpose(0, 1, 3, 2), redirected(field), atol=1e-15)


@pytest.mark.parametrize("form", ["paper_equation_5", "released"])
def test_it_stays_bounded(form: str) -> None:
    """With redirecting walls strong cold spots do not make the forces grow, and without them any field dies out."""
    forces = ForceCurrents(
        cold_spots=ColdSpots(force=1.0, probability=0.05),
        diffusion=form,  # type: ignore[arg-type]
        walls="redirected",
    )
    water = ForceField(forces, Patches(np.zeros(3), 0.1, 8, 8, 6), generator(1, "cold spots"))
    sizes = []
    for _ in range(2000):
        water.advance(np.zeros((0, 8)), np.zeros((0, 0, 6)))
        sizes.append(np.abs(water.field).max())
    assert 0.8 < np.mean(sizes[1000:]) / np.mean(sizes[100:1000]) < 1.25
    for _ in range(300):
        water.spread()
    # 0.87^300 = 7e-19 for a uniform field
    assert np.abs(water.field).max() < 1e-12
