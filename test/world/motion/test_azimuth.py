"""What turns a thruster: its force by hand, half a turn as reverse, means over a jump, and the sentences."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from ships import FULL, PROPELLER, SOURCE, delivered, number, run, ship, wrench

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import platform_tree, read_platform
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml, yaml_text
from cocorosim_ros.world.vehicle_model.curves import forces_at

TURN = f"""  - name: turn
    kind: azimuth
    thruster: propeller
    largest_angle: {number(180, "deg")}
"""
POD = PROPELLER.replace("[-3.4, 0, 0]", "[-3.4, 0.5, 0]") + TURN


@pytest.mark.parametrize("angle", [-170.0, -90.0, -20.0, 0.0, 45.0, 90.0, 180.0])
def test_the_force_follows_the_angle(tmp_path: Path, angle: float) -> None:
    """(X, Y) = F (cos a, sin a), N = x Y - y X with the place of the thruster."""
    found = wrench(ship(tmp_path, POD), [0.5, angle / 180.0], (0.0, 0.0, 0.0))
    along, across = 0.5 * FULL * math.cos(math.radians(angle)), 0.5 * FULL * math.sin(math.radians(angle))
    np.testing.assert_allclose(found, [along, across, -3.4 * across - 0.5 * along], atol=1e-12)


def test_at_zero_nothing_changes(tmp_path: Path) -> None:
    """At angle zero the ship moves bit for bit as with a fixed thruster."""
    turned = run(ship(tmp_path, POD), [(0.7, 0.0)] * 40)
    fixed = run(ship(tmp_path, POD.replace(TURN, "")), [(0.7,)] * 40)
    assert np.array_equal(turned[:, :8], fixed[:, :8])


def test_a_mirrored_angle_is_a_mirrored_course(tmp_path: Path) -> None:
    """On the centre line y, yaw, v and r change their signs."""
    platform = ship(tmp_path, PROPELLER + TURN)
    angles = 0.3 * np.sin(0.2 * np.arange(100))
    left, right = (run(platform, [(0.8, sign * angle) for angle in angles])[:, :8] for sign in (1.0, -1.0))
    np.testing.assert_allclose(left * [1, -1, 1, -1, 1, -1, 1, -1], right, atol=1e-12)


def test_half_a_turn_is_reverse(tmp_path: Path) -> None:
    """At 180 deg to either side, and at command -1, the ship goes the same way backwards."""
    platform = ship(tmp_path, PROPELLER + TURN)
    courses = [run(platform, [command] * 40)[-1, :8] for command in ((1.0, 1.0), (1.0, -1.0), (-1.0, 0.0))]
    np.testing.assert_allclose(courses[0], courses[2], atol=1e-12)
    np.testing.assert_allclose(courses[1], courses[2], atol=1e-12)


def test_a_lag_is_of_the_thrust_and_not_of_the_angle(tmp_path: Path) -> None:
    """Behind a lag the thrust grows by 1 - exp(-t / tau) in the direction of the angle at once."""
    lag = f"effects:\n  thruster_lag: {{time_constant: {number(2.0, 's')}}}\n"
    found = delivered(run(ship(tmp_path, POD, lag), [(1.0, 0.25)] * 6), 2)[1:]
    expected = FULL * -np.expm1(-0.5 * np.arange(1, 7) / 2.0) * math.sqrt(0.5)
    np.testing.assert_allclose(found, np.stack([expected, expected], axis=1), rtol=1e-9)


def test_the_forces_of_many_commands(tmp_path: Path) -> None:
    """The table of forces at commands is that of single ones."""
    platform, commands = ship(tmp_path, POD), np.random.default_rng(1).uniform(-1.0, 1.0, (20, 2))
    many = forces_at(platform, commands) @ platform.actuator_wrenches()
    single = np.array([wrench(platform, command, (0.0, 0.0, 0.0)) for command in commands])
    np.testing.assert_allclose(many[:, [0, 1, 3]], single, atol=1e-11)


def test_azimuths_and_rudders_are_written_and_read_back(tmp_path: Path) -> None:
    """The same after a round trip."""
    from ships import BEHIND, RUDDER

    platform = ship(tmp_path, POD + RUDDER + BEHIND)
    assert read_platform(parse_yaml(yaml_text(platform_tree(platform)), "x.yaml")) == platform


BAD = {
    TURN: r"'propeller', which is no thruster of this platform",
    PROPELLER + TURN + TURN.replace("name: turn", "name: other"): r"'propeller', which 'turn' turns already",
    PROPELLER.replace("[1, 0, 0]", "[0, 0, 1]") + TURN: r"does not push horizontally",
    PROPELLER + TURN.replace("thruster: propeller", f"thruster: {number(1)}"): r"'actuators\[1\].thruster'",
    PROPELLER + TURN.replace(SOURCE, "confidence: estimate"): r"largest_angle.*source",
}


@pytest.mark.parametrize("actuators", BAD)
def test_an_azimuth_that_cannot_be_is_a_sentence(tmp_path: Path, actuators: str) -> None:
    """Each names the file, the key and what to write."""
    with pytest.raises(CocorosimError, match=BAD[actuators]) as caught:
        ship(tmp_path, actuators)
    assert "ship.yaml" in str(caught.value)
