"""A factorial: groups of runs under many two-level choices at once, written down as one file.

From it come ordinary designs (experiments.design), one for each stage of a search: all groups under the stage's
settings. A group's name is followed by the setting, a digit for each factor in the order of the file, 1 for its upper
level; a stage of one setting has the groups' plain names.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from cocorosim_ros.scenario.reading.based_on import with_base
from cocorosim_ros.scenario.reading.config_files import find_config, referenced_config
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.yaml_file import load_yaml
from cocorosim_ros.study.experiments.design import Cell, Design, changed, numerics_change, seeded_scenario
from cocorosim_ros.study.experiments.fraction import Setting
from cocorosim_ros.study.metrics import PAPER_METRICS

_KEYS = ("name", "description", "figure", "scenario", "numerics", "seed", "baseline", "groups", "factors")
_STAGES = ("screening", "refining", "choosing", "confirming")
_MOST = 100_000
SEPARATOR = ", "


@dataclass(frozen=True)
class Factor:
    """A choice of two levels."""

    name: str
    description: str
    """What the upper level is, then `else` and what the lower one is."""
    groups: tuple[str, ...]
    """Those that it can touch."""
    change: Entry
    """What makes the upper level of the lower one."""


@dataclass(frozen=True)
class Stage:
    """Some settings, each run so often in every group."""

    name: str
    settings: tuple[Setting, ...]
    runs: int


@dataclass(frozen=True)
class Factorial:
    """What is varied, in which groups, and how much of it is run."""

    name: str
    description: str
    figure: str
    """The design of the claims whose figure is looked for."""
    baseline: str
    factors: tuple[Factor, ...]
    groups: tuple[str, ...]
    screening_runs: int
    refining_runs: int
    refining_rounds: int
    choosing_settings: int
    choosing_runs: int
    confirming_runs: int
    section: dict[str, Entry]

    def design(self, stage: Stage) -> Design:
        """The design of a stage; its seeds are those of no other stage."""
        bases = {group: self._base(group) for group in self.groups}
        named = [(group, setting) for setting in stage.settings for group in self.groups]
        cells = tuple(self._cell(stage, bases[group], group, setting) for group, setting in named)
        words = f"{self.name}_{stage.name}", f"{self.description}; {stage.name.replace('_', ' ')}"
        return Design(
            *words, self.group_name(stage, self.baseline, stage.settings[0]), stage.runs, PAPER_METRICS, cells
        )

    def group_name(self, stage: Stage, group: str, setting: Setting) -> str:
        """What a group under a setting is called in the stage's design."""
        return group if len(stage.settings) == 1 else f"{group}{SEPARATOR}{digits(setting)}"

    def _base(self, group: str) -> Entry:
        """The scenario of a group with every factor at its lower level."""
        entry = load_yaml(referenced_config("scenarios", self.section["scenario"]))
        own = self.section["groups"].mapping()[group].mapping()
        changes = [numerics_change(self.section["numerics"])]
        for change in changes + [part["change"] for part in (self.section, own) if "change" in part]:
            entry = changed(entry, change)
        return _with_platforms(entry)

    def _cell(self, stage: Stage, entry: Entry, group: str, setting: Setting) -> Cell:
        for factor, upper in zip(self.factors, setting, strict=True):
            if upper and group in factor.groups:
                entry = changed(entry, factor.change)
        scenario = seeded_scenario(entry, self.section["seed"], f"{stage.name} {group} {digits(setting)}")
        told = self.section["groups"].mapping()[group].mapping()["description"].text()
        return Cell(self.group_name(stage, group, setting), self.section["numerics"].text(), told, scenario)


def digits(setting: Setting) -> str:
    """A setting as 0 and 1."""
    return "".join("1" if upper else "0" for upper in setting)


def _with_platforms(entry: Entry) -> Entry:
    """The scenario with the platforms of its robots written out, so that changes can reach into them."""
    robots = [_with_platform(part) for part in entry.mapping()["swarm"].items()]
    return replace(entry, value={**entry.mapping(), "swarm": replace(entry.mapping()["swarm"], value=robots)})


def _with_platform(group: Entry) -> Entry:
    named = group.mapping()["platform"]
    if isinstance(named.value, dict):
        return group
    platform = with_base(load_yaml(referenced_config("platforms", named)), "platforms")
    return replace(group, value={**group.mapping(), "prefix": named_prefix(group, platform), "platform": platform})


def named_prefix(group: Entry, platform: Entry) -> Entry:
    """The group's prefix, or the platform's name where it has none."""
    return group.mapping().get("prefix", platform.mapping()["name"])


def load_factorial(name_or_path: str | Path) -> Factorial:
    """The factorial of that name in config/factorials, or of that file. Raises CocorosimError for what is wrong."""
    top = load_yaml(find_config("factorials", str(name_or_path)))
    section = top.section((*_KEYS, *_STAGES), ("change",))
    groups = list(section["groups"].mapping())
    for part in section["groups"].mapping().values():
        part.section(("description",), ("change",))
    more = {"refining": ("rounds",), "choosing": ("settings",)}
    plan = {name: section[name].section(("runs", *more.get(name, ()))) for name in _STAGES}
    runs = {name: part["runs"].whole_number(1, _MOST) for name, part in plan.items()}
    return Factorial(
        section["name"].text(),
        section["description"].text(),
        section["figure"].text(),
        section["baseline"].choice(groups),
        _factors(section["factors"], groups),
        tuple(groups),
        runs["screening"],
        runs["refining"],
        plan["refining"]["rounds"].whole_number(0, _MOST),
        plan["choosing"]["settings"].whole_number(1, _MOST),
        runs["choosing"],
        runs["confirming"],
        section,
    )


def _factors(entry: Entry, groups: Sequence[str]) -> tuple[Factor, ...]:
    factors = []
    for name, part in entry.mapping().items():
        section = part.section(("description", "change"), ("groups",))
        touched = [each.choice(groups) for each in section["groups"].items()] if "groups" in section else groups
        factors.append(Factor(name, section["description"].text(), tuple(touched), section["change"]))
    if not factors:
        raise entry.problem("has no factor, so that there would be one setting alone; add at least one.")
    return tuple(factors)
