"""Page on real recordings: its sections, and what an earlier page says of recordings that were not tried again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from trial.thruster import FORMS

MEASURED_AGAINST = (
    "All models start from one state, which the recalibrated model makes of the readings before, and are measured",
    "against the readings that come, in blocks (or whole recordings) that no fit of the numbers saw. `course`",
    "beside a channel: no reading shows it as it is, and the course that the recalibrated model sees in the other",
    "readings stands in. Which effects a model has was decided on everything, free runs through these blocks among it.",
    "The noise floor is the error of a model that names nothing and has learnt a smooth force. Unseen recordings had",
    "no part in the found model: it and the platform's file run from the same starts, over the same seconds, through",
    "the same windows, which fill these recordings but for their first tenth; in brackets how long, how many, and in",
    "what share of them the found model errs more. Versions up to a79eb88 measured in a fifth of them: rows that were",
    "made by one have fewer windows. Still earlier ones measured each model against its own smoothed course; their",
    "figures do not compare with these.",
)


HEADS = {
    "found": ["## What was found", ""],
    "runs": [
        "", "## Free runs on data that no fit of the numbers saw", "", *MEASURED_AGAINST, "",
        "| recordings | channel | nominal | recalibrated | augmented | noise floor"
        " | unseen recordings, nominal | unseen recordings, found model |",
        "|---|---|---|---|---|---|---|---|",
    ],
    "again": [
        "", "## The same model again, and one half against the other", "",
        "The found model finds nothing twice if the same recordings are `consistent` with it; so are two halves of one",
        "vehicle in one state, compared by `--against`.", "",
        "| recordings | the same recordings, found model | held-out half against the other |", "|---|---|---|",
    ],
    "other": [
        "", "## Effects on the other half of the recordings", "",
        "Each half was diagnosed by itself against the platform's file. An effect keeps its sign if the other half",
        "names it too, on the same stream, with all amplitudes that are clear here on the same side; its size, if",
        "their 95 % intervals have something in common as well.", "",
        "| recordings | confirmed effects | suspected effects |", "|---|---|---|",
    ],
    "ships": ["", "## Two model ships", ""],
    "thruster": [
        "", "## An actuator by itself", "",
        "The maker's table of a thruster, pulse widths to force [N] at six supply voltages. Every tenth row made a",
        "curve in one of the forms that a platform file may have; the others, unseen, tell its error (root mean",
        "square).", "",
        f"| recordings | largest force | {' | '.join(FORMS)} |", f"|---|{'---|' * (1 + len(FORMS))}",
    ],
}  # fmt: skip


def page_of(
    own: Mapping[str, Sequence[str]],
    made: Sequence[str],
    kept: Mapping[str, Sequence[str]],
) -> list[str]:
    """Lines of the page; own: lines by section; made: by what; kept: lines of other data sets, from an earlier page."""
    single = {name for name in ("ships", "thruster") if not (own[name] or kept.get(name))}
    heads = {name: words for name, words in HEADS.items() if name not in single}
    head = [
        "# Real recordings as they are", "",
        "Half of the recordings of each vehicle were diagnosed; the found model was then tried on the other half.", "",
        *made, "",
    ]  # fmt: skip
    return head + [line for name, words in heads.items() for line in (*words, *kept.get(name, []), *own[name])] + [""]


def kept_lines(page: Path, names: Sequence[str]) -> tuple[list[str], dict[str, list[str]]]:
    """What made an earlier page, and its lines on recordings other than `names` by section; nothing without a page."""
    if not page.exists():
        return [], {}
    made: list[str] = []
    kept: dict[str, list[str]] = {name: [] for name in HEADS}
    section, group = "", ""
    for line in page.read_text(encoding="utf-8").splitlines():
        section = next((name for name, words in HEADS.items() if line.startswith("## ") and line in words), section)
        if line.startswith("Made by"):
            made.append(line)
        elif line.startswith("- "):
            group = line[2:].split(" ")[0].rstrip(":")
        elif line.startswith("| ") and not line.startswith("| recordings"):
            group = line[2:].split(" ")[0]
        if section and line.lstrip().startswith(("- ", "| ")) and not line.startswith("| recordings"):
            kept[section] += [_comparable(line) if section == "runs" else line] if group not in names else []
    return made if any(kept.values()) else [], kept


def _comparable(row: str) -> str:
    """A row of the free runs, without what an earlier version measured over other seconds for each of two models."""
    *inside, _, found, _ = row.split("|")
    return row if " windows" in found or found == " - " else "|".join([*inside, " - ", " - ", ""])
