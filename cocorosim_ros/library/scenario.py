"""Scenarios for the library: by name, by file, or as records, with some of their values replaced."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike, fspath
from typing import Any

import numpy as np

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, entry_of
from cocorosim_ros.scenario.reading.quantity import read_nanoseconds
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks import loading
from cocorosim_ros.world.vehicle_model.platform_effects import check_platform

Place = str | PathLike[str]
"""A path, or a name where names are allowed."""
Time = str | float
"""A length of time: text with a unit, such as '60 s', or a number [s]."""
Seed = int | np.integer[Any]
"""A whole number from 0 to 2**63 - 1."""


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
    number = seed.item() if isinstance(seed, np.integer) else seed
    length = None if duration is None else time_text(duration)
    external = [external] if isinstance(external, str) else external
    if not isinstance(source, Scenario):
        return loading.load_scenario(place_text(source, "source"), number, length, external, controller)
    options = {"seed": number, "duration": length, "external": None if external is None else list(external)}
    given = {name: entry_of(value, f"option '{name}'", name) for name, value in options.items() if value is not None}
    if not given and controller is None:
        return source
    entry = parse_yaml(source.to_yaml(), source.origin)
    return loading.read_with(entry, given, controller)


def place_text(place: object, name: str) -> str:
    """A path or a name as text. Raises CocorosimError, which calls it the argument `name`, if it is neither."""
    if isinstance(place, str | PathLike):
        return fspath(place)
    raise CocorosimError(f"The argument '{name}' has {place!r}, which is no path; give text or a path.")


def whole_number(number: object, name: str, least: int = 1) -> int:
    """A whole number. Raises CocorosimError, which calls it the argument `name`, if it is none or below `least`."""
    if isinstance(number, int | np.integer) and not isinstance(number, bool) and number >= least:
        return int(number)
    raise CocorosimError(f"The argument '{name}' has {number!r}; give a whole number from {least} on.")


def time_text(time: Time) -> str:
    """A time as text with a unit."""
    return time if isinstance(time, str) else f"{float(time)!r} s"


def nanoseconds(time: Time, name: str) -> int:
    """A positive time as whole nanoseconds. Raises CocorosimError, which calls it the argument `name`."""
    return read_nanoseconds(Entry(time_text(time), "argument", 0, name))


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
    for robot in scenario.robots:
        check_platform(robot.platform)
