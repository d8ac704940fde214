"""Laws that no catalogue has: each kind of equation and regressor against a closed form or a catalogue effect."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE

Make = Callable[..., Any]
OFF = (0.0, 0.0, 0.0)
EQUATION = {name: code for code, name in enumerate(("surge", "sway", "heave", "yaw", "world_x", "world_y", "world_z"))}


def law(place: int, coefficient: float, equation: str, *factors: tuple[str, float, bool], **more: float) -> Any:
    """Numbers of a law in one of the places: its factors are (regressor, power, signed)."""
    numbers = {"coefficient": coefficient, "equation": float(EQUATION[equation]), **more}
    for number, (name, power, signed) in enumerate(factors, 1):
        numbers |= {
            f"regressor_{number}": float(REGRESSOR_CODE[name]),
            f"power_{number}": power,
            f"signed_{number}": float(signed),
        }
    return {f"law_{place}.{name}": value for name, value in numbers.items()}


def test_two_laws_are_a_tether(swim: Make) -> None:
    """world_x ~ x and world_y ~ y with the same coefficient -k are a spring to the origin."""
    spring = {**law(1, -0.05, "world_x", ("x", 1, True)), **law(2, -0.05, "world_y", ("y", 1, True))}
    start = {X: 0.3, Y: -0.2, YAW: 2.0, SURGE: 0.01}
    np.testing.assert_allclose(
        swim(spring, start, [OFF] * 20)[:, 0, :8],
        swim({"tether.stiffness": 0.05}, start, [OFF] * 20)[:, 0, :8],
        rtol=0,
        atol=1e-14,
    )


def test_a_power_of_the_speed(swim: Make, lily: SimpleNamespace) -> None:
    """surge ~ |u|^0.5*u stops a robot as u = u0 / (1 + c sqrt(u0) t / 2 m)^2, backwards too."""
    time = 0.5 * np.arange(21)
    for speed in (0.05, -0.05):
        path = swim(law(3, -0.1, "surge", ("u", 1.5, True)), {SURGE: speed}, [OFF] * 20)
        expected = speed / (1 + 0.1 * math.sqrt(0.05) * time / (2 * lily.mass)) ** 2
        np.testing.assert_allclose(path[:, 0, SURGE], expected, rtol=1e-7)


def test_a_moment_that_swings(swim: Make, lily: SimpleNamespace) -> None:
    """yaw ~ sin_t without drag: r = c (cos phase - cos(omega t + phase)) / (I omega)."""
    omega, phase = 2 * math.pi / 47.0, 0.4
    path = swim(law(1, 1e-6, "yaw", ("sin_t", 1, True), omega=omega, phase=phase), {}, [OFF] * 60)
    time = 0.5 * np.arange(61)
    rate = 1e-6 / (lily.inertia * omega) * (math.cos(phase) - np.cos(omega * time + phase))
    np.testing.assert_allclose(path[:, 0, YAW_RATE], rate, rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("name", "value"),
    [("1", 1.0), ("x", 0.7), ("y", -0.4), ("z", -1.3), ("t", 12.0), ("u", 0.05), ("v", -0.02), ("w", 0.01), ("r", 0.6),
     ("speed", math.sqrt(0.05**2 + 0.02**2 + 0.01**2)), ("thrust", 0.007), ("yaw_command", -0.001 * 0.0249694774856),
     ("pump", 0.02), ("pump_rate", 0.0), ("sin_yaw", math.sin(0.9)), ("cos_yaw", math.cos(0.9)),
     ("sin_t", math.sin(0.5 * 12.0)), ("cos_t", math.cos(0.5 * 12.0)), ("neighbour_distance", 0.3),
     ("wall_distance", 1.3)],
)  # fmt: skip
def test_every_regressor(acceleration: Make, lily: SimpleNamespace, name: str, value: float) -> None:
    """A heave force of a coefficient of 2 times the regressor, beside what the pump lifts."""
    state = {X: 0.7, Y: -0.4, Z: -1.3, YAW: 0.9, SURGE: 0.05, SWAY: -0.02, HEAVE: 0.01, YAW_RATE: 0.6}
    around = [[0.7, -0.4, -1.3, 0.0, 0.0], [0.7, -0.1, -1.3, 0.0, 0.0], [3.0, 3.0, -1.0, 0.0, 0.0]]
    numbers = law(2, 2.0, "heave", (name, 1, True), omega=0.5)
    rates = acceleration(numbers, state, (0.004, 0.003, 0.02), time=12.0, neighbours=around, own=0)
    assert rates[2] * lily.mass - 0.02 == pytest.approx(2.0 * value, rel=1e-9, abs=1e-15)


def test_every_regressor_is_tested() -> None:
    """The list above holds the whole table."""
    tested = {case[0] for case in test_every_regressor.pytestmark[0].args[1]}
    assert tested == set(REGRESSOR_CODE)


def test_without_neighbours_their_distance_does_nothing(acceleration: Make) -> None:
    """Nobody there is no infinite force."""
    assert acceleration(law(1, 1.0, "heave", ("neighbour_distance", 1, True)), {})[2] == 0.0


@pytest.mark.parametrize(
    ("equation", "expected"),
    [("surge", (1, 0, 0, 0)), ("sway", (0, 1, 0, 0)), ("heave", (0, 0, 1, 0)), ("yaw", (0, 0, 0, 1)),
     ("world_x", (math.cos(0.9), -math.sin(0.9), 0, 0)), ("world_y", (math.sin(0.9), math.cos(0.9), 0, 0)),
     ("world_z", (0, 0, 1, 0))],
)  # fmt: skip
def test_every_equation(acceleration: Make, lily: SimpleNamespace, equation: str, expected: Any) -> None:
    """A constant law acts on its equation alone; those of the world are turned into the body."""
    rates = acceleration(law(1, 1e-3, equation), {YAW: 0.9})
    inertia = [lily.mass] * 3 + [lily.inertia]
    np.testing.assert_allclose(rates * inertia, 1e-3 * np.array(expected), rtol=1e-9, atol=1e-18)


def test_products_and_amounts(acceleration: Make, lily: SimpleNamespace) -> None:
    """sway ~ u*|r|^2, with u backwards and r clockwise: the sign is u's."""
    numbers = law(1, 3.0, "sway", ("u", 1, True), ("r", 2, False))
    rates = acceleration(numbers, {SURGE: -0.05, YAW_RATE: -0.6})
    assert rates[1] - -(-0.05 * -0.6) == pytest.approx(3.0 * -0.05 * 0.36 / lily.mass, rel=1e-12)


def test_a_steep_law_is_rounded_off_at_zero(acceleration: Make, lily: SimpleNamespace) -> None:
    """Dry friction |r|^-1 r rounded off at s is r / sqrt(r^2 + s^2); without rounding it is the sign of r."""
    for rate in (0.3, 0.01, -0.02):
        for rounding, share in ((0.02, rate / math.hypot(rate, 0.02)), (0.0, math.copysign(1.0, rate))):
            numbers = law(1, -1e-5, "yaw", ("r", 0, True), round_1=rounding)
            change = acceleration(numbers, {YAW_RATE: rate})[3] - acceleration({}, {YAW_RATE: rate})[3]
            assert change == pytest.approx(-1e-5 * share / lily.inertia, rel=1e-9)


def test_the_rate_of_the_pump_is_its_step_in_the_end(swim: Make, lily: SimpleNamespace) -> None:
    """surge ~ pump_rate: the impulse of a whole step of the pump is c times the step, in any steps a tick."""
    for steps in (1, 6):
        path = swim(law(1, 0.1, "surge", ("pump_rate", 1, True)), {Z: -30.0}, [(0, 0, 0.3)] * 40, steps=steps)
        assert path[-1, 0, SURGE] == pytest.approx(0.1 * 0.3 * lily.pump / lily.mass, rel=1e-9)
