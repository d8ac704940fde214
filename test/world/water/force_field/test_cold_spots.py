"""Cold spots: where they pull, how strong, how many, and the field that they leave."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cocorosim_ros.scenario.parts.force_currents import ColdSpots, ForceCurrents
from cocorosim_ros.world.seeding.seeding import generator
from cocorosim_ros.world.water.force_field.arriving import Spots
from cocorosim_ros.world.water.force_field.cold_spots import new_places, no_spots, pull_of, spawn
from cocorosim_ros.world.water.force_field.force_field import ForceField
from cocorosim_ros.world.water.force_field.pulls import Pull, Pulling, pull_water, strength_at, stretches_of
from cocorosim_ros.world.water.force_field.stored_water import by_place, still_water
from cocorosim_ros.world.water.patches import Patches

FIVE_METRES = Patches(np.array([-2.5, -2.5, -2.0]), 0.1, 50, 50, 20)
NO_JETS, NOBODY = np.zeros((0, 0, 6)), np.zeros((0, 8))


def one_spot(place: tuple[int, int, int], kind: str, shape: tuple[int, int, int] = (9, 9, 9)) -> Any:
    """The forces (3, nz, ny, nx) of one spot of unit strength."""
    patches = Patches(np.zeros(3), 0.1, *reversed(shape))
    nothing = no_spots(ColdSpots(force=1.0, probability=0.0), 1, patches)
    spots = spawn(nothing._replace(strength=np.ones(1)), 0, np.array([place]))
    return pulled(spots, 0, patches, pull_of(kind))


def pulled(spots: Spots, step: int, patches: Patches, pull: Pull) -> Any:
    """What spots make of water without forces (3, nz, ny, nx)."""
    water = still_water(patches)
    pull_water(water, Pulling(spots, strength_at(spots, step), stretches_of(pull, spots.shape)))
    return by_place(water, patches)


def test_all_26_neighbours_are_pulled_straight_with_equal_force() -> None:
    """A unit vector towards the spot in each neighbour, nothing in the spot and beyond."""
    field = one_spot((4, 4, 4), "surrounding_26")
    for dz, dy, dx in product((-1, 0, 1), repeat=3):
        found = field[:, 4 + dz, 4 + dy, 4 + dx]
        length = math.sqrt(dx * dx + dy * dy + dz * dz)
        expected = [0.0, 0.0, 0.0] if length == 0.0 else [-dx / length, -dy / length, -dz / length]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-15)
    assert np.count_nonzero(field) == 54


def test_released_18() -> None:
    """Faces 1; horizontal diagonals .707 an axis; vertical diagonals 1 an axis; no corners."""
    field = one_spot((4, 4, 4), "released_18")
    assert field[:, 4, 4, 5].tolist() == [-1.0, 0.0, 0.0]
    assert field[:, 3, 4, 4].tolist() == [0.0, 0.0, 1.0]
    np.testing.assert_allclose(field[:, 4, 5, 3], [math.sqrt(0.5), -math.sqrt(0.5), 0.0])
    assert field[:, 5, 4, 3].tolist() == [1.0, 0.0, -1.0]
    assert field[:, 5, 5, 3].tolist() == [0.0, 0.0, 0.0]
    assert np.count_nonzero(field.any(axis=0)) == 18


@pytest.mark.parametrize("shape", [(3, 2, 1), (2, 3, 2), (3, 3, 3), (3, 4, 4), (2, 3, 5), (3, 3, 6)])
@pytest.mark.parametrize("kind", ["surrounding_26", "released_18"])
def test_everywhere_in_narrow_water(kind: str, shape: tuple[int, int, int]) -> None:
    """Wherever a spot is, it pulls what there is of its neighbours as in open water, and nothing else."""
    whole = one_spot((8, 8, 8), kind, (17, 17, 17))
    for k, j, i in product(*map(range, shape)):
        part = whole[:, 8 - k : 8 - k + shape[0], 8 - j : 8 - j + shape[1], 8 - i : 8 - i + shape[2]]
        assert np.array_equal(one_spot((k, j, i), kind, shape), part)


@pytest.mark.parametrize("kind", ["surrounding_26", "released_18"])
def test_at_a_wall_the_rest_is_the_same(kind: str) -> None:
    """A spot in a corner pulls those neighbours that exist, exactly as one in open water does."""
    whole = one_spot((4, 4, 4), kind)
    corner = one_spot((0, 0, 8), kind)
    assert np.array_equal(corner[:, :2, :2, 7:], whole[:, 4:6, 4:6, 3:5])
    assert np.count_nonzero(corner) == np.count_nonzero(whole[:, 4:6, 4:6, 3:5])


def test_life() -> None:
    """One spot pulls with M sin(pi a / 25) at age a and with nothing from age 25 on."""
    settings = ColdSpots(force=0.005, probability=0.0)
    patches = Patches(np.zeros(3), 0.1, 5, 5, 5)
    spots = no_spots(settings, 25, patches)
    for step in range(40):
        places = np.array([[2, 2, 2]]) if step == 3 else np.zeros((0, 3), dtype=np.int64)
        spots = spawn(spots, step, places)
        field = pulled(spots, step, patches, pull_of("surrounding_26"))
        age = step - 3
        expected = 0.005 * math.sin(math.pi * age / 25) if 0 <= age < 25 else 0.0
        assert field[0, 2, 2, 1] == pytest.approx(expected, abs=1e-17)


@given(
    shape=st.tuples(*[st.integers(1, 6)] * 2, st.integers(1, 12)),
    kind=st.sampled_from(["surrounding_26", "released_18"]),
    numbers=st.lists(st.integers(0, 40), min_size=1, max_size=12),
    seed=st.integers(0, 2**32),
)
@settings(max_examples=60, deadline=None)
def test_pulls_are_added_younger_first(shape: tuple[int, int, int], kind: str, numbers: list[int], seed: int) -> None:
    """To the last bit the plain sum over ages and draws, while lists are filled, let go of and outgrow their room."""
    lifetime, random, patches = 4, np.random.default_rng(seed), Patches(np.zeros(3), 0.1, *reversed(shape))
    spots, weight = no_spots(ColdSpots(force=0.3, probability=0.0), lifetime, patches), pull_of(kind).weight
    drawn: list[Any] = []
    for step, number in enumerate(numbers):
        drawn.insert(0, random.integers(0, shape, (number, 3)))
        spots = spawn(spots, step, drawn[0])
        expected = np.zeros((3, *(size + 2 for size in shape)))
        for age, places in enumerate(drawn[:lifetime]):
            for k, j, i in places:
                expected[:, k : k + 3, j : j + 3, i : i + 3] += 0.3 * np.sin(np.pi * age / lifetime) * weight
        found = pulled(spots, step, patches, pull_of(kind))
        assert np.array_equal(found, expected[:, 1:-1, 1:-1, 1:-1])
        assert spots.number.sum() == sum(map(len, drawn[:lifetime]))


def test_numbers_of_the_paper() -> None:
    """Of 50,000 patches 75 a step become cold spots and 1875 are alive; every patch as often, none twice a step."""
    settings, random = ColdSpots(force=1.0), generator(1, "cold spots")
    drawn = [new_places(settings, FIVE_METRES, random) for _ in range(2000)]
    counts = np.array([len(places) for places in drawn])
    # 2000 binomial numbers of mean 75: the mean is off by 0.19 (one sigma).
    assert abs(counts.mean() - 75.0) < 0.8
    assert abs(counts.var() / (75.0 * 0.9985) - 1.0) < 0.15
    for places in drawn:
        assert len(np.unique(places, axis=0)) == len(places)
    everything = np.concatenate(drawn)
    assert everything.min() == 0 and everything.max(axis=0).tolist() == [19, 49, 49]
    np.testing.assert_allclose(everything.mean(axis=0), [9.5, 24.5, 24.5], atol=0.2)


def test_released_spawning() -> None:
    """floor(2 * 0.0015 * N) every step; less than one: sometimes one."""
    settings, random = ColdSpots(force=1.0, spawning="released"), generator(1, "cold spots")
    assert {len(new_places(settings, FIVE_METRES, random)) for _ in range(20)} == {150}
    few = Patches(np.zeros(3), 1.0, 5, 5, 4)
    numbers = [len(new_places(settings, few, random)) for _ in range(2000)]
    # 2 * 0.0015 * 100 = 0.3, sigma of the mean 0.01
    assert set(numbers) == {0, 1} and abs(np.mean(numbers) - 0.3) < 0.04


@pytest.mark.parametrize(
    ("form", "profile"),
    [("released", [0, 1.51, 0.162, 0.025, 0.004]), ("paper_equation_5", [0, 2.92, 0.437, 0.095, 0.022])],
)
def test_steady_field_of_a_constant_spot(form: str, profile: list[float]) -> None:
    """|Fx| at 0 to 4 patches beside one unit spot that never ends, 18 neighbours: the facts' figures (4.5)."""
    forces = ForceCurrents(diffusion=form)  # type: ignore[arg-type]
    source = one_spot((12, 12, 12), "released_18", (25, 25, 25))
    water = ForceField(forces, Patches(np.zeros(3), 0.1, 25, 25, 25), generator(1, "cold spots"))
    for _ in range(150):
        water.spread()
        water.field[...] += source
    np.testing.assert_allclose(np.abs(water.field[0, 12, 12, 12:17]), profile, rtol=0, atol=0.006)


@pytest.mark.parametrize(
    ("form", "spawning", "rms", "mean"),
    [
        ("released", "paper", 0.58, 0.54),
        ("released", "released", 0.83, 0.90),
        ("paper_equation_5", "paper", 1.10, 1.07),
    ],
)
def test_strength_of_the_paper_s_turbulence(form: str, spawning: str, rms: float, mean: float) -> None:
    """Per unit of cold spot force: root mean square of Fx and mean horizontal force of the facts (4.6), within 4 %."""
    forces = ForceCurrents(
        cold_spots=ColdSpots(force=1.0, spawning=spawning, neighbours="released_18"),  # type: ignore[arg-type]
        diffusion=form,  # type: ignore[arg-type]
    )
    water = ForceField(forces, FIVE_METRES, generator(7, "cold spots"))
    squares, lengths = [], []
    for step in range(300):
        water.advance(NOBODY, NO_JETS)
        if step >= 60 and step % 10 == 0:
            squares.append(np.mean(water.field[0] ** 2))
            lengths.append(np.mean(np.hypot(water.field[0], water.field[1])))
    assert abs(water.spots_alive / (3750 if spawning == "released" else 1875) - 1.0) < 0.1
    assert math.sqrt(np.mean(squares)) == pytest.approx(rms, rel=0.04)
    assert np.mean(lengths) == pytest.approx(mean, rel=0.04)


def test_threads_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """Parts side by side, as in large tanks, or all of it at once: the same field to the last bit."""
    fields = []
    for least in (10**9, 1):
        monkeypatch.setattr("cocorosim_ros.world.water.force_field.force_field.PATCHES_FOR_THREADS", least)
        water = ForceField(ForceCurrents(cold_spots=ColdSpots(force=1.0)), FIVE_METRES, generator(3, "cold spots"))
        for _ in range(30):
            water.advance(NOBODY, NO_JETS)
        fields.append(water.field)
    assert np.array_equal(*fields)
    assert np.abs(fields[0]).max() > 1.0
