"""Scenarios from files and from text, checked: who loads a scenario gets one that the model can run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.scenario.reading.entry import Entry, argument_entry
from cocorosim_ros.scenario.reading.records import read_record
from cocorosim_ros.scenario.reading.yaml_file import load_yaml, parse_yaml
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.controlled import with_controller, with_external_named

_OF_PLATFORM = {"actuators", "based_on", "hull", "mass"}  # keys by which a platform's file is known


def load_scenario(
    name_or_path: str | Path,
    seed: int | None = None,
    duration: str | None = None,
    external: Sequence[str] | None = None,
    controller: str | None = None,
) -> Scenario:
    """The scenario of that name in config/scenarios, or of that file, with what is given replaced.

    duration: text with a unit, such as '60 s'. external: names of robots that somebody else controls, or patterns such
    as 'lily_*'. controller: of all robots, as a scenario would have it: a name, a file, or 'my_file.py:MyController'.
    Raises CocorosimError: one sentence with file, line and key for whatever is wrong with it.
    """
    entry = load_yaml(find_config("scenarios", str(name_or_path)))
    options = {"seed": seed, "duration": duration, "external": None if external is None else list(external)}
    given = {name: argument_entry(value, name) for name, value in options.items() if value is not None}
    return read_with(entry, given, controller)


def read_with(entry: Entry, given: Mapping[str, Entry], controller: str | None) -> Scenario:
    """The checked scenario that a mapping describes, with given entries in place of its own; a controller for all."""
    entry = replace(entry, value={**entry.mapping(), **given})
    if controller is not None:
        entry = with_controller(entry, argument_entry(controller, "controller"))
    return read_scenario(entry)


def parse_scenario(yaml: str, origin: str) -> Scenario:
    """The scenario that `Scenario.to_yaml` wrote; complaints name `origin`."""
    return read_scenario(parse_yaml(yaml, origin))


def read_scenario(entry: Entry) -> Scenario:
    """The checked scenario that a mapping describes. Raises CocorosimError, also where it describes a platform."""
    if of_platform := sorted(_OF_PLATFORM & entry.mapping().keys()):
        raise entry.problem(
            f"describes a platform, as '{of_platform[0]}' shows, and no scenario; name it in the swarm of a scenario, "
            f"as 'platform: {entry.file}'."
        )
    scenario, sections = replace(read_record(Scenario, entry), origin=entry.file), entry.mapping()
    if scenario.external:
        scenario = with_external_named(scenario, sections["external"])
    # Loaded here: what is wrong with keys and units is said before the compiler, which comes with the model, is loaded.
    from cocorosim_ros.world.checks.scenario_checks import check_scenario

    check_scenario(scenario, sections)
    return scenario
