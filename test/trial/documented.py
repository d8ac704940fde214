"""Documented causes of real recordings beside what was said of them (`real_sets.yaml`)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML
from trial.real_figures import ONE, OTHER, diagnosis
from trial.real_words import title

Tree = dict[str, Any]
FILE = Path(__file__).with_name("real_sets.yaml")


@lru_cache(maxsize=1)
def causes_by_group() -> dict[str, list[Tree]]:
    """Causes that the sources of each group tell: `what`, `source`, `names` of effects, and perhaps `numbers`."""
    entries = YAML(typ="safe").load(FILE.read_text(encoding="utf-8"))
    return {group: entry["causes"] for entry in entries for group in entry["groups"]}


def rows(name: str, group: Tree, causes: Sequence[Tree]) -> list[str]:
    """Rows of the page: each cause with what both halves say of it, then what else they name."""
    halves = [diagnosis(group, half) for half in (ONE, OTHER)]
    lines = [
        f"| {name} | {cause['what']} ({cause['source']}) | {' | '.join(said_of(cause, half) for half in halves)} |"
        for cause in causes
    ]
    rest = "nothing else" if causes else "nothing beyond the platform file"
    return [*lines, f"| {name} | {rest} | {' | '.join(_listed(beside(causes, half)) for half in halves)} |"]


def said_of(cause: Tree, said: Tree | None) -> str:
    """What a diagnosis says of a documented cause: named, with its tier and its numbers, passed over, or not named."""
    if said is None:
        return "no diagnosis"
    named = [f"{each['tier']}: {title(each)}{_held(cause, each)}" for each in said["effects"] if _is_of(each, cause)]
    passed = [f"passed over: {title(each)}" for each in said.get("passed_over") or [] if _is_of(each, cause)]
    return "; ".join([*named, *passed]) or "not named"


def is_named(cause: Tree, said: Tree | None) -> bool:
    """Tell whether a diagnosis names a documented cause."""
    return any(_is_of(each, cause) for each in (said or {"effects": []})["effects"])


def beside(causes: Sequence[Tree], said: Tree | None) -> list[str]:
    """Titles of effects that a diagnosis names and no source tells."""
    named = (said or {"effects": []})["effects"]
    return [title(each) for each in named if not any(_is_of(each, cause) for cause in causes)]


def _is_of(effect: Tree, cause: Tree) -> bool:
    return effect["id"] in cause["names"]


def _held(cause: Tree, effect: Tree) -> str:
    """Which documented numbers the intervals of an effect hold, and which not."""
    answers: dict[str, list[str]] = {}
    for name, value in (cause.get("numbers") or {}).items():
        low, high = (effect["parameters"].get(name) or {}).get("ci95") or (None, None)
        if low is not None and high is not None:
            answers.setdefault("holds" if low <= value <= high else "does not hold", []).append(f"{value:g} ({name})")
    return "".join(f", {answer} {', '.join(told)}" for answer, told in answers.items())


def _listed(titles: list[str]) -> str:
    return ", ".join(titles) or "nothing"
