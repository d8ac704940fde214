"""Arm three: real recordings as they are. Some are diagnosed; on the others, unseen, the found model runs freely."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

from trial.examiner import Task, Terms
from trial.provenance import sentence
from trial.recordings import Group, dives, hovercraft
from trial.sealed import diagnose
from trial.ways import answer, effects

MEASURED_AGAINST = (
    "All models start from one state, which the recalibrated model makes of the readings before, and are measured",
    "against the readings that come, in blocks (or whole recordings) that no fit of the numbers saw. `course`",
    "beside a channel: no reading shows it as it is, and the course that the recalibrated model sees in the other",
    "readings stands in. Which effects a model has was decided on everything. The noise floor is the error of a",
    "model that names nothing and has learnt a smooth force. Earlier versions measured each model against its own",
    "smoothed course; their figures do not compare with these, nor do two of one row over different seconds.",
)


def groups(data: Path, out: Path) -> list[tuple[Group, Group]]:
    """Recordings to learn from, and recordings of the same vehicle that are held out."""
    runs, whole, faulty = hovercraft(data, out), dives(data, out, "reference"), dives(data, out, "runs_under_test")
    pairs = []
    for day in ("2019-04-11", "2019-04-16"):
        own = [bag for bag in runs if day in bag.name]
        pairs.append((f"hovercraft_{day}", "hovercraft_epfl", own[0::2], own[1::2]))
    pairs.append(("haizhe_reference", "haizhe_auv", whole[0:16:2], whole[1:16:2]))
    pairs.append(("haizhe_under_test", "haizhe_auv", faulty[0:16:2], faulty[1:16:2]))
    return [
        (Group(name, platform, tuple(some)), Group(f"{name}_held_out", platform, tuple(others)))
        for name, platform, some, others in pairs
        if some and others
    ]


def learn(pair: tuple[Group, Group], out: Path) -> list[Task]:
    """Diagnoses by the platform's nominal model, of what is learnt from and of what is held out."""
    return [Task(group.name, group.bags, out / "diagnoses" / group.name, group.platform) for group in pair]


def replay(pair: tuple[Group, Group], out: Path) -> Task:
    """The held-out recordings with the model that the others gave as the nominal one."""
    model = out / "diagnoses" / pair[0].name / "model.yaml"
    return Task(f"{pair[1].name}_by_model", pair[1].bags, out / "diagnoses" / f"{pair[1].name}_by_model", str(model))


def _number(value: Any) -> str:
    return "-" if value is None else f"{value:.3g}"


def held_out(pair: tuple[Group, Group], out: Path) -> list[str]:
    """Rows: by channel, errors within the recordings learnt from, and on those that were never seen."""
    told = [answer(out / "diagnoses" / name) or {} for name in
            (pair[0].name, pair[1].name, f"{pair[1].name}_by_model")]  # fmt: skip
    tables = [(one.get("fit") or {}).get("held_out") or {} for one in told]
    lines = []
    for channel, scores in tables[0].items():
        inside = " | ".join(_number(scores.get(key)) for key in ("nominal", "recalibrated", "augmented", "noise_floor"))
        before, after = (_after_seconds(tables[k].get(channel, {})) for k in (1, 2))
        lasts = f" after up to {scores['seconds']:g} s" if "seconds" in scores else ""
        ruler = ", course" if scores.get("against") == "course" else ""
        name = f"{pair[0].name} | {channel} [{scores.get('unit', '')}]{lasts}{ruler}"
        lines.append(f"| {name} | {inside} | {before} | {after} |")
    return lines


def _after_seconds(scores: dict[str, Any]) -> str:
    """The error of the nominal model, and how long its free runs were, which hangs on how the vehicle turned."""
    lasts = f" ({scores['seconds']:g} s)" if "seconds" in scores else ""
    return f"{_number(scores.get('nominal'))}{lasts}"


def findings(pair: tuple[Group, Group], out: Path) -> list[str]:
    """What was said of the recordings learnt from, with rivals."""
    said = answer(out / "diagnoses" / pair[0].name)
    if said is None:
        return [f"- {pair[0].name}: no diagnosis"]
    lines = [f"- {pair[0].name} ({len(pair[0].bags)} recordings): {said['verdict']}"]
    for effect in effects(said):
        values = ", ".join(
            f"{k} {_number(p.get('value'))} {p.get('unit', '')}".strip() for k, p in effect["parameters"].items()
        )
        rivals = ", ".join(
            f"`{r['id']}` {r['nats_behind']:.1f} nats behind" for r in effect.get("ambiguous_with") or []
        )
        tie = f"; it could also be {rivals}" if rivals else ""
        lines.append(f"  - `{effect['id']}` ({effect.get('nats') or 0:.0f} nats, {effect['tier']}): {values}{tie}")
    return lines


def prove(data: Path, out: Path, pages: Path, terms: Terms, source: dict[str, Any]) -> int:
    """Converts, diagnoses, tries on what was held out, and writes the page; source: what made it."""
    pairs = groups(data, out)
    diagnose([task for pair in pairs for task in learn(pair, out)], replace(terms, keep_reports=True))
    again = [replay(pair, out) for pair in pairs if answer(out / "diagnoses" / pair[0].name)]
    diagnose(again, replace(terms, keep_reports=True))
    text = [
        "# Real recordings as they are", "",
        "Half of the recordings of each vehicle were diagnosed; the found model was then tried on the other half.", "",
        sentence(source), "",
        "## What was found", "", *[line for pair in pairs for line in findings(pair, out)], "",
        "## Free runs on data that no fit of the numbers saw", "",
        *MEASURED_AGAINST, "",
        "| recordings | channel | nominal | recalibrated | augmented | noise floor"
        " | unseen recordings, nominal | unseen recordings, found model |",
        "|---|---|---|---|---|---|---|---|", *[line for pair in pairs for line in held_out(pair, out)], "",
    ]  # fmt: skip
    pages.mkdir(parents=True, exist_ok=True)
    (pages / "real.md").write_text("\n".join(text), encoding="utf-8")
    facts = {
        path.parent.name: json.loads(path.read_text()) for path in sorted(Path(out).glob("diagnoses/*/diagnosis.json"))
    }
    (pages / "real.json").write_text(json.dumps(facts, indent=1) + "\n", encoding="utf-8")
    print("\n".join(text))
    return 0
