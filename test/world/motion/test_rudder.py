"""A rudder by closed forms: its force by hand, a mirrored angle, the energy that it takes, steady turns."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ships import (
    AREA,
    BEHIND,
    DENSITY,
    DIAMETER,
    FULL,
    INERTIA,
    LARGEST,
    MASS,
    PROPELLER,
    RUDDER,
    SLOPE,
    STOCK,
    number,
    run,
    ship,
    wrench,
)

from cocorosim_ros.foundation.errors import CocorosimError

SPEEDS = [(1.1, 0.0, 0.0), (0.8, -0.15, 0.05), (0.4, 0.3, -0.1), (-0.5, 0.1, 0.02)]
NUMBERS = {
    "gain": 0.9, "wake": 0.35, "acceleration": 0.5, "coverage": 0.63, "straightening": 0.6, "inflow_arm": -5.0,
    "drag_share": 0.6, "hull_gain": 0.31, "hull_position": -3.2,
}  # fmt: skip
MMG = RUDDER + BEHIND + "".join(
    f"    {name}: {number(value, 'm' if name in ('inflow_arm', 'hull_position') else '1')}\n"
    for name, value in NUMBERS.items()
)  # fmt: skip


def by_hand(angle: float, speed: Any, u_r: float, n: dict[str, float]) -> Any:
    """X, Y, N of MMG's normal force with an angle of attack, as the paper writes it (all signs to the left)."""
    _, v, r = speed
    v_r = n["straightening"] * (v + n["inflow_arm"] * r)
    attack = angle + math.atan2(v_r, u_r)
    force = n["gain"] * 0.5 * DENSITY * AREA * SLOPE * (u_r**2 + v_r**2) * math.sin(attack)
    along, across = -n["drag_share"] * force * math.sin(angle), -force * math.cos(angle)
    moment = (STOCK[0] + n["hull_gain"] * n["hull_position"]) * across - STOCK[1] * along
    return np.array([along, (1.0 + n["hull_gain"]) * across, moment])


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("share", [-1.0, -0.3, 0.0, 0.5])
def test_the_force_of_a_rudder_alone(tmp_path: Path, speed: Any, share: float) -> None:
    """Without propeller and hull: the flow is that at the stock."""
    plain = {"gain": 1.0, "straightening": 1.0, "inflow_arm": STOCK[0], "drag_share": 1.0, "hull_gain": 0.0,
             "hull_position": 0.0}  # fmt: skip
    found = wrench(ship(tmp_path, RUDDER), [share], speed)
    np.testing.assert_allclose(found, by_hand(share * LARGEST, speed, speed[0], plain), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("speed", SPEEDS[:3])
def test_the_force_behind_a_propeller(tmp_path: Path, speed: Any) -> None:
    """u_R by the paper's own equation, with K_T and J of the thrust: they do not depend on the rate of turn."""
    platform, thrust, rate = ship(tmp_path, PROPELLER + MMG), 0.7 * FULL, 9.0
    found = wrench(platform, [0.7, 0.4], speed) - [thrust, 0.0, 0.0]
    advance = (1.0 - NUMBERS["wake"]) * speed[0]
    coefficient, ratio = thrust / (DENSITY * rate**2 * DIAMETER**4), advance / (rate * DIAMETER)
    jet = 1.0 + NUMBERS["acceleration"] * (math.sqrt(1.0 + 8.0 * coefficient / (math.pi * ratio**2)) - 1.0)
    u_r = advance * math.sqrt(NUMBERS["coverage"] * jet**2 + (1.0 - NUMBERS["coverage"]))
    np.testing.assert_allclose(found, by_hand(0.4 * LARGEST, speed, u_r, NUMBERS), rtol=1e-9, atol=1e-9)


def test_a_propeller_drives_a_rudder_at_rest(tmp_path: Path) -> None:
    """At no speed the flow is that of the jet alone, sqrt(8 T / (pi rho D^2)); behind a stopped one there is none."""
    platform = ship(tmp_path, PROPELLER + RUDDER + BEHIND)
    jet = math.sqrt(8.0 * FULL / (math.pi * DENSITY * DIAMETER**2))
    force = 0.5 * DENSITY * AREA * SLOPE * jet**2 * math.sin(LARGEST)
    found = wrench(platform, [1.0, 1.0], (0.0, 0.0, 0.0))
    assert found[1] == pytest.approx(-force * math.cos(LARGEST), rel=1e-12)
    assert wrench(platform, [0.0, 1.0], (0.0, 0.0, 0.0)).tolist() == [0.0, 0.0, 0.0]


def test_amidships_nothing_changes(tmp_path: Path) -> None:
    """Straight ahead with the rudder at zero the ship moves bit for bit as without one."""
    commands = [(1.0, 0.0)] * 60
    with_rudder = run(ship(tmp_path, PROPELLER + MMG), commands)
    without = run(ship(tmp_path, PROPELLER), [row[:1] for row in commands])
    assert np.array_equal(with_rudder[:, :8], without[:, :8])


def test_a_mirrored_angle_is_a_mirrored_course(tmp_path: Path) -> None:
    """With the stock on the centre line: y, yaw, v and r change their signs, x and u stay."""
    platform = ship(tmp_path, PROPELLER + MMG.replace(f", {STOCK[1]}, 0]", ", 0, 0]"))
    angles = np.sin(0.2 * np.arange(120))
    left, right = (run(platform, [(0.8, sign * angle) for angle in angles])[:, :8] for sign in (1.0, -1.0))
    np.testing.assert_allclose(left * [1, -1, 1, -1, 1, -1, 1, -1], right, atol=1e-12)
    assert left[20, 3] > 0.0


@pytest.mark.parametrize("speed", SPEEDS)
def test_a_rudder_takes_energy_exactly(tmp_path: Path, speed: Any) -> None:
    """Power of a free rudder: -1/2 rho A f U_R (u_R sin d + v_R cos d)^2; no drag, no hull, no propeller."""
    for share in (-0.8, 0.1, 1.0):
        platform = ship(tmp_path, RUDDER.replace(f", {STOCK[1]}, 0]", ", 0, 0]"))
        force = wrench(platform, [share], speed)
        u, v = speed[0], speed[1] + STOCK[0] * speed[2]
        across = u * math.sin(share * LARGEST) + v * math.cos(share * LARGEST)
        expected = -0.5 * DENSITY * AREA * SLOPE * math.hypot(u, v) * across**2
        assert float(force @ speed) == pytest.approx(expected, rel=1e-9)


def test_a_coasting_ship_only_slows_down(tmp_path: Path) -> None:
    """Kinetic energy falls at every tick, whatever the rudder does."""
    platform = ship(tmp_path, RUDDER)
    rows = run(platform, [(math.sin(0.5 * tick),) for tick in range(200)], start=(1.0, 0.2, 0.1))
    energy = 0.5 * MASS * (rows[:, 4] ** 2 + rows[:, 5] ** 2) + 0.5 * INERTIA * rows[:, 7] ** 2
    assert np.all(np.diff(energy) < 0.0)


def test_a_steady_turn_is_in_balance(tmp_path: Path) -> None:
    """After a long time under a constant angle all forces by hand sum to the centripetal ones."""
    platform = ship(tmp_path, PROPELLER + RUDDER)
    rows = run(platform, [(1.0, 0.6)] * 4000, step=0.25)
    u, v, r = rows[-1, [4, 5, 7]]
    plain = {"gain": 1.0, "straightening": 1.0, "inflow_arm": STOCK[0], "drag_share": 1.0, "hull_gain": 0.0,
             "hull_position": 0.0}  # fmt: skip
    steering, speed = by_hand(0.6 * LARGEST, (u, v, r), u, plain), math.hypot(u, v)
    assert FULL + steering[0] - 25.0 * speed * u == pytest.approx(-MASS * v * r, abs=1e-6)
    assert steering[1] - 25.0 * speed * v == pytest.approx(MASS * u * r, abs=1e-6)
    assert steering[2] == pytest.approx(3000.0 * r * abs(r), abs=1e-6)
    assert r > 0.0


def test_a_thrust_that_falls_with_speed_drives_a_weaker_jet(tmp_path: Path) -> None:
    """With advance_loss the rudder stands in the jet of the thrust at speed."""
    loss = f"effects:\n  advance_loss: {{slope: {number(0.3, 's/m')}}}\n"
    speed = (1.0, 0.0, 0.0)
    at_speed = wrench(ship(tmp_path, PROPELLER + MMG, loss), [1.0, 0.5], speed)
    weaker = wrench(ship(tmp_path, PROPELLER + MMG), [0.7, 0.5], speed)
    np.testing.assert_allclose(at_speed, weaker, rtol=1e-12)


BAD = {
    RUDDER.replace("value: 35", "value: 90"): r"'actuators\[0\].largest_angle'.*less than 90 deg",
    RUDDER.replace("value: 0.05", "value: 0"): r"'actuators\[0\].area'.*greater than zero",
    PROPELLER + RUDDER + BEHIND.replace("propeller: propeller", "propeller: propeler"): r"'propeler'.*did you mean",
    PROPELLER + RUDDER + "    propeller: propeller\n": r"lacks 'propeller_diameter'",
    RUDDER + f"    coverage: {number(0.5)}\n": r"coverage.*no 'propeller' is named",
    PROPELLER + RUDDER + BEHIND + f"    wake: {number(1.5)}\n": r"wake.*from 0 to 1",
    RUDDER + RUDDER.replace("name: rudder", "name: b") + RUDDER.replace("name: rudder", "name: c"): r"has 3 rudders; 2",
}


@pytest.mark.parametrize("actuators", BAD)
def test_a_rudder_that_cannot_be_is_a_sentence(tmp_path: Path, actuators: str) -> None:
    """Each names the file, the key and what to write."""
    with pytest.raises(CocorosimError, match=BAD[actuators]) as caught:
        ship(tmp_path, actuators)
    assert "ship.yaml" in str(caught.value)
