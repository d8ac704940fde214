"""Arm two: real recordings whose logs are altered in a known way, each beside the unaltered ones as its control.

Water, vehicle and noise are real, and so is whatever else no model has: so the control may show effects too. Right is
what the altered recordings show and the control does not, or what both show with the right difference in its number.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from trial.examiner import Task, Terms
from trial.provenance import sentence
from trial.recordings import Group, chunks, dives, hovercraft
from trial.sealed import concealer, diagnose
from trial.ways import OUTCOMES, UNTOLD, WAYS, Way, answer, effects, judged


def groups(data: Path, out: Path) -> list[Group]:
    """Half a dozen runs of the hovercraft, eight dives of the other vehicle, at a time."""
    runs = [
        Group(f"hovercraft_{k}", "hovercraft_epfl", bags) for k, bags in enumerate(chunks(hovercraft(data, out), 6))
    ]
    whole = dives(data, out, "reference")
    return runs + [Group(f"haizhe_{k}", "haizhe_auv", bags) for k, bags in enumerate(chunks(whole[:16], 8))]


def altered(bag: Path, way: Way, out: Path) -> Path:
    """The recording with its logs altered, in an envelope trial of its own; made once."""
    if not (out / "ledger.json").exists():
        concealer("tamper", str(bag), "--how", way.how, "--amount", str(way.amount), "--out", str(out))
    return out / "recordings" / bag.name


def plan(found: list[Group], out: Path) -> list[Task]:
    """A control for each group, and a diagnosis of it for each way."""
    todo = []
    for group in found:
        todo.append(
            Task(f"{group.name}/control", group.bags, out / "diagnoses" / group.name / "control", group.platform)
        )
        for way in WAYS[group.platform]:
            folder = out / "tampered" / group.name / way.name
            bags = tuple(altered(bag, way, folder / bag.name) for bag in group.bags)
            todo.append(
                Task(f"{group.name}/{way.name}", bags, out / "diagnoses" / group.name / way.name, group.platform)
            )
    return todo


def listed(names: list[str]) -> str:
    """Names in a cell of a table."""
    return ", ".join(f"`{name}`" for name in names) or "nothing"


def table(found: list[Group], out: Path) -> tuple[list[dict[str, Any]], list[str]]:
    """All judgements, and the page's lines."""
    rows, lines = [], []
    for group in found:
        control = answer(out / "diagnoses" / group.name / "control")
        for way in WAYS[group.platform]:
            tampered = answer(out / "diagnoses" / group.name / way.name)
            row = judged(control, tampered, way) | {"group": group.name, "way": way.name, "effect": way.effect}
            row["said"] = [effect["id"] for effect in effects(tampered)]
            rows.append(row | {"expected": way.change, "diagnosed": tampered is not None})
            moved = "-" if row["moved"] is None else f"{row['moved']:.3g}"
            lines.append(
                f"| {group.name} | `{way.how}` {way.amount:g} | `{way.effect}` | {'yes' if row['named'] else 'no'}"
                f" | {'yes' if row['in_control'] else 'no'} | {moved} (put in {way.change:.3g})"
                f" | {row['outcome']} | {listed(row['said'])} |"
            )
    return rows, lines


def controls(found: list[Group], out: Path) -> list[str]:
    """Effects that the unaltered recordings show."""
    lines = []
    for group in found:
        said = answer(out / "diagnoses" / group.name / "control")
        verdict = said["verdict"] if said else "no diagnosis"
        names = [f"{e['id']} ({e.get('nats') or 0:.0f} nats)" for e in effects(said)]
        lines.append(f"| {group.name} | {len(group.bags)} | {verdict} | {listed(names)} |")
    return lines


def prove(data: Path, out: Path, pages: Path, terms: Terms, source: dict[str, Any]) -> int:
    """Makes, diagnoses and judges everything, and writes the page and its numbers; source: what made them."""
    found = groups(data, out)
    diagnose(plan(found, out), terms)
    rows, lines = table(found, out)
    counts = {outcome: sum(row["outcome"] == outcome for row in rows) for outcome in OUTCOMES}
    beside = sum(bool(row["named_wrongly"]) for row in rows)
    text = [
        "# Real recordings with altered logs", "",
        "Water, vehicle and noise are real; a log was altered in a known way. The unaltered recordings are the",
        "control: what is named of them too does not count, unless its number moves by what was put in.", "",
        f"{len(rows)} diagnoses: {', '.join(f'{count} {outcome}' for outcome, count in counts.items())}.", "",
        "Right: the effect is named and its number moved by what was put in, within 30 % or the intervals. Named",
        "wrongly: not right, and an effect of the catalogue is named that the control does not have. Cannot be seen:",
        "neither, and the diagnosis says that these recordings could not show the effect. Where the pose is the only",
        "stream, a pose that is late and thrusters that lag are counted together.", "",
        f"Whatever the outcome, {beside} of {len(rows)} name an effect of the catalogue that was neither put in nor",
        "found in the control.", "", sentence(source), "", "## Controls", "",
        "| recordings | how many | verdict | effects named |", "|---|---|---|---|", *controls(found, out), "",
        "## Altered", "",
        "| recordings | altered | to be found | named | in the control too | its number moved by | outcome"
        " | effects named |",
        "|---|---|---|---|---|---|---|---|", *lines, "",
        *(f"`{name}`: {reason}." for name, reason in UNTOLD.items()), "",
    ]  # fmt: skip
    pages.mkdir(parents=True, exist_ok=True)
    (pages / "tampered.md").write_text("\n".join(text), encoding="utf-8")
    (pages / "tampered.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    print("\n".join(text))
    return 0
