"""A platform's file as plain values with the sources of its numbers, ready to be changed and written again."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from cocorosim_ros.scenario.reading.config_files import config_folders, referenced_config
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.yaml_file import load_yaml


def sourced_tree(path: Path) -> dict[str, Any]:
    """The platform of a file, whole: {based_on: name} for one that ships, else everything that it says.

    A file that is based on another one is put together with it, so that the tree needs no path.
    """
    if _ships(path):
        return {"based_on": path.stem}
    entry = load_yaml(path)
    tree: dict[str, Any] = plain(entry)
    if "based_on" in tree:
        base = sourced_tree(referenced_config("platforms", entry.mapping()["based_on"]))
        tree = {**base, **{key: part for key, part in tree.items() if key != "based_on"}}
    return tree


def plain(entry: Entry) -> Any:
    """The value of an entry as dict, list, text, number or truth value."""
    if isinstance(entry.value, dict):
        return {name: plain(part) for name, part in entry.value.items()}
    if isinstance(entry.value, list):
        return [plain(part) for part in entry.value]
    return entry.value


def fitted_number(value: float, unit: str, interval: tuple[float, float], source: str) -> dict[str, Any]:
    """A number as a platform file holds it: with what it was fitted to and its 95 % interval."""
    low, high = interval
    shown = "" if unit == "1" else f" {unit}"
    number: dict[str, Any] = {
        "value": value,
        "unit": unit,
        "source": source,
        "confidence": "fitted",
        "note": f"95 % interval {low:.6g} to {high:.6g}{shown}",
    }
    is_known = math.isfinite(low) and math.isfinite(high) and low <= value <= high and low < high
    return number | {"ci95": [low, high]} if is_known else number


def _ships(path: Path) -> bool:
    return any(path.resolve() == (folder / "platforms" / path.name).resolve() for folder in config_folders())
