"""A train of waves as a robot feels it: linear theory by its potential, and the frequency of encounter."""

from __future__ import annotations

import math

import numpy as np
import pytest

from cocorosim_ros.world.effects.surface_waves import BOTTOMLESS, GRAVITY, surface_waves, wave_number

SPEED, PERIOD, DIRECTION, PHASE = 0.3, 4.0, 0.7, 0.4
TRAIN = np.array([SPEED, PERIOD, DIRECTION, PHASE, BOTTOMLESS])
OMEGA = 2.0 * math.pi / PERIOD
K = OMEGA**2 / GRAVITY
AMPLITUDE = SPEED / OMEGA
PLACES = [(0.0, 0.0, 0.0, 0.0), (3.0, -2.0, -1.5, 0.7), (-8.0, 5.0, -4.0, 11.3)]


def velocity(x: float, y: float, z: float, time: float) -> list[float]:
    """Velocity of the water at a place [m; world] and a time."""
    total = np.zeros(3)
    surface_waves(np.array([x, y, z]), time, TRAIN, total)
    return total.tolist()


def theta(x: float, y: float, time: float) -> float:
    """Phase of the train, by hand."""
    return K * (x * math.cos(DIRECTION) + y * math.sin(DIRECTION)) - OMEGA * time + PHASE


def potential(x: float, y: float, z: float, time: float) -> float:
    """Velocity potential of linear waves on deep water: a g / omega exp(k z) sin(theta)."""
    return AMPLITUDE * GRAVITY / OMEGA * math.exp(K * z) * math.sin(theta(x, y, time))


@pytest.mark.parametrize("place", PLACES)
def test_the_velocity_is_the_gradient_of_the_potential(place: tuple[float, float, float, float]) -> None:
    """By central differences of the potential of linear theory."""
    h = 1e-4
    gradient = []
    for axis in range(3):
        ahead, behind = list(place), list(place)
        ahead[axis] += h
        behind[axis] -= h
        gradient.append((potential(*ahead) - potential(*behind)) / (2.0 * h))
    assert velocity(*place) == pytest.approx(gradient, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("place", PLACES)
def test_the_surface_rises_with_the_water(place: tuple[float, float, float, float]) -> None:
    """The kinematic condition: the height a cos(theta) grows by the velocity upwards at the surface."""
    x, y, _, time = place
    h = 1e-5
    rise = AMPLITUDE * (math.cos(theta(x, y, time + h)) - math.cos(theta(x, y, time - h))) / (2.0 * h)
    assert velocity(x, y, 0.0, time)[2] == pytest.approx(rise, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("ahead", [1.5, 0.0, -1.5])
def test_a_robot_meets_the_crests_at_the_frequency_of_encounter(ahead: float) -> None:
    """omega - k U along the waves; counted by the turns of the velocity, whose parts are a cosine and a sine."""
    time = np.linspace(0.0, 400.0, 40001)
    x, y = ahead * math.cos(DIRECTION) * time, ahead * math.sin(DIRECTION) * time
    seen = np.array([velocity(*row) for row in zip(x, y, np.zeros_like(time), time, strict=True)])
    along = seen[:, 0] * math.cos(DIRECTION) + seen[:, 1] * math.sin(DIRECTION)
    turned = np.unwrap(np.arctan2(seen[:, 2], along))
    assert (turned[0] - turned[-1]) / time[-1] == pytest.approx(OMEGA - K * ahead, rel=1e-6)


def test_water_is_calm_far_down() -> None:
    """At half a wave length e^-pi of the speed at the surface is left."""
    deep = np.linalg.norm(velocity(0.0, 0.0, -math.pi / K, 1.0))
    assert deep == pytest.approx(SPEED * math.exp(-math.pi), rel=1e-12)


@pytest.mark.parametrize("depth", [0.05, 0.7, 3.0, 12.0, 60.0, BOTTOMLESS])
def test_the_wave_number_fulfils_the_dispersion_relation(depth: float) -> None:
    """omega^2 = g k tanh(k h), to the last digits; of a long wave it is omega / sqrt(g h)."""
    k = wave_number(OMEGA, depth)
    assert GRAVITY * k * math.tanh(k * depth) == pytest.approx(OMEGA**2, rel=1e-12)
    assert wave_number(1e-3 * OMEGA, depth) == pytest.approx(1e-3 * OMEGA / math.sqrt(GRAVITY * depth), rel=1e-3)


FLOOR = 2.5  # m


def over_floor(x: float, y: float, z: float, time: float) -> float:
    """Velocity potential of linear waves over a floor, whose speed at the surface is SPEED: SPEED / k cosh / cosh."""
    k = wave_number(OMEGA, FLOOR)
    turned = k * (x * math.cos(DIRECTION) + y * math.sin(DIRECTION)) - OMEGA * time + PHASE
    return SPEED / k * math.cosh(k * (z + FLOOR)) / math.cosh(k * FLOOR) * math.sin(turned)


@pytest.mark.parametrize("place", [(0.0, 0.0, 0.0, 0.0), (3.0, -2.0, -1.5, 0.7), (-8.0, 5.0, -2.4, 11.3)])
def test_the_velocity_over_a_floor_is_the_gradient_of_its_potential(place: tuple[float, float, float, float]) -> None:
    """By central differences; nothing goes through the floor, where the water goes to and fro still."""
    h, gradient, total = 1e-4, [], np.zeros(3)
    for axis in range(3):
        ahead, behind = list(place), list(place)
        ahead[axis] += h
        behind[axis] -= h
        gradient.append((over_floor(*ahead) - over_floor(*behind)) / (2.0 * h))
    train = np.array([SPEED, PERIOD, DIRECTION, PHASE, FLOOR])
    surface_waves(np.array(place[:3]), place[3], train, total)
    assert total.tolist() == pytest.approx(gradient, rel=1e-6, abs=1e-9)
    bottom = np.zeros(3)
    surface_waves(np.array([*place[:2], -FLOOR]), place[3], train, bottom)
    assert abs(bottom[2]) < 1e-12
    assert np.hypot(*bottom[:2]) < np.hypot(*total[:2])
