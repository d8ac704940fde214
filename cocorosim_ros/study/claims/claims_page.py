"""The claims and what was found, as a Markdown page: one row a claim, the kinds of numerics side by side."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from cocorosim_ros.study.claims.answers import MARKS, NO_RUNS, Answer
from cocorosim_ros.study.claims.choices import Choices, choices_of
from cocorosim_ros.study.claims.claims import Finding
from cocorosim_ros.study.claims.markdown import markdown_table
from cocorosim_ros.study.claims.original_page import released_part
from cocorosim_ros.study.claims.readings import Readings, readings_of
from cocorosim_ros.study.results.results import Results

_KINDS = {"paper": "the paper's numerics", "accurate": "the accurate numerics"}
_BOTH = "both"


def claims_page(answers: Sequence[Answer], experiments: Mapping[str, Results]) -> str:
    """The whole page."""
    parts = [
        "# The claims of the paper",
        "Read et al. 2013, section 5 and figure 4, claim by claim, as `cocorosim claims` finds them. "
        "[The studies of the paper](the_paper.md) says what the names mean, how the runs were made and what follows "
        "from them.",
        _made_from(experiments.values()),
        _counts(answers),
        _table(answers),
        _readings(list(readings_of(experiments))),
        *(released_part(results) for results in experiments.values()),
        *(_choices(table) for results in experiments.values() for table in choices_of(results)),
    ]
    return "\n\n".join(part for part in parts if part) + "\n"


def _made_from(experiments: Iterable[Results]) -> str:
    rows = [
        (
            f"`{results.about['design']}`",
            str(min(_runs(results, kind, group) for kind in results.numerics for group in results.groups)),
            ", ".join(results.numerics),
            f"{results.about['ticks']:,}",
            results.about["digest"],
            ", ".join(sorted(set(results.table["version"].to_pylist()))),
        )
        for results in experiments
    ]
    return markdown_table(
        ("design", "runs per group", "numerics", "ticks", "design digest", "version of the code"), rows
    )


def _runs(results: Results, numerics: str, group: str) -> int:
    return int(results.values(numerics, group, "replicate").size)


def _counts(answers: Sequence[Answer]) -> str:
    lines = []
    for kind, words in _KINDS.items():
        count = Counter(answer.verdict for answer in answers if answer.numerics in (kind, _BOTH))
        told = ", ".join(f"{count[verdict]} {verdict}" for verdict in MARKS if count[verdict])
        lines.append(f"In {words}: {told}.")
    return "Comparisons, each counted once. " + " ".join(lines)


def by_claim(answer: Answer) -> tuple[str, int]:
    """Order of the table: C1 ... C5, S1 ... S22, T1 ... T5, M1 ... M3."""
    match = re.fullmatch(r"([CSTM])(\d+)", answer.claim)
    letter, number = match.groups() if match else ("Z", "0")
    return str("CSTMZ".index(letter)), int(number)


def _table(answers: Sequence[Answer]) -> str:
    rows: dict[tuple[str, str, str], dict[str, Answer]] = {}
    for answer in sorted(answers, key=by_claim):
        rows.setdefault((answer.claim, answer.subject, answer.paper), {})[answer.numerics] = answer
    lines = []
    for key, found in rows.items():
        cells = [found.get(kind, found.get(_BOTH)) for kind in _KINDS]
        shown = [(cell.ours, MARKS[cell.verdict]) if cell else ("", "") for cell in cells]
        lines.append((*key, *(word for pair in shown for word in pair)))
    heading = ("claim", "what", "the paper", "paper's numerics", "reproduced", "accurate numerics", "reproduced")
    return markdown_table(heading, lines)


def _readings(found: list[Readings]) -> str:
    """In how many readings of its metric each claim is reproduced; nothing without results."""
    rows: dict[tuple[str, str], dict[str, str]] = {}
    for one in found:
        subject = f"{one.claim.group} against {one.claim.against}: {one.claim.metric.replace('_', ' ')}"
        cells = rows.setdefault((one.claim.name, subject), {})
        cells[one.numerics] = f"{len(one.reproduced)} of {len(one.asked)}"
    if not rows:
        return ""
    lines = [(*key, *(cells.get(kind, "") for kind in _KINDS)) for key, cells in rows.items()]
    return (
        "## Other readings of the metrics\n\n"
        "The paper leaves open over whom, from which centre, in which direction and how over time its metrics are "
        "taken. In how many of all named readings each claim is reproduced:\n\n"
        + markdown_table(("claim", "what", "paper's numerics", "accurate numerics"), lines)
    )


def _choices(table: Choices) -> str:
    rows = [
        (
            claim.name,
            f"{claim.group} against {claim.against}: {claim.metric.replace('_', ' ')}",
            claim.paper,
            *(_cell(finding) for finding in findings),
        )
        for claim, findings in table.rows
    ]
    heading = ("claim", "what", "the paper", *table.choices)
    title = f"## One choice at a time: `{table.design}`, {table.numerics} numerics"
    return (
        f"{title}\n\nA under each choice, and whether the claim is reproduced then; empty where a choice does not "
        f"touch the claim, or has no runs yet.\n\n{markdown_table(heading, rows)}"
    )


def _cell(finding: Finding | None) -> str:
    if finding is None or finding.verdict == NO_RUNS:
        return ""
    return f"{finding.effect.value:.2f} {MARKS[finding.verdict]}"
