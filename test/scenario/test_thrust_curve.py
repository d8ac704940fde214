"""Curves of thrusters in platform files: what they mean, and the sentences about those that no command can follow."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform, platform_tree, read_platform
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml, yaml_text
from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move
from cocorosim_ros.world.state.state import STATE_SIZE, SURGE, row_size
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles

SOURCE = "source: made, confidence: estimate"
TABLE = "{form: table, commands: {value: [%s], unit: '1', source: made}, forces: {value: [%s], unit: N, source: made}}"
BOAT = f"""\
name: boat
description: one propeller
hull:
  length: {{value: 1, unit: m, {SOURCE}}}
  width: {{value: 0.5, unit: m, {SOURCE}}}
  height: {{value: 0.2, unit: m, {SOURCE}}}
mass: {{value: 10, unit: kg, {SOURCE}}}
yaw_inertia: {{value: 1, unit: kg m^2, {SOURCE}}}
drag: {{value: 4, unit: kg/m, {SOURCE}}}
yaw_drag: {{value: 1, unit: N m s^2, {SOURCE}}}
water_density: {{value: 1000, unit: kg/m^3, {SOURCE}}}
gravity: {{value: 9.81, unit: m/s^2, {SOURCE}}}
actuators:
  - name: stern
    kind: thruster
    position: {{value: [-0.4, 0, 0], unit: m, {SOURCE}}}
    direction: {{value: [1, 0, 0], unit: "1", {SOURCE}}}
    maximum: {{value: 16, unit: N, {SOURCE}}}
    maximum_reverse: {{value: 8, unit: N, {SOURCE}}}
    curve: CURVE
sensors: {{}}
"""


def boat(tmp_path: Path, curve: str) -> Any:
    """The boat with this curve, loaded."""
    path = tmp_path / "boat.yaml"
    path.write_text(BOAT.replace("CURVE", curve))
    return load_platform(path)


def forces(platform: Any, commands: Any) -> Any:
    """What the propeller gives at each command [N]."""
    vehicles, found = build_vehicles([platform]), []
    for command in commands:
        state = np.zeros((1, 1, row_size(1)))
        apply_commands(state, np.full((1, 1, 1), float(command)), vehicles)
        found.append(state[0, 0, STATE_SIZE])
    return np.array(found)


COMMANDS = np.linspace(-1.0, 1.0, 41)
FULL = np.where(COMMANDS >= 0.0, 16.0, 8.0)


def test_the_square_keeps_the_sign(tmp_path: Path) -> None:
    """F = F_max c |c|, as of a propeller whose command is its rate of turn."""
    found = forces(boat(tmp_path, "{form: square}"), COMMANDS)
    np.testing.assert_allclose(found, FULL * COMMANDS * np.abs(COMMANDS), rtol=1e-15, atol=1e-18)


@pytest.mark.parametrize(("form", "power"), [("linear", 1), ("square", 2)])
def test_beyond_a_dead_band_the_force_grows_from_nothing(tmp_path: Path, form: str, power: int) -> None:
    """Nothing within 0.2; at 0.6, half of the way, half of the force or a quarter; at 1 all of it."""
    platform = boat(tmp_path, f"{{form: {form}, dead_band: {{value: 20, unit: '%', {SOURCE}}}}}")
    found = forces(platform, [-1.0, -0.6, -0.2, -0.1, 0.0, 0.199, 0.6, 1.0])
    np.testing.assert_allclose(found, [-8, -8 * 0.5**power, 0, 0, 0, 0, 16 * 0.5**power, 16], atol=1e-14)


def test_a_table_is_straight_between_its_points(tmp_path: Path) -> None:
    """As NumPy interpolates the forces, below and above zero."""
    commands, told = [-1, -0.4, -0.1, 0, 0.1, 0.5, 1], [-8, -2, 0, 0, 0, 5, 16]
    platform = boat(tmp_path, TABLE % (", ".join(map(str, commands)), ", ".join(map(str, told))))
    np.testing.assert_allclose(forces(platform, COMMANDS), np.interp(COMMANDS, commands, told), atol=1e-14)


def test_a_table_of_a_smooth_curve(tmp_path: Path) -> None:
    """Forty points of a curve foretell it to the error of a straight piece, f'' h^2 / 8 = 16 (2) 0.05^2 / 8."""
    points = np.linspace(0.0, 1.0, 21)
    curve = PchipInterpolator(points, 16.0 * points**2)
    told = curve(points)
    text = TABLE % (", ".join(map(repr, points.tolist())), ", ".join(map(repr, told.tolist())))
    path = tmp_path / "boat.yaml"
    path.write_text(BOAT.replace("CURVE", text).replace("{value: 8, unit: N", "{value: 0, unit: N"))
    between = np.linspace(0.0, 1.0, 101)
    error = np.abs(forces(load_platform(path), between) - 16.0 * between**2)
    assert error.max() <= 16.0 * 2.0 * 0.05**2 / 8.0 + 1e-12


def test_the_speed_under_half_a_command(tmp_path: Path) -> None:
    """At rest after a long time k u^2 = F_max c^2: u = c sqrt(F_max / k)."""
    vehicles = build_vehicles([boat(tmp_path, "{form: square}")])
    tank = Tank(np.full(3, -1e9), np.full(3, 1e9), np.zeros((0, 4)), np.zeros((0, 6)))
    state = np.zeros((1, 1, row_size(1)))
    apply_commands(state, np.full((1, 1, 1), 0.5), vehicles)
    for _ in range(400):
        move(state, vehicles, tank, Stepping(0, 2, 0.1, 1), np.zeros(0), 0.0)
    assert state[0, 0, SURGE] == pytest.approx(0.5 * np.sqrt(16.0 / 4.0), rel=1e-12)


def test_a_gain_multiplies_all_of_it(tmp_path: Path) -> None:
    """Three quarters of the force at every command, forwards and backwards."""
    curve = f"{{form: square}}\n    gain: {{value: 0.75, unit: '1', range: [0.5, 1], {SOURCE}}}"
    platform = boat(tmp_path, curve)
    np.testing.assert_allclose(forces(platform, COMMANDS), 0.75 * FULL * COMMANDS * np.abs(COMMANDS), atol=1e-15)
    assert platform.ranges["actuators.stern.gain"].low == 0.5


def test_curves_are_written_and_read_back(tmp_path: Path) -> None:
    """A platform with a table and one with a dead band are the same after a round trip."""
    for curve in (
        TABLE % ("0, 0.5, 1", "0, 5, 16"),
        f"{{form: square, dead_band: {{value: 0.1, unit: '1', {SOURCE}}}}}",
    ):
        path = tmp_path / "boat.yaml"
        path.write_text(BOAT.replace("CURVE", curve).replace("{value: 8, unit: N", "{value: 0, unit: N"))
        platform = load_platform(path)
        assert read_platform(parse_yaml(yaml_text(platform_tree(platform)), "x.yaml")) == platform


BAD = {
    "{form: cube}": r"'actuators\[0\].curve.form'.*'cube'.*linear, square, table",
    "{form: square, dead_band: {value: 1, unit: '1', source: made}}": r"dead_band.*below 1",
    "{form: square, commands: {value: [0, 1], unit: '1', source: made}}": r"commands.*form: table.*'square'",
    TABLE % ("0, 1", "0, 5, 16"): r"2 commands and 3 forces",
    TABLE % ("0, 0.5, 0.5, 1", "0, 1, 2, 16"): r"do not ascend",
    TABLE % ("-0.5, 0, 1", "-8, 0, 16"): r"from -0.5 to 1.*from -1 to 1",
    TABLE % ("-1, 0, 1", "-8, 1, 16"): r"0 N at command 0",
    TABLE % ("-1, 0, 1", "8, 0, 16"): r"against its command",
    TABLE % ("-1, 0, 1", "-8, 0, 15"): r"'maximum' 16 N, and 15 N in the table",
    TABLE % ("-1, 0, 1", "-7, 0, 16"): r"'maximum_reverse' 8 N, and 7 N in the table",
    "{form: table, dead_band: {value: 0.1, unit: '1', source: made}}": r"dead_band.*beside a table",
}


@pytest.mark.parametrize("curve", BAD)
def test_a_curve_that_cannot_be_is_a_sentence(tmp_path: Path, curve: str) -> None:
    """Each names the file, the key and what to write."""
    with pytest.raises(CocorosimError, match=BAD[curve]) as caught:
        boat(tmp_path, curve)
    assert "boat.yaml" in str(caught.value)


DATA = Path(__file__).resolve().parents[3] / "shared" / "data"


@pytest.mark.skipif(not DATA.is_dir(), reason="the recordings of others are not on this machine")
def test_the_published_table_of_a_thruster(tmp_path: Path) -> None:
    """The maker's table of a T200 at 16 V, PWM to force, as a curve: the published force at every PWM."""
    rows = np.genfromtxt(DATA / "t200_thruster" / "T200_16_V.csv", delimiter=",", skip_header=1, usecols=(0, 5))
    command, force = (rows[:, 0] - 1500.0) / 400.0, 9.80665 * rows[:, 1]
    force[np.abs(command) < 0.05] = 0.0  # the dead band, where single readings have the other sign
    text = TABLE % (", ".join(map(repr, command.tolist())), ", ".join(map(repr, force.tolist())))
    path = tmp_path / "boat.yaml"
    limits = (f"{{value: {float(force[-1])!r}, unit: N", f"{{value: {-float(force[0])!r}, unit: N")
    text = BOAT.replace("CURVE", text).replace("{value: 16, unit: N", limits[0])
    path.write_text(text.replace("{value: 8, unit: N", limits[1]))
    np.testing.assert_allclose(forces(load_platform(path), command), force, atol=1e-12)
