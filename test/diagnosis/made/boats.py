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


# The boat with one thruster at its stern, which turns by up to a radian to either side.
POD = """actuators:
  - name: propeller
    kind: thruster
    position: {{value: [-0.4, 0, 0], unit: m, source: made}}
    direction: {{value: [1, 0, 0], unit: "1", source: made}}
    maximum: {{value: 20, unit: N, source: made}}
  - name: turn
    kind: azimuth
    thruster: propeller
    largest_angle: {{value: 1, unit: rad, source: made}}
"""
STERN = -0.4  # m
# x and y of four thrusters [m], and where they push [rad to the left of ahead].
CORNERS = (
    (0.4, 0.25, -math.pi / 4), (0.4, -0.25, math.pi / 4), (-0.4, 0.25, math.pi / 4), (-0.4, -0.25, -math.pi / 4)
)  # fmt: skip
NAMES = ("front_left", "front_right", "rear_left", "rear_right")
AIR, FRONT, SIDE = 1.225, 0.1, 0.2  # kg/m^3, and areas above the water, m^2
ABOVE_WATER = f"""front_above_water: {{{{value: {FRONT}, unit: m^2, source: made}}}},
  side_above_water: {{{{value: {SIDE}, unit: m^2, source: made}}}}, """


class Truth(NamedTuple):
    """What the boat really is: X = -surge |u| u, Y = -sway |v| v, N = -linear r - 0.2 |r| r, and the thrusters' lag.

    total: drag goes by the whole speed, X = -surge V u, Y = -sway V v. lag: 0 for thrusters that follow at once.
    Forces act at the origin, INERTIA is that about the centre of mass.
    """

    surge: float = 8.0  # kg/m
    sway: float = 24.0  # kg/m
    linear: float = 0.3  # N m s
    lag: float = 0.35  # s
    weed: float = 0.0  # N m, of a moment that turns the boat to the left
    rough: float = 0.0  # N s/m: random push by speed, N, and ARM times as much moment; anew in every tick
    choppy: float = 0.0  # N: such a push that does not depend on speed
    total: bool = False
    wind: tuple[float, float] = (0.0, 0.0)  # m/s, of the air in the world; its centre of pressure is at 0.05 m
    askew: float = 0.0  # rad, by which a thruster that turns stands farther to the left than it should
    ahead: float = 0.0  # m, of the centre of mass before the origin


Forces = Callable[..., tuple[float, float, float]]
"""X, Y, N [N, N, N m] of the truth and of what each actuator delivers."""


def platform(folder: Path, more: str = "", text: str = PLATFORM) -> Any:
    """The platform that somebody would write for the boat, with `more` lines of YAML."""
    from cocorosim_ros.scenario.parts.platform import read_platform_file

    path = folder / "boat.yaml"
    path.write_text(text.format(more=more).replace("source: made", "source: made, confidence: estimate"))
    return read_platform_file(path)


def with_pod() -> str:
    """The text of the platform with one thruster that turns in place of two that do not."""
    head, _, rest = PLATFORM.partition("actuators:\n")
    return head + POD + "sensors:" + rest.partition("sensors:")[2]


def with_four() -> str:
    """The text of the platform with four thrusters that push aslant."""
    head, _, rest = PLATFORM.partition("actuators:\n")
    every = "".join(
        f"""  - name: {name}
    kind: thruster
    position: {{{{value: [{x}, {y}, 0], unit: m, source: made}}}}
    direction: {{{{value: [{math.cos(angle)}, {math.sin(angle)}, 0], unit: "1", source: made}}}}
    maximum: {{{{value: 20, unit: N, source: made}}}}
"""
        for name, (x, y, angle) in zip(NAMES, CORNERS, strict=True)
    )
    return head + "actuators:\n" + every + "sensors:" + rest.partition("sensors:")[2]


def in_the_wind() -> str:
    """The text of the platform that says what stands above the water."""
    return PLATFORM.replace("hull: {{", "hull: {{" + ABOVE_WATER)


def drag(true: Truth, u: float, v: float, r: float) -> tuple[float, float, float]:
    """X, Y, N of the water [N, N, N m]."""
    ahead, aside = (math.hypot(u, v),) * 2 if true.total else (abs(u), abs(v))
    return -true.surge * ahead * u, -true.sway * aside * v, -true.linear * r - 0.2 * abs(r) * r


def blown(true: Truth, yaw: float, u: float, v: float) -> tuple[float, float, float]:
    """X, Y, N of the wind less those of still air [N, N, N m]: 1/2 rho c A |V| V, c 0.7 ahead and 0.85 to the side."""
    east, north = true.wind
    ahead, aside = east * math.cos(yaw) + north * math.sin(yaw) - u, north * math.cos(yaw) - east * math.sin(yaw) - v
    size, still = math.hypot(ahead, aside), math.hypot(u, v)
    across = 0.5 * AIR * 0.85 * SIDE * (size * aside + still * v)
    return 0.5 * AIR * 0.7 * FRONT * (size * ahead + still * u), across, 0.05 * across


def pair(_true: Truth, left: float, right: float) -> tuple[float, float, float]:
    """X, Y, N of two thrusters that push ahead [N, N, N m]."""
    return left + right, 0.0, ARM * (right - left)


def pod(true: Truth, force: float, turned: float) -> tuple[float, float, float]:
    """X, Y, N of one thruster at the stern [N, N, N m]; turned: a radian in multiples of FULL, to the left."""
    angle = turned / FULL + true.askew
    return force * math.cos(angle), force * math.sin(angle), STERN * force * math.sin(angle)


def vectored(_true: Truth, *pushes: float) -> tuple[float, float, float]:
    """X, Y, N of four thrusters at the corners that push aslant [N, N, N m]."""
    along = [
        (push * math.cos(angle), push * math.sin(angle)) for push, (*_, angle) in zip(pushes, CORNERS, strict=True)
    ]
    turn = sum(x * aside - y * ahead for (x, y, _), (ahead, aside) in zip(CORNERS, along, strict=True))
    return sum(ahead for ahead, _ in along), sum(aside for _, aside in along), turn


def aslant(commands: Any) -> Any:
    """(ticks, 4) commands of those four from commands (ticks, 2) of a pair, which push them sideways too."""
    ahead, turn = commands.mean(axis=1), 0.5 * np.diff(commands, axis=1)[:, 0]
    aside = np.roll(turn, len(turn) // 3)
    shares = [
        ahead + 0.7 * side * turn + slant * aside for _, side, slant in ((1, -1, -1), (1, 1, 1), (1, -1, 1), (1, 1, -1))
    ]
    return np.clip(np.column_stack(shares), -1.0, 1.0)


def course(truth: Truth | Sequence[Truth], commands: Any, seed: int = 0, forces: Forces = pair) -> Any:
    """(rows, 8) x, y, z, yaw, u, v, w, r every STEP, under commands (ticks, actuators) that hold for a TICK each.

    truth: of all ticks, or of each tick. forces: X, Y, N of what the actuators deliver.
    """

    def rate(_: float, state: Any, true: Truth, wanted: Any, push: Any) -> list[float]:
        _x, _y, yaw, u, v, r, *delivered = state
        late = wanted - delivered
        if true.lag == 0.0:
            delivered = wanted
        water, air, thrust = drag(true, u, v, r), blown(true, yaw, u, v), forces(true, *delivered)
        aside = thrust[1] + water[1] + push[1] + air[1]
        about_origin = thrust[2] + water[2] + true.weed + ARM * push[2] + air[2]
        turn = (about_origin - true.ahead * aside) / INERTIA
        return [
            u * math.cos(yaw) - v * math.sin(yaw),
            u * math.sin(yaw) + v * math.cos(yaw),
            r,
            (thrust[0] + water[0] + push[0] + air[0]) / MASS + v * r + true.ahead * r**2,
            aside / MASS - u * r - true.ahead * turn,
            turn,
            *(late / true.lag if true.lag else 0.0 * late),
        ]

    state, rows, rng = np.zeros(6 + commands.shape[1]), [], np.random.default_rng([20261123, seed, 2])
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
    forces: Forces = pair,
) -> Any:
    """Evidence of one drive: poses every 0.1 s; `thrust` gives shares of the full force for commands.

    forces: as in course; of a pod, what would turn the boat with two thrusters turns it, and so of four aslant.
    """
    from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream

    commands = drive(seconds, seed)
    if forces is pod:
        commands = np.column_stack([commands.mean(axis=1), -0.5 * np.diff(commands, axis=1)])
    if forces is vectored:
        commands = aslant(commands)
    rows = course(truth, thrust(commands), seed, forces)[::2, :4]
    rng = np.random.default_rng([20261123, seed, 1])
    value = rows + np.array(NOISE) * rng.standard_normal(rows.shape)
    pose = Stream(2 * STEP * np.arange(len(value)), value, np.array(NOISE))
    log = RobotLog("boat", TICK * np.arange(len(commands)), commands, {"pose": pose})
    return Evidence(boat, (RecordingLog("made", seconds, (log,)),))
