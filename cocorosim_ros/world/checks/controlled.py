"""Which robots somebody else controls, by names with wildcards; and another controller for all robots of a scenario."""

from __future__ import annotations

from dataclasses import replace
from fnmatch import fnmatchcase

from cocorosim_ros.scenario.reading.entry import Entry, nearest
from cocorosim_ros.scenario.scenario import Scenario


def with_external_named(scenario: Scenario, external: Entry) -> Scenario:
    """The scenario with its 'external' as names of robots: a pattern of the shell becomes the names that fit it.

    Raises CocorosimError for a name or pattern that fits no robot.
    """
    names = [robot.name for robot in scenario.robots]
    chosen: dict[str, None] = {}
    for pattern in scenario.external:
        fitting = [name for name in names if fnmatchcase(name, pattern)]
        if not fitting:
            what = "a pattern that fits the name" if set(pattern) & set("*?[") else "the name"
            raise external.problem(f"has '{pattern}', {what} of no robot{nearest(pattern, names)}.")
        chosen.update(dict.fromkeys(fitting))
    return replace(scenario, external=tuple(chosen))


def with_controller(top: Entry, controller: Entry) -> Entry:
    """A scenario's mapping in which every group of robots has this controller, and no overrides of the one before."""
    groups = top.mapping()["swarm"] if "swarm" in top.mapping() else None
    if groups is None or not isinstance(groups.value, list):
        return top  # which whoever reads it complains of
    return replace(
        top,
        value={**top.mapping(), "swarm": replace(groups, value=[_controlled_by(controller, g) for g in groups.value])},
    )


def _controlled_by(controller: Entry, group: Entry) -> Entry:
    if not isinstance(group.value, dict):
        return group
    kept = {name: part for name, part in group.value.items() if name != "overrides"}
    return replace(group, value={**kept, "controller": controller})
