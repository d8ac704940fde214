"""The file of a diagnosed platform as plain values with sources, in four degrees of freedom where it has six."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.scenario.parts.in_four_degrees import in_four_degrees
from cocorosim_ros.scenario.parts.level_numbers import BASIC
from cocorosim_ros.scenario.parts.platform import Platform, read_platform_file
from cocorosim_ros.scenario.reading.based_on import with_base
from cocorosim_ros.scenario.reading.quantity import Quantity
from cocorosim_ros.scenario.reading.sourced_platform import plain, sourced_tree
from cocorosim_ros.scenario.reading.yaml_file import load_yaml

Tree = dict[str, Any]
SIX_DEGREES, ROBOTS = "six_degrees", "robots"


def tree_to_change(platform: Platform) -> Tree:
    """The tree that a model is made from: `{based_on: name}` for a platform that ships, else the whole file.

    One with six_degrees is whole too: nothing can be taken out of what a file is based on.
    """
    return tree_of_file(platform) if _is_levelled(platform) else sourced_tree(Path(platform.origin))


def tree_of_file(platform: Platform) -> Tree:
    """The whole file of a platform, with what it takes from those it is based on: sources and ranges too."""
    whole = with_base(load_yaml(Path(platform.origin)), "platforms")
    tree = {key: plain(part) for key, part in whole.mapping().items()}
    if not _is_levelled(platform):
        return tree
    level = in_four_degrees(read_platform_file(Path(platform.origin)))  # without what is known from elsewhere
    robots = {name: _levelled(part, level.of_robot(name)) for name, part in tree.pop(ROBOTS, {}).items()}
    tree = _levelled(tree, level)
    return tree | {ROBOTS: robots} if robots else tree


def _is_levelled(platform: Platform) -> bool:
    """Tell whether its file has six degrees of freedom, for it or one of its robots."""
    return any(each.told for each in (platform, *platform.robots.values()))


def _levelled(tree: Tree, platform: Platform) -> Tree:
    """The tree of a platform or of one of its robots in four degrees of freedom; unchanged where it has no more."""
    if not platform.told:
        return tree
    effects: Tree = {}
    for effect, parameters in platform.effect_quantities.items():
        for name, part in parameters.items():
            if isinstance(part, Quantity):
                number = _number(platform, f"effects.{effect}.{name}", part.value, part.unit)
                effects.setdefault(effect, {})[name] = number
    basic = {key: _number(platform, key, getattr(platform, key), unit) for key, unit in BASIC.items()}
    kept = {"kept_as_given": list(platform.kept_as_given)} if platform.kept_as_given else {}
    left = {key: part for key, part in tree.items() if key not in (SIX_DEGREES, "kept_as_given")}
    return left | basic | {"drag_form": platform.drag_form, "effects": effects} | kept


def _number(platform: Platform, key: str, value: float, unit: str) -> Tree:
    """The number of a key as a file has it, with its range and its interval."""
    source = f"six_degrees of {Path(platform.origin).name}"
    value = float(f"{value:.{REPORT.digits_of_sums}g}")
    number: Tree = {"value": value, "unit": unit, "source": source, "confidence": "derived"}
    for name, given in (("range", platform.ranges.get(key)), ("ci95", platform.intervals.get(key))):
        if given is not None:
            number[name] = [min(given.low, value), max(given.high, value)]
    return number
