"""Page on real recordings: its sections, written of the figures alone."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from trial import documented
from trial.other_half import TIERS, Kept, kept
from trial.provenance import sentence
from trial.real_failures import failures
from trial.real_figures import AGAIN, HALVES, ONE, OTHER, diagnosis, read
from trial.real_musts import kept_in_all, musts, table
from trial.real_words import HALF_WORDS, diagnosis_lines, digits, title
from trial.ships import ship_lines
from trial.thruster import FORMS, thruster_rows

Tree = dict[str, Any]
MEASURED_AGAINST = (
    "All models start from one state, which the recalibrated model makes of the readings before, and are measured",
    "against the readings that come, in blocks (or whole recordings) that no fit of the numbers saw. `course`",
    "beside a channel: no reading shows it as it is, and the course that the recalibrated model sees in the other",
    "readings stands in. Which effects a model has was decided on everything, free runs through these blocks among it.",
    "The noise floor is the error of a model that names nothing and has learnt a smooth force: no bound, as that force",
    "stands for no delay, stamp or centre of mass, and a model that has these may err less. Unseen recordings had",
    "no part in the found model: it and the platform's file run from the same starts, over the same seconds, through",
    "the same windows, which fill these recordings but for their first tenth; in brackets how long, how many, and in",
    "what share of them the found model errs more. The last column is its error over that of the platform's file.",
    "Depths of vehicles that stay on the surface, which their maps hold at zero, are left out.",
)
HEADS = {
    "musts": ["## What is asked for, and what was measured", ""],
    "documented": [
        "", "## What is documented, and what was said", "",
        "Causes that the sources of each set tell beyond its platform file (`test/trial/real_sets.yaml`), beside what",
        "was said of each half; an interval holds a documented number or not. What else is named no source tells: it",
        "is neither right nor wrong by them. Nothing of all this was known to the diagnosis.", "",
        "| recordings | documented (source) | said of one half | said of the other half |", "|---|---|---|---|",
    ],
    "found": [
        "", "## What was found", "",
        "Numbers with their 95 % intervals. What was passed over has the reason that the diagnosis gives.", "",
    ],
    "runs": [
        "", "## Free runs on data that no fit of the numbers saw", "", *MEASURED_AGAINST, "",
        "| recordings | channel | nominal | recalibrated | augmented | noise floor"
        " | unseen recordings, nominal | unseen recordings, found model | found over nominal |",
        "|---|---|---|---|---|---|---|---|---|",
    ],
    "again": [
        "", "## The same model again, and one half against the other", "",
        "The found model finds nothing twice if the same recordings are `consistent` with it; so are two halves of one",
        "vehicle in one state, compared by `--against`.", "",
        "| recordings | the same recordings, found model | held-out half against the other |", "|---|---|---|",
    ],
    "other": [
        "", "## Effects on the other half of the recordings", "",
        "Each half was diagnosed by itself against the platform's file, and its effects are looked for in the other,",
        "in both directions. An effect keeps its sign if the other half names it too, on the same stream, with all",
        "amplitudes that are clear here on the same side; its size, if their 95 % intervals have something in common",
        "as well.", "",
        "| recordings | confirmed in one half | confirmed in the other half | suspected in one half"
        " | suspected in the other half |",
        "|---|---|---|---|---|",
    ],
    "ships": ["", "## Two model ships", ""],
    "thruster": [
        "", "## An actuator by itself", "",
        "The maker's table of a thruster, pulse widths to force [N] at six supply voltages. Every tenth row made a",
        "curve in one of the forms that a platform file may have; the others, unseen, tell its error (root mean",
        "square).", "",
        f"| recordings | largest force | {' | '.join(FORMS)} |", f"|---|{'---|' * (1 + len(FORMS))}",
    ],
    "failures": ["", "## All failures", ""],
}  # fmt: skip
ALTERED = "against.json"


def write_page(pages: Path) -> list[str]:
    """Writes `real.md` of `real.json`, and of `against.json` if it is there, in a folder; lines of the page."""
    altered = pages / ALTERED
    judged = json.loads(altered.read_text(encoding="utf-8")) if altered.exists() else []
    text = page_of(read(pages / "real.json"), judged)
    (pages / "real.md").write_text("\n".join(text), encoding="utf-8")
    return text


def page_of(figures: Tree, altered: Sequence[Tree]) -> list[str]:
    """Lines of the page; altered: judgements of altered logs."""
    groups = figures["groups"]
    causes = documented.causes_by_group()
    own = {
        "musts": table(musts(figures, altered)),
        "documented": [
            row for name, group in groups.items() for row in documented.rows(name, group, causes.get(name, []))
        ],
        "found": [line for name, group in groups.items() for line in findings(name, group)],
        "runs": [line for name, group in groups.items() for line in free_runs(name, group)],
        "again": [again(name, group) for name, group in groups.items()],
        "other": [*(other_half(name, group) for name, group in groups.items()), *_totals(figures)],
        "ships": ship_lines(figures["ships"]),
        "thruster": thruster_rows(figures["thruster"]),
        "failures": failures(figures),
    }
    head = [
        "# Real recordings as they are", "",
        "Half of the recordings of each vehicle were diagnosed; the found model was then tried on the other half,",
        "which was diagnosed too. All figures: [real.json](real.json), of which `prove.py real-page` writes this page:",
        "its form may be newer than the commits at which they were measured.", "",
        *made_by(figures["sources"]), "",
    ]  # fmt: skip
    left_out = {name for name in ("ships", "thruster") if not own[name]}
    shown = [(*words, *own[name]) for name, words in HEADS.items() if name not in left_out]
    return [*head, *(line for lines in shown for line in lines), ""]


def made_by(sources: Sequence[Tree]) -> list[str]:
    """What made which figures."""
    return [f"{sentence(source)} ({', '.join(source['of'])})" for source in sources]


def findings(name: str, group: Tree) -> list[str]:
    """What was said of each half, with rivals."""
    lines = []
    for half in (ONE, OTHER):
        said = diagnosis(group, half)
        head = f"- {name}, {HALF_WORDS[half]} ({len(group['recordings'][half])} recordings)"
        lines.append(f"{head}: {'no diagnosis' if said is None else said['verdict']}")
        lines += [f"  - {each}" for each in diagnosis_lines(said)] if said is not None else []
    return lines


def free_runs(name: str, group: Tree) -> list[str]:
    """Rows: by channel, errors within the recordings learnt from, and on those that were never seen."""
    lines = []
    for channel, scores in (diagnosis(group, ONE) or {"held_out": {}})["held_out"].items():
        told = group["unseen"].get(channel)
        if not scores.get("nominal") and not (told and told["nominal"]):
            continue
        inside = " | ".join(digits(scores.get(key)) for key in ("nominal", "recalibrated", "augmented", "noise_floor"))
        lasts = f" after up to {scores['seconds']:g} s" if "seconds" in scores else ""
        ruler = ", course" if scores.get("against") == "course" else ""
        row = f"{name} | {channel} [{scores.get('unit', '')}]{lasts}{ruler}"
        lines.append(f"| {row} | {inside} | {_on_unseen(told)} |")
    return lines


def _on_unseen(told: Tree | None) -> str:
    """Three cells: the errors of the platform's file and of the found model over the same windows, and their ratio."""
    if told is None:
        return "- | - | -"
    lasts = f"({told['seconds']:g} s, {told['windows']} windows, {100 * told['worse']:.0f} % worse)"
    ratio = told["found"] / told["nominal"] if told["nominal"] else None
    return f"{digits(told['nominal'])} | {digits(told['found'])} {lasts} | {'-' if ratio is None else f'{ratio:.2f}'}"


def again(name: str, group: Tree) -> str:
    """Row: what is said of the recordings learnt from by the model found there, and of one half against the other."""
    cells = []
    for what in (AGAIN, HALVES):
        said = diagnosis(group, what)
        named = ", ".join(title(effect) for effect in (said or {"effects": []})["effects"])
        cells.append("no diagnosis" if said is None else f"{said['verdict']}{': ' if named else ''}{named}")
    return f"| {name} | {cells[0]} | {cells[1]} |"


def other_half(name: str, group: Tree) -> str:
    """Row: effects of each half that the diagnosis of the other one finds too, by tier."""
    halves = [diagnosis(group, half) for half in (ONE, OTHER)]
    found = [kept(first, second, tier) for tier in TIERS for first, second in (halves, halves[::-1])]
    return f"| {name} | {' | '.join(_counted(each) for each in found)} |"


def _counted(found: Kept | None) -> str:
    return "no diagnosis" if found is None else found.words


def _totals(figures: Tree) -> list[str]:
    """Counts over all groups and both directions."""
    told = [f"{tier} effects, both directions: {kept_in_all(figures, tier).words}" for tier in TIERS]
    return ["", f"Of all {'; of all '.join(told)}."]
