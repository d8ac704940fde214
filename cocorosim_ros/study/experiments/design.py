"""A design: groups of runs that differ in one thing, each in one or more numerics, each repeated."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cocorosim_ros.foundation.card import Card, Shown
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.scenario.reading.arguments import names, place_text, whole_number
from cocorosim_ros.scenario.reading.config_files import config_names, find_config, referenced_config
from cocorosim_ros.scenario.reading.entry import Entry, argument_entry, nearest
from cocorosim_ros.scenario.reading.yaml_file import load_yaml
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.world.checks.controlled import with_controller
from cocorosim_ros.world.checks.loading import read_scenario
from cocorosim_ros.world.seeding.seeding import generator

if TYPE_CHECKING:
    import pandas as pd

MOST_RUNS = 1_000_000  # whose table of results, about 1 kB a run, is put in order in memory
CONTROLLER_FILES = "controller_files"  # in the summary of a design that has any
_LARGEST_SEED = 2**63 - 1
_REQUIRED = ("name", "description", "scenario", "numerics", "seed", "replicates", "groups", "baseline")
_OPTIONAL = ("change", "metrics")


@dataclass(frozen=True)
class Cell:
    """Runs that differ in their random numbers alone: one group in one kind of numerics."""

    group: str
    numerics: str
    description: str
    scenario: Scenario
    """With the seed of the group: run i of it is `cocorosim run` of this scenario with run number i."""


@dataclass(frozen=True, repr=False)
class Design(Shown):
    """What is compared with what."""

    name: str
    description: str
    baseline: str
    """The group that the others are compared with."""
    replicates: int
    metrics: tuple[str, ...]
    """Those that a report shows as pictures."""
    cells: tuple[Cell, ...]
    """In the order of rows: all groups of the first numerics, then of the next."""

    @property
    def runs(self) -> int:
        """How many runs there are."""
        return self.replicates * len(self.cells)

    @property
    def groups(self) -> tuple[str, ...]:
        """The names of the groups in their order."""
        return tuple(dict.fromkeys(cell.group for cell in self.cells))

    def to_frame(self) -> pd.DataFrame:
        """One row a group in a kind of numerics: numerics, group, description, robots, ticks, runs."""
        rows = [
            (cell.numerics, cell.group, cell.description, len(cell.scenario.robots), cell.scenario.ticks)
            for cell in self.cells
        ]
        names = ("numerics", "group", "description", "robots", "ticks")
        columns = {name: [row[place] for row in rows] for place, name in enumerate(names)}
        return data_frame({**columns, "runs": [self.replicates] * len(rows)})

    def card(self) -> Card:
        """What is compared with what."""
        facts = {"runs": str(self.runs), "baseline": self.baseline, "replicates": str(self.replicates)}
        rows = [(cell.numerics, cell.group, cell.description) for cell in self.cells]
        return Card(f"design {self.name}", facts, ("numerics", "group", "description"), rows, (self.description,))

    def cell_of_row(self, row: int) -> tuple[Cell, int]:
        """The cell and the replicate of a row of the finished table. Raises CocorosimError if there is none."""
        if not 0 <= row < self.runs:
            raise CocorosimError(f"The design '{self.name}' has no row {row}; choose from 0 to {self.runs - 1}.")
        return self.cells[row // self.replicates], row % self.replicates

    def summary(self) -> dict[str, Any]:
        """What a report tells about the design, ready for JSON."""
        scenario, own = self.cells[0].scenario, self.controller_files()
        return {
            "design": self.name,
            "digest": self.digest(),
            "description": self.description,
            "baseline": self.baseline,
            "replicates": self.replicates,
            "metrics": list(self.metrics),
            "robots": len(scenario.robots),
            "tank": " x ".join(f"{side:g}" for side in scenario.tank.size) + " m",
            "ticks": scenario.ticks,
            "tick": scenario.tick,
            "cells": [
                {
                    "numerics": cell.numerics,
                    "group": cell.group,
                    "description": cell.description,
                    "scenario": cell.scenario.to_yaml(),
                }
                for cell in self.cells
            ],
            **({CONTROLLER_FILES: own} if own else {}),
        }

    def controller_files(self) -> dict[str, str]:
        """The users' own Python files that robots are controlled by, each with the SHA-256 of its bytes."""
        controllers = [group.controller for cell in self.cells for group in cell.scenario.swarm]
        return {part.file: part.sha256 for part in controllers if isinstance(part, PythonController)}

    def digest(self) -> str:
        """16 hex digits that tell designs apart; the number of replicates does not count: more can be added."""
        parts = [part for cell in self.cells for part in (cell.group, cell.numerics, cell.scenario.to_yaml())]
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def load_design(
    name_or_path: str | Path,
    replicates: int | None = None,
    groups: Sequence[str] = (),
    numerics: Sequence[str] = (),
    controller: str | None = None,
) -> Design:
    """The design of that name in config/designs, or of that file; with fewer groups or numerics where given.

    controller: of all robots in every group, as a scenario would have it.
    Raises CocorosimError: whatever is wrong with it, or a group or kind of numerics that it does not have.
    """
    place, groups, numerics = (
        place_text(name_or_path, "name_or_path"),
        names(groups, "groups"),
        names(numerics, "numerics"),
    )
    if controller is not None:
        place_text(controller, "controller")
    top = load_yaml(find_config("designs", place))
    section = top.section(_REQUIRED, _OPTIONAL)
    if replicates is not None:
        section["replicates"] = argument_entry(whole_number(replicates, "replicates"), "replicates")
    named = section["groups"].mapping()
    if not named:
        raise section["groups"].problem("has no group, so that there would be no run; add at least one.")
    baseline = section["baseline"].choice(list(named))
    listed = [part.text() for part in section["numerics"].items()]
    kinds = _chosen(numerics, listed, "kind of numerics", top)
    chosen = _chosen(groups, list(named), "group", top)
    count = _replicates(section["replicates"], len(kinds) * len(chosen))
    base = load_yaml(referenced_config("scenarios", section["scenario"]))
    if controller is not None:
        section["controller"] = argument_entry(controller, "controller")
    cells = tuple(_cell(section, base, kind, name) for kind in kinds for name in chosen)
    words = section["name"].text(), section["description"].text()
    return Design(*words, baseline, count, _metrics(section), cells)


def _chosen(wanted: Sequence[str], there: Sequence[str], what: str, top: Entry) -> list[str]:
    """What is wanted, all if nothing is, in the order of the design."""
    for name in wanted:
        if name not in there:
            raise CocorosimError(f"{top.file} has no {what} '{name}'{nearest(name, there)}.")
    if not there:
        raise top.problem(f"names no {what}, so that there would be no run; add at least one.")
    return [name for name in there if not wanted or name in wanted]


def _replicates(entry: Entry, cells: int) -> int:
    count = entry.whole_number(1, _LARGEST_SEED)
    if count * cells > MOST_RUNS:
        raise entry.problem(
            f"makes {count * cells:,} runs, more than the {MOST_RUNS:,} whose table, about 1 kB a run, fits in memory; "
            "choose fewer replicates."
        )
    return count


def _metrics(section: Mapping[str, Entry]) -> tuple[str, ...]:
    if "metrics" not in section:
        return PAPER_METRICS
    return tuple(part.choice(list(METRICS)) for part in section["metrics"].items())


def _cell(section: Mapping[str, Entry], base: Entry, kind: str, group: str) -> Cell:
    """The base scenario with the changes of the numerics, of the design and of the group, in this order."""
    entry = section["groups"].mapping()[group]
    described = entry.section(("description",), ("change",))
    place = next(part for part in section["numerics"].items() if part.value == kind)
    changes = [numerics_change(place)]
    changes += [part["change"] for part in (section, described) if "change" in part]
    for change in changes:
        base = changed(base, change)
    if "controller" in section:
        base = with_controller(base, section["controller"])
    scenario = seeded_scenario(base, section["seed"], f"group {group}")
    return Cell(group, kind, described["description"].text(), scenario)


def seeded_scenario(entry: Entry, seed: Entry, stream: str) -> Scenario:
    """The scenario of `entry` with a seed of its own, which follows from that of a design and the name of a stream."""
    number = seed.whole_number(0, _LARGEST_SEED)
    scenario = read_scenario(replace(entry, value={**entry.mapping(), "seed": replace(seed, value=0)}))
    return replace(scenario, seed=int(generator(number, stream).integers(_LARGEST_SEED)))


def numerics_change(entry: Entry) -> Entry:
    """The change that a preset of numerics makes. Raises CocorosimError for an unknown one."""
    names = config_names("numerics")
    if "/" not in entry.text() and entry.text() not in names:
        raise entry.problem(f"has '{entry.text()}', which is no preset of numerics{nearest(entry.text(), names)}.")
    return load_yaml(referenced_config("numerics", entry))


def changed(base: Entry, change: Entry) -> Entry:
    """`base` with what `change` says put in: mappings name by name, and one given for a list in every item of it."""
    if isinstance(base.value, dict) and isinstance(change.value, dict):
        parts = dict(base.value)
        for name, part in change.value.items():
            parts[name] = changed(parts[name], part) if name in parts else part
        return replace(base, value=parts)
    if isinstance(base.value, list) and isinstance(change.value, dict):
        return replace(base, value=[changed(part, change) for part in base.value])
    return change
