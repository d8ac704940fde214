"""A ship for tests: one propeller, a rudder that may stand behind it, and how it moves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move
from cocorosim_ros.world.state.state import STATE_SIZE, row_size
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles

SOURCE = "source: made, confidence: estimate"
MASS, INERTIA, DENSITY = 3000.0, 9000.0, 1000.0
FULL, DIAMETER = 60.0, 0.2  # N, m
AREA, ASPECT, STOCK, LARGEST = 0.05, 1.8, (-3.5, 0.25), np.radians(35.0)
SLOPE = 6.13 * ASPECT / (ASPECT + 2.25)
PROPELLER = f"""  - name: propeller
    kind: thruster
    position: {{value: [-3.4, 0, 0], unit: m, {SOURCE}}}
    direction: {{value: [1, 0, 0], unit: "1", {SOURCE}}}
    maximum: {{value: {FULL}, unit: N, {SOURCE}}}
"""
RUDDER = f"""  - name: rudder
    kind: rudder
    position: {{value: [{STOCK[0]}, {STOCK[1]}, 0], unit: m, {SOURCE}}}
    area: {{value: {AREA}, unit: m^2, {SOURCE}}}
    aspect_ratio: {{value: {ASPECT}, unit: "1", {SOURCE}}}
    largest_angle: {{value: 35, unit: deg, {SOURCE}}}
"""
BEHIND = f"""    propeller: propeller
    propeller_diameter: {{value: {DIAMETER}, unit: m, {SOURCE}}}
"""
SHIP = f"""\
name: ship
description: a ship
hull:
  length: {{value: 7, unit: m, {SOURCE}}}
  width: {{value: 1.2, unit: m, {SOURCE}}}
  height: {{value: 0.6, unit: m, {SOURCE}}}
mass: {{value: {MASS}, unit: kg, {SOURCE}}}
yaw_inertia: {{value: {INERTIA}, unit: kg m^2, {SOURCE}}}
drag: {{value: 25, unit: kg/m, {SOURCE}}}
yaw_drag: {{value: 3000, unit: N m s^2, {SOURCE}}}
water_density: {{value: {DENSITY}, unit: kg/m^3, {SOURCE}}}
gravity: {{value: 9.81, unit: m/s^2, {SOURCE}}}
actuators:
"""


def number(value: float, unit: str = "1", more: str = "") -> str:
    """A number of a platform file."""
    return f"{{value: {value}, unit: '{unit}', {more}{SOURCE}}}"


def ship(folder: Path, actuators: str, more: str = "") -> Any:
    """The ship with these actuators and these further keys, loaded."""
    path = folder / "ship.yaml"
    path.write_text(SHIP + actuators + "sensors: {}\n" + more)
    return load_platform(path)


def run(platform: Any, commands: Any, start: Any = (), step: float = 0.05) -> Any:
    """(ticks + 1, columns) rows of the ship alone, commands (ticks, actuators) of 0.5 s each; start: u, v, r."""
    count = len(platform.actuators)
    vehicles = build_vehicles([platform])
    tank = Tank(np.full(3, -1e9), np.full(3, 1e9), np.zeros((0, 4)), np.zeros((0, 6)))
    state = np.zeros((1, 1, row_size(count)))
    state[0, 0, 2] = -1.0
    state[0, 0, [4, 5, 7]] = start or (0.0, 0.0, 0.0)
    rows = [state[0, 0].copy()]
    for tick, command in enumerate(commands):
        apply_commands(state, np.array(command, dtype=float)[None, None], vehicles)
        move(state, vehicles, tank, Stepping(0, round(0.5 / step), step, 1), np.zeros(0), 0.5 * tick)
        rows.append(state[0, 0].copy())
    return np.array(rows)


def wrench(platform: Any, command: Any, speed: Any) -> Any:
    """X, Y, N [N, N, N m] on the ship at u, v, r under a command, without drag."""
    from cocorosim_ros.world.motion.dynamics import state_rate
    from cocorosim_ros.world.vehicle_model.vehicles import PARAMETER_COLUMNS, Body

    vehicles, count = build_vehicles([platform]), len(platform.actuators)
    for name in ("drag", "yaw_drag"):
        vehicles.parameters[..., PARAMETER_COLUMNS[name]] = 0.0
    state, rate = np.zeros((1, 1, row_size(count))), np.zeros(row_size(count))
    u, v, r = speed
    state[0, 0, [4, 5, 7]] = speed
    apply_commands(state, np.array(command, dtype=float)[None, None], vehicles)
    own = [part[0, 0] for part in vehicles]
    nowhere = (np.zeros(0), np.full(3, -1e9), np.full(3, 1e9), np.zeros((0, 5)), -1)
    state_rate(state[0, 0], 0.0, Body(own[0], int(own[1]), *own[2:], *nowhere), rate)
    return np.array([MASS * (rate[4] - v * r), MASS * (rate[5] + u * r), INERTIA * rate[7]])


def delivered(rows: Any, count: int) -> Any:
    """What the actuators of rows deliver."""
    return rows[..., STATE_SIZE : STATE_SIZE + count]
