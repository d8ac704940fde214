"""Figures of arm three: what was said of every group, how its models ran on unseen recordings, and what made them.

They are `real.json`, of which the page is written; of groups that were not tried again it keeps what it had.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from trial.recordings import Group
from trial.unseen import on_unseen
from trial.ways import answer

Tree = dict[str, Any]
ONE, OTHER, AGAIN, HALVES = "one_half", "other_half", "same_again", "half_against_half"
ENDINGS = {ONE: "", OTHER: "_held_out", AGAIN: "_by_model", HALVES: "_halves"}
"""Diagnoses of a group by what they are of, with the ends of their folders' names."""

KEPT = ("verdict", "recalibrated", "passed_over", "missing_in", "warnings", "probabilities")
KEPT_OF_EFFECT = ("id", "topic", "robots", "parameters", "nats", "tier", "because", "ambiguous_with", "probability")


def group_figures(pair: tuple[Group, Group], out: Path) -> Tree:
    """What was said of a group, and the errors of the platform's file and of the found model on the other half."""
    own, others = pair
    said = {name: _said(out / "diagnoses" / f"{own.name}{ending}") for name, ending in ENDINGS.items()}
    model = out / "diagnoses" / own.name / "model.yaml"
    seen = on_unseen(own.platform, model, others.bags) if model.is_file() else {}
    return {
        "platform": own.platform,
        "recordings": {ONE: [bag.name for bag in own.bags], OTHER: [bag.name for bag in others.bags]},
        "diagnoses": said,
        "unseen": {channel: told._asdict() for channel, told in seen.items()},
    }


def _said(folder: Path) -> Tree:
    """The diagnosis of a folder without what no page tells, and how the command ended; None for what is not there."""
    file = folder.with_name(f"{folder.name}.outcome.json")
    ended = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {"status": None, "said": "not tried"}
    said = answer(folder)
    if said is None:
        return {"diagnosis": None, "ended": ended}
    kept = {name: said[name] for name in KEPT if name in said}
    kept["effects"] = [{name: each[name] for name in KEPT_OF_EFFECT if name in each} for each in said["effects"]]
    return {"diagnosis": kept | {"held_out": (said.get("fit") or {}).get("held_out") or {}}, "ended": ended}


def diagnosis(group: Tree, name: str) -> Tree | None:
    """A diagnosis of a group, if there is one; name: of ENDINGS."""
    found: Tree | None = group["diagnoses"][name]["diagnosis"]
    return found


def merged(earlier: Tree, new: Tree) -> Tree:
    """Figures of an earlier page and new ones in their place; what made none that is left is not told any more."""
    done = made_of(new)
    sources = [source | {"of": [name for name in source["of"] if name not in done]} for source in earlier["sources"]]
    tables = {name: earlier[name] | new[name] for name in ("groups", "ships", "thruster")}
    return {"sources": [source for source in sources if source["of"]] + new["sources"], **tables}


def made_of(figures: Tree) -> set[str]:
    """Names of all that has a source."""
    return {name for source in figures["sources"] for name in source["of"]}


def nothing() -> Tree:
    """Figures before anything was tried."""
    return {"sources": [], "groups": {}, "ships": {}, "thruster": {}}


def read(file: Path) -> Tree:
    """Figures of a file, nothing where there is none."""
    found: Tree = json.loads(file.read_text(encoding="utf-8")) if file.exists() else nothing()
    return found


def write(file: Path, figures: Tree) -> None:
    """Writes figures to a file; what is no number there is null."""
    file.write_text(json.dumps(_without_nan(figures), indent=1) + "\n", encoding="utf-8")


def _without_nan(tree: Any) -> Any:
    if isinstance(tree, dict):
        return {name: _without_nan(each) for name, each in tree.items()}
    if isinstance(tree, list | tuple):
        return [_without_nan(each) for each in tree]
    return None if isinstance(tree, float) and math.isnan(tree) else tree


def halves(figures: Tree) -> Iterable[tuple[str, str, Tree]]:
    """Group, half and diagnosis of all halves that have one."""
    for name, group in figures["groups"].items():
        for half in (ONE, OTHER):
            if (said := diagnosis(group, half)) is not None:
                yield name, half, said


def unseen_ratios(figures: Tree) -> Iterable[tuple[str, str, float]]:
    """Group, channel, and error of the found model over that of the platform's file on recordings that no fit saw.

    Channels in which the platform's file errs by nothing, as depths that a map holds at zero, have no ratio.
    """
    for name, group in figures["groups"].items():
        for channel, told in group["unseen"].items():
            if told["nominal"]:
                yield name, channel, told["found"] / told["nominal"]
