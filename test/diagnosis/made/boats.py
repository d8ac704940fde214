"""Made boats: a planar vehicle with drag by each axis' own speed, integrated by SciPy and not by the simulator."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

ARM, FULL, MASS, INERTIA = 0.25, 20.0, 12.0, 1.5  # m, N, kg, kg m^2
STEP, TICK = 0.05, 0.5  # s
NOISE = (0.005, 0.005, 0.005, 0.01)  # m, m, m, rad of one pose

PLATFORM = """
name: boat
description: a made boat with two propellers
hull: {{length: {{value: 1.0, unit: m, source: made}}, width: {{value: 0.5, unit: m, source: made}},
  height: {{value: 0.2, unit: m, source: made}}}}
mass: {{value: 12, unit: kg, source: made}}
yaw_inertia: {{value: 1.5, unit: kg m^2, source: made}}
drag: {{value: 8.5, unit: kg/m, range: [6, 10], source: made}}
yaw_drag: {{value: 0.2, unit: N m s^2, source: made}}
water_density: {{value: 1000, unit: kg/m^3, source: made}}
gravity: {{value: 9.81, unit: m/s^2, source: made}}
actuators:
  - name: left
    kind: thruster
    position: {{value: [-0.4, 0.25, 0], unit: m, source: made}}
    direction: {{value: [1, 0, 0], unit: "1", source: made}}
    maximum: {{value: 20, unit: N, source: made}}
  - name: right
    kind: thruster
    position: {{value: [-0.4, -0.25, 0], unit: m, source: made}}
    direction: {{value: [1, 0, 0], unit: "1", source: made}}
    maximum: {{value: 20, unit: N, source: made}}
sensors: {{}}
{more}
"""

# What a platform says that knows the boat but for its drag ahead and about the vertical.
KNOWN = """
drag_form: own_speed
effects:
  anisotropic_drag: {sway_ratio: {value: 3, unit: "1", source: made}}
  linear_drag: {yaw: {value: 0.3, unit: N m s, source: made}}
  thruster_lag: {time_constant: {value: 0.35, unit: s, source: made}}
"""


class Truth(NamedTuple):
    """What the boat really is: X = -surge |u| u, Y = -sway |v| v, N = -linear r - 0.2 |r| r, and the thrusters' lag.

    Forces act at the origin, INERTIA is that about the centre of mass.
    """

    surge: float = 8.0  # kg/m
    sway: float = 24.0  # kg/m
    linear: float = 0.3  # N m s
    lag: float = 0.35  # s
    weed: float = 0.0  # N m, of a moment that turns the boat to the left
    rough: float = 0.0  # N s/m: random push by speed, N, and ARM times as much moment; anew in every tick
    choppy: float = 0.0  # N: such a push that does not depend on speed
    ahead: float = 0.0  # m, of the centre of mass before the origin


def platform(folder: Path, more: str = "") -> Any:
    """The platform that somebody would write for the boat, with `more` lines of YAML."""
    from cocorosim_ros.scenario.parts.platform import read_platform_file

    path = folder / "boat.yaml"
    path.write_text(PLATFORM.format(more=more).replace("source: made", "source: made, confidence: estimate"))
    return read_platform_file(path)


def course(truth: Truth | Sequence[Truth], commands: Any, seed: int = 0) -> Any:
    """(rows, 8) x, y, z, yaw, u, v, w, r every STEP, under commands (ticks, 2) that hold for a TICK each.

    truth: of all ticks, or of each tick.
    """

    def rate(_: float, state: Any, true: Truth, wanted: Any, push: Any) -> list[float]:
        _x, _y, yaw, u, v, r, left, right = state
        drag = (-true.surge * abs(u) * u, -true.sway * abs(v) * v, -true.linear * r - 0.2 * abs(r) * r)
        aside = drag[1] + push[1]
        about_origin = ARM * (right - left) + drag[2] + true.weed + ARM * push[2]
        turn = (about_origin - true.ahead * aside) / INERTIA
        return [
            u * math.cos(yaw) - v * math.sin(yaw),
            u * math.sin(yaw) + v * math.cos(yaw),
            r,
            (left + right + drag[0] + push[0]) / MASS + v * r + true.ahead * r**2,
            aside / MASS - u * r - true.ahead * turn,
            turn,
            (wanted[0] - left) / true.lag,
            (wanted[1] - right) / true.lag,
        ]

    state, rows, rng = np.zeros(8), [], np.random.default_rng([20261123, seed, 2])
    moments = np.arange(0.0, TICK + 0.5 * STEP, STEP)
    truths = [truth] * len(commands) if isinstance(truth, Truth) else truth
    for true, command in zip(truths, commands, strict=True):
        push = math.hypot(true.choppy, true.rough * math.hypot(state[3], state[4])) * rng.standard_normal(3)
        given = (true, FULL * command, push)
        found = solve_ivp(rate, (0.0, TICK), state, args=given, t_eval=moments, rtol=1e-9, atol=1e-10)
        rows.append(found.y.T[:-1])
        state = found.y[:, -1]
    path = np.vstack([*rows, state])
    still = np.zeros(len(path))
    return np.column_stack([path[:, 0], path[:, 1], still, path[:, 2], path[:, 3], path[:, 4], still, path[:, 5]])


def drive(seconds: float, seed: int) -> Any:
    """(ticks, 2) commands of a driver that goes ahead, turns, spins and coasts."""
    rng, rows = np.random.default_rng([20261123, seed]), []
    while len(rows) * TICK < seconds:
        ahead, turn = rng.choice([0.0, 0.3, 0.7, 1.0]), rng.choice([-0.6, -0.3, 0.0, 0.3, 0.6])
        rows += [np.clip([ahead - turn, ahead + turn], -1.0, 1.0)] * int(rng.integers(4, 16))
    return np.array(rows[: round(seconds / TICK)])


def recorded(
    boat: Any,
    truth: Truth | Sequence[Truth],
    seconds: float,
    seed: int,
    thrust: Callable[[Any], Any] = lambda command: command,
) -> Any:
    """Evidence of one drive: poses every 0.1 s; `thrust` gives shares of the full force for commands."""
    from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream

    commands = drive(seconds, seed)
    rows = course(truth, thrust(commands), seed)[::2, :4]
    rng = np.random.default_rng([20261123, seed, 1])
    value = rows + np.array(NOISE) * rng.standard_normal(rows.shape)
    pose = Stream(2 * STEP * np.arange(len(value)), value, np.array(NOISE))
    log = RobotLog("boat", TICK * np.arange(len(commands)), commands, {"pose": pose})
    return Evidence(boat, (RecordingLog("made", seconds, (log,)),))
