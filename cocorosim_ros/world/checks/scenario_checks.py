"""What must hold between the parts of a scenario: times that divide, robots that have room."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.scenario.parts.swarm import Pose, StartBox
from cocorosim_ros.scenario.parts.tank import Tank
from cocorosim_ros.scenario.reading.entry import Entry, nearest
from cocorosim_ros.scenario.reading.quantity import nanoseconds_text
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.acoustic_checks import check_acoustic
from cocorosim_ros.world.checks.fastest_water import fastest_water
from cocorosim_ros.world.checks.six_degrees_checks import check_six_degrees
from cocorosim_ros.world.checks.stability import fastest_rate, longest_stable_step
from cocorosim_ros.world.checks.water_checks import check_water
from cocorosim_ros.world.controllers.crew_assembly import controller_settings
from cocorosim_ros.world.seeding.seeding import start_poses

IDLE_BEHAVIOUR = "idle"
Sections = Mapping[str, Entry]


def check_scenario(scenario: Scenario, sections: Sections) -> None:
    """Nothing, if the parts fit together; CocorosimError names the first that does not.

    sections: the entries of the scenario's keys, for the place in the sentence.
    """
    _check_times(scenario, sections)
    _check_controllers(scenario, sections["swarm"])
    if "water" in sections:
        check_water(scenario, sections["water"])
    _check_stability(scenario, sections)
    check_six_degrees(scenario, sections)
    check_acoustic(scenario, sections)
    _check_corruption(scenario, sections)
    for group, entry in zip(scenario.swarm, sections["swarm"].items(), strict=True):
        if group.start.box is not None:
            _check_box(group.start.box, scenario.tank, entry.mapping()["start"].mapping()["box"])
    _check_poses(scenario, sections["swarm"])
    try:
        start_poses(scenario)
    except CocorosimError as error:
        raise sections["swarm"].problem(f"cannot be placed: {error}") from error


def _check_times(scenario: Scenario, sections: Sections) -> None:
    tick, duration, step = scenario.tick_ns, scenario.duration_ns, scenario.integrator.step_ns
    shown = nanoseconds_text(tick)
    if duration % tick:
        whole = nanoseconds_text(max(1, duration // tick) * tick)
        raise sections["duration"].problem(
            f"has '{nanoseconds_text(duration)}', which is not a whole number of ticks of '{shown}'; "
            f"choose a multiple of the tick, e.g. '{whole}'."
        )
    if tick % step:
        part = nanoseconds_text(_divisor_near(tick, step))
        entry = sections["integrator"].mapping()["step"]
        raise entry.problem(
            f"has '{nanoseconds_text(step)}', which does not divide the tick of '{shown}'; "
            f"choose the tick or a whole fraction of it, e.g. '{part}'."
        )


def _check_controllers(scenario: Scenario, swarm: Entry) -> None:
    for group, entry in zip(scenario.swarm, swarm.items(), strict=True):
        controller_settings(group.controller)
        if isinstance(group.controller, PythonController) or group.controller.behaviour == IDLE_BEHAVIOUR:
            continue  # one's own class may be there to listen and to speak
        if not group.platform.actuators:
            raise entry.mapping()["controller"].problem(
                f"has '{group.controller.name}', which has nothing to move: the platform "
                f"'{group.platform.name}' has no actuators; give it some, or the controller '{IDLE_BEHAVIOUR}'."
            )


def _check_stability(scenario: Scenario, sections: Sections) -> None:
    name, step = scenario.integrator.name, scenario.integrator.step_ns / 1e9
    water = fastest_water(scenario)
    swift = f" in water of up to {water:.3g} m/s" if water > 0.0 else ""
    platforms = [group.platform for group in scenario.swarm if group.platform.six_degrees is None]
    for platform in dict.fromkeys(platforms):
        longest = longest_stable_step(name, platform, water)
        if step > longest:
            rate = fastest_rate(platform, water)
            raise sections["integrator"].problem(
                f"has a step of {step:g} s, beyond the {longest:.3g} s up to which '{name}' is stable for the platform "
                f"'{platform.name}', whose fastest motion{swift} settles at {rate:.3g} 1/s; choose a shorter step."
            )


def _divisor_near(tick: int, step: int) -> int:
    """The largest divisor of the tick that is not above the step, among whole fractions down to 1/1000."""
    return next((tick // n for n in range(1, 1001) if tick % n == 0 and tick // n <= step), tick)


def _check_corruption(scenario: Scenario, sections: Sections) -> None:
    names = [robot.name for robot in scenario.robots]
    parts = sections["corruption"].items() if "corruption" in sections else []
    for corruption, entry in zip(scenario.corruption, parts, strict=True):
        for name in corruption.robots or ():
            if name not in names:
                place = entry.mapping()["robots"]
                raise place.problem(f"has '{name}', the name of no robot{nearest(name, names)}.")


def _check_box(box: StartBox, tank: Tank, entry: Entry) -> None:
    low, high = tank.lower_corner(), tank.upper_corner()
    spans = zip("xyz", box.lower_corner(), box.upper_corner(), low, high, strict=True)
    for axis, box_low, box_high, tank_low, tank_high in spans:
        if box_low < tank_low or box_high > tank_high:
            raise entry.problem(
                f"reaches from {axis} = {box_low:g} m to {box_high:g} m, out of the tank ({tank_low:g} m to "
                f"{tank_high:g} m; z is 0 at the surface and negative below); move it or make it smaller."
            )


def _check_poses(scenario: Scenario, swarm: Entry) -> None:
    placed = list(_explicit_poses(scenario, swarm))
    for name, pose, _, entry in placed:
        _check_place(scenario.tank, name, pose, entry)
    for first, second in itertools.combinations(placed, 2):
        distance, spacing = math.dist(first[1][:3], second[1][:3]), (first[2] + second[2]) / 2
        if distance < spacing:
            raise second[3].problem(
                f"puts '{second[0]}' {distance:.3g} m from '{first[0]}', within each other's hull; "
                f"keep them {spacing:g} m apart."
            )


def _explicit_poses(scenario: Scenario, swarm: Entry) -> Iterator[tuple[str, Pose, float, Entry]]:
    """Robot name, pose, hull length [m] and entry of each pose that the scenario gives."""
    for group, entry in zip(scenario.swarm, swarm.items(), strict=True):
        if group.start.poses is not None:
            places = entry.mapping()["start"].mapping()["poses"].items()
            for name, pose, place in zip(group.robot_names(), group.start.poses, places, strict=True):
                yield name, pose, group.platform.hull.length, place


def _check_place(tank: Tank, name: str, pose: Pose, entry: Entry) -> None:
    position = pose[:3]
    shown = ", ".join(f"{part:g} m" for part in position)
    if not tank.contains(position):
        bounds = zip("xyz", tank.lower_corner(), tank.upper_corner(), strict=True)
        allowed = ", ".join(f"{axis} from {low:g} m to {high:g} m" for axis, low, high in bounds)
        raise entry.problem(f"puts '{name}' at [{shown}], outside the tank; the tank has {allowed}.")
    obstacle = tank.obstacle_at(position)
    if obstacle is not None:
        raise entry.problem(f"puts '{name}' at [{shown}], inside the obstacle '{obstacle.name}'; move one of them.")
