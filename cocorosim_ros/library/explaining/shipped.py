"""What the files that ship say under each key: values with their sources, by dotted key and file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

from cocorosim_ros.scenario.reading.config_files import config_names, find_config, shipped_file
from cocorosim_ros.scenario.reading.entry import plain_value
from cocorosim_ros.scenario.reading.yaml_file import load_yaml

_ROW = 2  # cells of a row of a table of keys
_LONGEST = 60  # characters of a value


@cache
def trees(kind: str) -> Mapping[str, Any]:
    """Every shipped file of a kind ('scenarios', 'platforms', ...) as plain values, by its name."""
    return {name: plain_value(load_yaml(find_config(kind, name))) for name in config_names(kind)}


@cache
def values(kind: str) -> Mapping[str, Mapping[str, list[str]]]:
    """By dotted key what each file of a kind has there, in words, with the source where it gives one."""
    found: dict[str, dict[str, list[str]]] = {}
    for name, tree in trees(kind).items():
        for key, words in _leaves(tree, ""):
            there = found.setdefault(key, {}).setdefault(name, [])
            if words and words not in there:
                there.append(words)
    return found


def _leaves(tree: Any, key: str) -> Iterator[tuple[str, str]]:
    """Key and words of everything below; the parts of a list share the key of the list."""
    if key:
        yield key, _words(tree)
    if isinstance(tree, dict) and "value" not in tree:
        for name, part in tree.items():
            yield from _leaves(part, f"{key}.{name}" if key else name)
    elif isinstance(tree, list):
        for part in tree:
            if isinstance(part, dict):
                for name, below in part.items():
                    yield from _leaves(below, f"{key}.{name}")


def _words(tree: Any) -> str:
    """A value as it stands, with its unit and source; empty for what holds others."""
    if isinstance(tree, dict) and "value" in tree:
        unit = "" if tree.get("unit") in (None, "1") else f" {tree['unit']}"
        source = f" ({tree['source']})" if "source" in tree else ""
        return f"{_short(tree['value'])}{unit}{source}"
    if isinstance(tree, dict) or (isinstance(tree, list) and any(isinstance(part, (dict, list)) for part in tree)):
        return ""
    return _short(tree)


def _short(value: Any) -> str:
    words = str(value).lower() if isinstance(value, bool) else " ".join(str(value).split())
    return words if len(words) <= _LONGEST else f"{words[:_LONGEST]}..."


@cache
def rows_of_manual(heading: str) -> Mapping[str, str]:
    """Below a heading of config/README.md, what each key of its table means."""
    text = shipped_file("README.md").read_text("utf-8")
    section = text.partition(f"\n## {heading}\n")[2].partition("\n## ")[0].partition("\n| topic |")[0]
    rows = {}
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.replace(r"\|", "\x00").strip("|").split("|")]
        if line.startswith("| `") and len(cells) == _ROW:
            for name in cells[0].replace("`", "").split(", "):
                rows[name.replace("[]", "")] = cells[1].replace("\x00", "|")
    return rows
