"""Scenarios for the library: by name, by file, or as records, with some of their values replaced."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.arguments import (
    LARGEST,
    Place,
    Seed,
    Time,
    names,
    place_text,
    time_text,
    whole_number,
)
from cocorosim_ros.scenario.reading.entry import argument_entry
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks import loading


def load_scenario(
    source: Place | Scenario,
    *,
    seed: Seed | None = None,
    duration: Time | None = None,
    external: Sequence[str] | None = None,
    controller: str | None = None,
) -> Scenario:
    """The checked scenario of a name in config/scenarios, of a file, or of a record, with what is given replaced.

    seed: from 0 to 2**63 - 1. duration: of the run, such as '60 s' or 60.0 [s], a whole number of ticks. external:
    names of robots whose controllers are left to others, or patterns such as 'lily_*'. controller: of all robots
    instead of their own: a name, a file, or 'my_file.py:MyController'.

    Returns a frozen record; `robots`, `tick` [s], `duration` [s] and `to_yaml()` are its ways in. Raises
    CocorosimError: one sentence with file, line and key for whatever is wrong with it.

    Example: `load_scenario("eleven_lilys", seed=7, duration="60 s").robots[0].name` is 'lily_01'.
    """
    number = None if seed is None else whole_number(seed, "seed", 0, LARGEST)
    length = None if duration is None else time_text(duration, "duration")
    others = None if external is None else names(external, "external")
    if controller is not None:
        place_text(controller, "controller")
    if not isinstance(source, Scenario):
        return loading.load_scenario(place_text(source, "source"), number, length, others, controller)
    options = {"seed": number, "duration": length, "external": others}
    given = {name: argument_entry(value, name) for name, value in options.items() if value is not None}
    if not given and controller is None:
        return source
    entry = parse_yaml(source.to_yaml(), source.origin)
    return loading.read_with(entry, given, controller)


def scenario_to_run(scenario: Place | Scenario, seed: Seed | None, duration: Time | None) -> Scenario:
    """The scenario of a function whose argument is called so, if one process can run it alone.

    Raises CocorosimError as `load_scenario` and `check_runs_here` do.
    """
    if not isinstance(scenario, Scenario):
        place_text(scenario, "scenario")
    loaded = load_scenario(scenario, seed=seed, duration=duration)
    check_runs_here(loaded)
    return loaded


def check_runs_here(scenario: Scenario) -> None:
    """Nothing, if one process can run the scenario alone.

    Raises CocorosimError if a robot's controller is left to somebody else, or a platform has laws that cannot be
    simulated as they are written.
    """
    if scenario.external:
        raise CocorosimError(
            f"The controller of {scenario.external[0]} is left to somebody else, who cannot answer within one process; "
            "take the robot out of the scenario's 'external', or start the nodes with `cocorosim run`."
        )
    from cocorosim_ros.world.vehicle_model.platform_effects import check_platform

    for robot in scenario.robots:
        check_platform(robot.platform)
