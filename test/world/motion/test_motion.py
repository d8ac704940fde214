"""Commands become forces: clipped, off for NaN, unequal where forwards and backwards differ."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

Make = Callable[..., Any]


@pytest.mark.parametrize(
    ("fraction", "share"),
    [(0.0, 0.0), (0.3, 0.3), (-0.3, -0.3), (1.0, 1.0), (-1.0, -1.0), (5.0, 1.0), (-5.0, -1.0),
     (math.inf, 1.0), (-math.inf, -1.0), (math.nan, 0.0)],
)  # fmt: skip
def test_a_command_is_a_clipped_fraction_of_the_maximum(
    make_simulation: Make, lily: SimpleNamespace, fraction: float, share: float
) -> None:
    """Beyond -1..1 the maximum holds; NaN switches off; the other actuators are not concerned."""
    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.0]]])
    simulation.command[0, 0] = (fraction, 0.5, 0.0)
    simulation.advance()
    expected = [share * lily.thrust, 0.5 * lily.thrust, 0.0]
    assert simulation.state[0, 0, 8:11].tolist() == pytest.approx(expected, abs=1e-18)


def test_backwards_has_its_own_maximum(make_simulation: Make) -> None:
    """An actuator of 5 mN forwards and 3 mN backwards gives -1.5 mN at -0.5."""
    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.0]]])
    simulation.world.vehicles.actuator_limit[..., 1] = 0.003
    simulation.command[0, 0] = (-0.5, 0.5, 0.0)
    simulation.advance()
    assert simulation.state[0, 0, 8:10].tolist() == pytest.approx([-0.0015, 0.0025])


def test_time_is_whole_ticks(make_simulation: Make) -> None:
    """After seven ticks of 0.5 s the clock shows 3.5 s in whole nanoseconds."""
    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.0]]])
    for _ in range(7):
        simulation.advance()
    assert simulation.time_ns == 3_500_000_000


@pytest.mark.parametrize("robots", [1, 4, 5, 13, 24])
@pytest.mark.parametrize("patches", [False, True])
def test_four_robots_in_one_vector_move_as_each_alone(
    make_simulation: Make, crowd: Make, robots: int, patches: bool
) -> None:
    """Bit for bit, in the tank's corners too: an effect of the catalogue on one robot makes all others go alone."""
    from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PATCH_FORCE_COLUMNS

    pair = [make_simulation(crowd(7, robots), bounds=((-1.0, -1.0, -2.0), (1.0, 1.0, 0.0))) for _ in range(2)]
    for simulation in pair:
        generator, vehicles = np.random.default_rng(3), simulation.world.vehicles
        vehicles.parameters[..., PATCH_FORCE_COLUMNS] = generator.normal(0.0, 0.005, (7, robots, 4))
        vehicles.active[...] |= EFFECT_BIT["patch_force"] if patches else 0
        simulation.state[..., 3:8] = generator.normal(0.0, 1.0, (7, robots, 5))
        simulation.state[::2, 0, 3] = 1e7  # rad, where another sine is asked
    pair[1].world.vehicles.active[...] |= EFFECT_BIT["linear_drag"]  # of zero
    for _ in range(9):
        for simulation in pair:
            simulation.command[...] = np.random.default_rng(simulation.tick).uniform(-1.2, 1.2, (7, robots, 3))
            simulation.advance()
        assert pair[0].state.tobytes() == pair[1].state.tobytes()
