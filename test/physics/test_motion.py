"""Commands become forces: clipped, off for NaN, unequal where forwards and backwards differ."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

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
