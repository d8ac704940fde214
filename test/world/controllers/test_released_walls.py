"""A lone Lily of the released model at a wall, against an independent calculation of her rules in the plane.

The calculation keeps place and velocity as complex numbers in world axes and knows nothing of the package: four
directions with rays at 0 and +-62.5 degrees, avoidance by the flags of this tick or of the last one, the heading
controller, quadratic drag, semi-implicit Euler steps of 0.5 s. Sources: Read et al. 2013, sections 3 and 4;
cocorosim-facts 1.4, 3 and 8.
"""

from __future__ import annotations

import cmath
import math
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

HALF = 3.0  # m, half the tank
TICKS, TICK = 400, 0.5
MASS, DRAG, INERTIA, YAW_DRAG = 0.44, 1.7778, 5e-4, 1.140e-4
LEVER = 0.055 * math.cos(math.radians(63.0))
SCENARIO = """\
name: wall
description: one Lily swims at a wall
seed: 1
tick: 0.5 s
duration: 200 s
tank: {size: [6 m, 6 m, 2.2 m]}
integrator: {name: semi_implicit_euler, step: 0.5 s, contact: stop_position}
swarm:
  - platform: PLATFORM
    prefix: lily
    controller: heading_hold
    overrides: {heading: HEADING deg, speed: 0.1, depth: 1 m}
    start: {poses: [[2.7 m, START m, -1 m, HEADING deg]]}
"""


class Walls(NamedTuple):
    """Sum of the infringements of the four directions [m; body, x + iy] and whether there is any."""

    away: complex
    near: bool


def ray(place: complex, direction: complex) -> float:
    """Distance [m] to the wall that a ray meets."""
    east = (math.copysign(HALF, direction.real) - place.real) / direction.real
    north = (math.copysign(HALF, direction.imag) - place.imag) / direction.imag
    return min(east, north)


def walls(place: complex, yaw: float) -> Walls:
    """What is nearer than 0.25 m by the shortest of three rays of front, left, back and right."""
    away, near = 0j, False
    for side in (1, 1j, -1, -1j):
        rays = [ray(place, side * cmath.rect(1.0, yaw + math.radians(turn))) for turn in (0.0, 62.5, -62.5)]
        if min(rays) < 0.25:
            away, near = away - side * (0.25 - min(rays)), True
    return Walls(away, near)


def thrusters(speed: float, gain: float, error: float, yaw_rate: float) -> tuple[float, float]:
    """Forces [N] of the left and the right thruster by the heading controller of the operating system."""
    error = math.remainder(error, 2.0 * math.pi)
    turn = 5.0 * gain * error - 60.0 * math.sqrt(gain) * yaw_rate
    left, right = 127.0 * speed - turn / 2.0, 127.0 * speed + turn / 2.0
    if max(left, right) > 127.0:
        left, right = left - (max(left, right) - 127.0), right - (max(left, right) - 127.0)
    elif min(left, right) < -127.0:
        left, right = left - (min(left, right) + 127.0), right - (min(left, right) + 127.0)
    most = 0.005 * 127.0 / 127.5
    return tuple(min(max(0.005 * part / 127.5, -most), most) for part in (left, right))  # type: ignore[return-value]


def start(heading: float) -> float:
    """The y [m; world] from which the other walls are not reached."""
    return math.copysign(2.5, -heading)


def course_by_hand(heading: float, lag: bool) -> Any:
    """Places (TICKS,) [m; world, x + iy] of a Lily that is asked to swim along `heading` [rad]."""
    place, velocity, yaw, yaw_rate = complex(2.7, start(heading)), 0j, heading, 0.0
    before, asked, places = Walls(0j, False), heading, []
    for _ in range(TICKS):
        now = walls(place, yaw)
        seen, before = (before, now) if lag else (now, now)
        if seen.near:
            if abs(seen.away) > 1e-6:
                asked = yaw + cmath.phase(seen.away)
            speed, gain = 0.5, 15.0
        else:
            asked, speed, gain = heading, 0.1, 3.0
        left, right = thrusters(speed, gain, asked - yaw, yaw_rate)
        velocity += TICK / MASS * (cmath.rect(left + right, yaw) - DRAG * abs(velocity) * velocity)
        yaw_rate += TICK / INERTIA * (LEVER * (right - left) - YAW_DRAG * abs(yaw_rate) * yaw_rate)
        place, yaw = place + TICK * velocity, yaw + TICK * yaw_rate
        places.append(place)
    return np.array(places)


def course(platform: Path | str, heading: float, folder: Path) -> Any:
    """The same by the simulation: places (TICKS,) [m; world, x + iy]."""
    path = folder / "wall.yaml"
    text = SCENARIO.replace("PLATFORM", str(platform)).replace("START", repr(start(heading)))
    path.write_text(text.replace("HEADING", repr(math.degrees(heading))))
    scenario = load_scenario(path)
    simulation, places = Simulation(build_world(scenario), start_poses(scenario)[None]), []
    for _ in range(TICKS):
        simulation.sense()
        simulation.decide()
        simulation.advance()
        places.append(complex(*simulation.state[0, 0, :2]))
    return np.array(places)


@pytest.fixture(scope="module")
def prompt_lily(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A platform file of lily_released that avoids walls by what it sees in the same tick."""
    text = Path(load_platform("lily_released").origin).read_text()
    assert text.count("avoidance_readings: previous_tick") == 1
    path = tmp_path_factory.mktemp("prompt") / "prompt_lily.yaml"
    path.write_text(text.replace("avoidance_readings: previous_tick", "avoidance_readings: this_tick"))
    return path


@pytest.mark.parametrize("heading", [1.37, 1.40, 1.44, -1.37, -1.42])
@pytest.mark.parametrize("lag", [True, False])
def test_at_an_oblique_wall(prompt_lily: Path, tmp_path: Path, heading: float, lag: bool) -> None:
    """After 200 s of coming back to the wall again and again it is where the calculation has it.

    Headings so close to the wall that a sensor at the side sees it first: away from what is straight ahead is half a
    turn, either way round, and rounding would choose. Tolerance: rounding of 1e-16, which every turn at the wall
    enlarges; the lag alone makes centimetres.
    """
    by_hand = course_by_hand(heading, lag)
    assert by_hand.real.max() > HALF - 0.25, "it has to come near the wall"
    place = course("lily_released" if lag else prompt_lily, heading, tmp_path)
    np.testing.assert_allclose(place, by_hand, rtol=0, atol=1e-6)


def test_the_lag_matters() -> None:
    """By hand, one tick later at the wall is more than a centimetre elsewhere in the end."""
    assert abs(course_by_hand(1.4, True) - course_by_hand(1.4, False)).max() > 0.01


def test_in_the_first_tick_nothing_is_avoided(tmp_path: Path) -> None:
    """Who starts beside a wall has no flags of an earlier tick: for one tick the behaviour has its way."""
    path = tmp_path / "near.yaml"
    path.write_text(
        SCENARIO.replace("PLATFORM", "lily_released").replace("HEADING", "0").replace("2.7 m, START m", "2.9 m, 0 m")
    )
    scenario = load_scenario(path)
    simulation, speeds = Simulation(build_world(scenario), start_poses(scenario)[None]), []
    for _ in range(2):
        simulation.sense()
        simulation.decide()
        speeds.append(simulation.memory[0, 0, 1])
        simulation.advance()
    assert speeds == [0.1, 0.5]
