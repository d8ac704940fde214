"""Fins of a vehicle in four degrees of freedom by closed forms, and beside the same fins in six."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ships import DENSITY, FULL, INERTIA, MASS, PROPELLER, SOURCE, number, run, ship, wrench

from cocorosim_ros.scenario.parts.platform import load_platform, platform_tree, read_platform
from cocorosim_ros.scenario.reading.entry import entry_of

AREA, LIFT, LARGEST, PLACE = 0.04, 3.0, math.radians(20.0), (-3.0, 0.4, 0.1)
COEFFICIENT = 0.5 * DENSITY * AREA * LIFT
SIDEWAYS, UPWARDS, SLANTED = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.6, -0.8)
SPEEDS = [(1.1, 0.0, 0.0), (0.8, -0.15, 0.05), (0.4, 0.3, -0.1), (-0.5, 0.1, 0.02)]


def fin(name: str, direction: Any, more: str = "") -> str:
    """A fin of a platform file."""
    return f"""  - name: {name}
    kind: fin
    position: {{value: {list(PLACE)}, unit: m, {SOURCE}}}
    direction: {{value: {list(direction)}, unit: "1", {SOURCE}}}
    area: {{value: {AREA}, unit: m^2, {SOURCE}}}
    lift_slope: {{value: {LIFT}, unit: 1/rad, {SOURCE}}}
    largest_angle: {{value: 20, unit: deg, {SOURCE}}}
{more}"""


@pytest.mark.parametrize("direction", [SIDEWAYS, UPWARDS, SLANTED])
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("share", [-1.0, 0.0, 0.4])
def test_the_lift_at_a_lever(tmp_path: Path, direction: Any, speed: Any, share: float) -> None:
    """F = c |V_x| (V_x d - n V) with V = v + r x p, by vector products; X, Y and the moment about z."""
    flow = np.array([speed[0], speed[1], 0.0]) + np.cross([0.0, 0.0, speed[2]], PLACE)
    lift = COEFFICIENT * abs(flow[0]) * (flow[0] * share * LARGEST - flow @ direction)
    force = lift * np.array(direction)
    expected = [force[0], force[1], np.cross(PLACE, force)[2]]
    found = wrench(ship(tmp_path, fin("plane", direction)), [share], speed)
    np.testing.assert_allclose(found, expected, rtol=1e-8, atol=1e-8)


def test_a_stern_plane_lifts(tmp_path: Path) -> None:
    """Held at a speed ahead by its thrust, a vehicle rises until the plane meets the water without lift: w = u d.

    There it rises with drag: c u (u d - w) = k V w, and T = k V u; with V = sqrt(u^2 + w^2).
    """
    rows = run(ship(tmp_path, PROPELLER + fin("plane", UPWARDS)), [(1.0, 0.5)] * 4000, step=0.25)
    u, w = rows[-1, 4], rows[-1, 6]
    speed, drag = math.hypot(u, w), 25.0
    assert FULL == pytest.approx(drag * speed * u, rel=1e-9)
    assert COEFFICIENT * u * (0.5 * LARGEST * u - w) == pytest.approx(drag * speed * w, rel=1e-9)
    assert 0.0 < w < 0.5 * LARGEST * u


def test_heave_settles_at_the_rate_of_the_fin(tmp_path: Path) -> None:
    """Without thrust change, w follows w_dot = c u (u d - w) / m while it is small: the first tick by hand."""
    rows = run(ship(tmp_path, fin("plane", UPWARDS)), [(1.0,)], start=(1.0, 0.0, 0.0), step=1e-3)
    mean = COEFFICIENT * LARGEST / MASS
    assert rows[-1, 6] == pytest.approx(0.5 * mean, rel=0.03)  # c u / m, k V / m and the loss of u take 1.5 % of it


def test_a_gain_and_a_second_fin_add_up(tmp_path: Path) -> None:
    """Half the gain is half the lift; two fins at opposite angles across the flow cancel."""
    gain = f"    gain: {number(0.5, '1', 'range: [0.2, 2], ')}\n"
    platform = ship(tmp_path, fin("rudders", SIDEWAYS, gain))
    assert platform.ranges["actuators.rudders.gain"].low == 0.2
    one = wrench(platform, [1.0], (1.0, 0.0, 0.0))
    whole = wrench(ship(tmp_path, fin("rudders", SIDEWAYS)), [1.0], (1.0, 0.0, 0.0))
    np.testing.assert_allclose(one, 0.5 * whole, rtol=1e-12)
    both = wrench(ship(tmp_path, fin("a", SIDEWAYS) + fin("b", SIDEWAYS)), [1.0, -1.0], (1.0, 0.0, 0.0))
    np.testing.assert_allclose(both, 0.0, atol=1e-12)
    assert read_platform(entry_of(platform_tree(platform), "written")) == platform


def test_amidships_nothing_changes(tmp_path: Path) -> None:
    """Straight ahead with the fins at zero the ship moves bit for bit as without them."""
    with_fins = run(ship(tmp_path, PROPELLER + fin("a", SIDEWAYS) + fin("b", UPWARDS)), [(1.0, 0.0, 0.0)] * 60)
    without = run(ship(tmp_path, PROPELLER), [(1.0,)] * 60)
    assert np.array_equal(with_fins[:, :8], without[:, :8])


def test_the_rudders_of_a_torpedo_turn_it_in_four_degrees_too(tmp_path: Path) -> None:
    """Of REMUS 100 without six_degrees: Y_uudr 9.64 kg/m and N_uudr -6.15 kg of Prestero (2001)."""
    text = (Path(__file__).parents[3] / "config/platforms/remus100.yaml").read_text("utf-8")
    path = tmp_path / "torpedo.yaml"
    path.write_text(text[: text.index("six_degrees:\n")] + text[text.index("actuators:\n") :])
    platform, lift = load_platform(path), 1.5**2 * math.radians(13.6)
    found = wrench(platform, [0.0, 1.0, 0.0], (1.5, 0.0, 0.0))  # as of the ship's mass and inertia
    assert found[1] * platform.mass / MASS == pytest.approx(9.64 * lift, rel=1e-3)
    assert found[2] * platform.yaw_inertia / INERTIA == pytest.approx(-6.15 * lift, rel=1e-3)
