"""Arm four: altered logs judged against unaltered ones of the same vehicle, drawn by a seed, beside honest controls.

Each vehicle's recordings are split into two halves. One half is GOOD; of the other a log is altered in a way and by
an amount that a seed draws, or nothing is altered. Data sets and their ways stand in `draws`.
"""

from __future__ import annotations

import json
import math
import random
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from trial.draws import FACTORS, NOTHING, SETS, WHOLE, DataSet
from trial.examiner import Outcome, Task, Terms
from trial.provenance import sentence
from trial.sealed import diagnose
from trial.tampered import altered, listed
from trial.ways import Way, answer, effects

WITHIN = 0.3  # of what was put in, by which a number may be off
RIGHT, SILENT, BLIND, WRONG, NONE = "right", "silent", "cannot be seen", "something else", "no diagnosis"
OUTCOMES = (RIGHT, BLIND, SILENT, WRONG, NONE)


@dataclass(frozen=True)
class Halves:
    """Recordings of one vehicle in one state: those compared with, and those that are judged."""

    name: str
    platform: str
    good: tuple[Path, ...]
    bad: tuple[Path, ...]


def halves(data: Path, out: Path, sets: Sequence[str] = ()) -> list[tuple[Halves, DataSet]]:
    """Every second recording of each group against the others, of the data sets that are there; sets: of these alone.

    Raises ValueError for a data set that is not in SETS.
    """
    unknown = set(sets) - {each.folder for each in SETS}
    if unknown:
        known = ", ".join(each.folder for each in SETS)
        raise ValueError(f"{min(unknown)} is not a data set of altered logs; there are {known}")
    found = []
    for each in SETS:
        if not (data / each.folder).exists() or (sets and each.folder not in sets):
            continue
        for name, bags in each.groups(data, out):
            chosen = bags[: each.most]
            found.append((Halves(name, each.platform, tuple(chosen[0::2]), tuple(chosen[1::2])), each))
    return found


def drawn(found: list[tuple[Halves, DataSet]], count: int, seed: int) -> list[tuple[Halves, Way | None]]:
    """A control for each group that is used, None, and `count` alterations: data sets and their ways take turns.

    A longer draw begins with the shorter one of the same seed.
    """
    chance = random.Random(seed)
    platforms = list(dict.fromkeys(each.platform for _, each in found))
    plan: list[tuple[Halves, Way | None]] = []
    for number in range(count):
        mine = [pair for pair in found if pair[1].platform == platforms[number % len(platforms)]]
        group, data_set = chance.choice(mine)
        plan.append((group, chance.choice(data_set.ways).drawn(chance)))
    groups = dict.fromkeys(group for group, _ in plan)
    return [*((group, None) for group in groups), *plan]


def task(group: Halves, way: Way | None, out: Path) -> Task:
    """The diagnosis of one group, altered in a way or not at all."""
    name = way.name if way else "control"
    bags = group.bad
    if way:
        folder = out / "tampered" / group.name / way.name
        bags = tuple(altered(bag, way, folder / bag.name) for bag in group.bad)
    return Task(f"{group.name}/{name}", bags, out / "diagnoses" / group.name / name, group.platform, group.good)


def diagnosed(plan: list[tuple[Halves, Way | None]], out: Path, terms: Terms) -> list[Outcome]:
    """All diagnoses, those of a group one after the other in forks of a process that has learned its GOOD.

    Groups go side by side, and so does the altering of their logs.
    """
    of_group: dict[Halves, list[Way | None]] = {}
    for group, way in plan:
        of_group.setdefault(group, []).append(way)

    end = time.monotonic() + 60.0 * terms.minutes

    def of_one(group: Halves) -> list[Outcome]:
        tasks = [task(group, way, out) for way in of_group[group]]
        left = (end - time.monotonic()) / 60.0
        is_done = left <= 0.0 or all(each.outcome.exists() for each in tasks)
        return diagnose(tasks, replace(terms, jobs=1, minutes=left, warm_up=None if is_done else tasks[0]))

    with ThreadPoolExecutor(terms.jobs) as pool:
        return [outcome for found in pool.map(of_one, of_group) for outcome in found]


def judged(said: dict[str, Any] | None, way: Way | None) -> dict[str, Any]:
    """The outcome of one diagnosis, what it names beside what was put in, and how probable and right each effect is."""
    if said is None:
        return {"outcome": NONE, "beside": [], "named": [], "believed": []}
    named = [*effects(said), *(_as_effect(each) for each in said["recalibrated"])]
    own = [each for each in named if way and (_is_it(each, way) or _is_twin(each, way))]
    beside = [each["id"] for each in named if each not in own]
    outcome = RIGHT if own and any(_fits(each, way) for each in own) else WRONG if named else SILENT
    if way is None or way.effect == NOTHING:
        outcome = WRONG if named else RIGHT
    elif outcome == SILENT and _is_out_of_sight(said, way):
        outcome = BLIND
    believed = [
        (each["probability"], each in own and _fits(each, way)) for each in effects(said) if "probability" in each
    ]
    return {"outcome": outcome, "beside": beside, "named": [each["id"] for each in named], "believed": believed}


def _as_effect(number: dict[str, Any]) -> dict[str, Any]:
    """A number of the platform that has moved, as effects are told."""
    return {"id": number["parameter"], "parameters": {number["parameter"]: number}}


def _names_of(way: Way) -> set[str]:
    """By which a diagnosis may say that it cannot see an effect: the effect, that of the stream, that of the part."""
    return {way.effect, f"{way.effect}:{way.topic}", f"{way.effect}:{way.parameter}", *dict(_numbers_of(way))}


def _is_out_of_sight(said: dict[str, Any], way: Way) -> bool:
    """Tell whether a diagnosis says that it would not show a way, or only more of it, or that it cannot tell.

    A size that it tells for the number itself counts before a list of what would not show at medium size.
    """
    if not _names_of(way).isdisjoint(said.get("against_in_doubt", [])):
        return True
    told = said.get("against_seen_from", {})
    seen = [(told[name][number], number) for name, number in _numbers_of(way) if number in told.get(name, {})]
    if seen:
        return all(size > _size_of(way, number) for size, number in seen)
    return not _names_of(way).isdisjoint(said["not_shown_by_this_recording"]) or any(
        name in told for name, _ in _numbers_of(way)
    )


def _numbers_of(way: Way) -> list[tuple[str, str]]:
    """Under which names, and of which numbers there, a diagnosis tells from what size on it would name a way."""
    if way.effect == "thruster_asymmetry":  # of vehicles with a left thruster, the first, and a right one
        part = "left" if way.how == "gain:0" else "right"
        return [(f"thruster_gain:{part}", part), (way.effect, way.parameter)]
    if way.effect == "thruster_gain":
        return [(f"thruster_gain:{way.parameter}", way.parameter)]
    return [(way.effect, way.parameter), (f"{way.effect}:{way.topic}", way.parameter)]


def _size_of(way: Way, number: str) -> float:
    """How far off a number was put; that of a thruster's factor is the same for twice and for half."""
    if way.effect in ("thruster_gain", WHOLE) or (way.effect == "thruster_asymmetry" and number != way.parameter):
        factor = way.change if way.effect in ("thruster_gain", WHOLE) else 1.0 / (1.0 + way.amount)
        return max(factor, 1.0 / factor) - 1.0
    return abs(way.change - (1.0 if way.effect in FACTORS else 0.0))


def _is_twin(effect: dict[str, Any], way: Way) -> bool:
    """Tell whether an effect is what these recordings cannot tell from the way, and says so itself."""
    return effect["id"] == way.same[0] and way.effect in {each["id"] for each in effect.get("ambiguous_with", [])}


def _is_it(effect: dict[str, Any], way: Way) -> bool:
    topic = effect.get("topic")
    return effect["id"] == way.effect and (not topic or not way.topic or topic == way.topic)


def _fits(effect: dict[str, Any], way: Way | None) -> bool:
    """Tell whether the number of an effect is what was put in, within its interval or WITHIN."""
    if way is None or not way.parameter:
        return True
    told = effect["parameters"].get(way.same[1] if effect["id"] == way.same[0] else way.parameter)
    if told is None or told["value"] is None:
        return False
    low, high = (each if each is not None else math.nan for each in told["ci95"])
    neutral = 1.0 if way.effect in FACTORS else 0.0
    off = abs(float(told["value"]) - way.change)
    return off <= max(WITHIN * abs(way.change - neutral), 0.5 * (high - low) if math.isfinite(high - low) else 0.0)


def _numbers(said: dict[str, Any] | None) -> str:
    found = [
        f"{effect['id']} ({', '.join(_number(name, told) for name, told in effect['parameters'].items())})"
        for effect in effects(said)
    ]
    return listed([*found, *(_number(each["parameter"], each) for each in (said or {}).get("recalibrated", []))])


def _number(name: str, told: dict[str, Any]) -> str:
    return f"{name} {told['value']:.3g}" if isinstance(told["value"], float) else f"{name} {told['value']}"


def prove(data: Path, out: Path, pages: Path, terms: Terms, source: dict[str, Any]) -> int:
    """Draw, alter, diagnose and judge everything; write the page and its numbers. source: what made them."""
    plan = drawn(halves(data, out, source["sets"]), source["count"], source["seed"])
    seconds = {each.name: each.seconds for each in diagnosed(plan, out, terms)}
    rows, lines = [], []
    for group, way in plan:
        name = way.name if way else "control"
        said = answer(out / "diagnoses" / group.name / name)
        row = {"group": group.name, "way": name} | judged(said, way)
        rows.append(row | {"seconds": seconds.get(f"{group.name}/{name}")})
        put_in = f"`{way.effect}` {way.parameter} {way.change:.3g}" if way else "nothing"
        doubt = ", ".join((said or {}).get("against_control", {}).get("differs", [])) or "alike"
        lines.append(f"| {group.name} | {name} | {put_in} | {row['outcome']} | {_numbers(said)} | {doubt} |")
    pages.mkdir(parents=True, exist_ok=True)
    (pages / "against.md").write_text("\n".join(_page(rows, lines, source)), encoding="utf-8")
    (pages / "against.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    print("\n".join(_page(rows, lines, source)))
    return 0


def _of_probabilities(believed: list[tuple[float, bool]]) -> list[str]:
    """Lines on how right named differences are, and how probable they were called; none without any."""
    if not believed:
        return []
    right = sum(is_right for _, is_right in believed)
    told = sum(probability for probability, _ in believed) / len(believed)
    score = sum((probability - is_right) ** 2 for probability, is_right in believed) / len(believed)
    share, count = 100.0 * right / len(believed), len(believed)
    return [
        f"{count} differences are named as effects; {right}, {share:.0f} %, are what was altered, with its number.",
        f"Their probability is told as {100.0 * told:.0f} % on average (Brier score {score:.3f}).", "",
    ]  # fmt: skip


def by_kind(rows: list[dict[str, Any]]) -> list[str]:
    """Lines of the table of outcomes by kind of alteration; rows: those of the page's figures."""
    kinds: dict[str, list[str]] = {}
    for row in rows:
        if row["way"] != "control":
            kinds.setdefault(row["way"].partition("_")[0], []).append(row["outcome"])
    head = [f"| kind | altered | {' | '.join(OUTCOMES)} |", "|---" * (len(OUTCOMES) + 2) + "|"]
    lines = [
        f"| {kind} | {len(found)} | {' | '.join(str(found.count(outcome)) for outcome in OUTCOMES)} |"
        for kind, found in sorted(kinds.items())
    ]
    return [*head, *lines, ""]


def _page(rows: list[dict[str, Any]], lines: list[str], source: dict[str, Any]) -> list[str]:
    put_in = [row for row in rows if row["way"] != "control"]
    controls = [row for row in rows if row["way"] == "control"]
    counts = {outcome: sum(row["outcome"] == outcome for row in put_in) for outcome in OUTCOMES}
    beside = sum(bool(row["beside"]) for row in put_in)
    return [
        "# Altered logs against unaltered ones", "",
        "Water, vehicle and noise are real. Of one half of a vehicle's recordings a log was altered, drawn by a seed;",
        "the other half is what they are compared with (`cocorosim diagnose BAD... --against GOOD...`).", "",
        f"{len(put_in)} altered: {', '.join(f'{count} {outcome}' for outcome, count in counts.items())}; "
        f"{beside} name something beside what was altered. {len(controls)} controls, half against half with nothing "
        f"altered: {sum(row['outcome'] == WRONG for row in controls)} name something.", "",
        *_of_probabilities([tuple(each) for row in rows for each in row["believed"]]),
        "Right: the effect is named and its number is what was put in, within 30 % or its interval. Where a vehicle",
        "has poses alone, poses that are late and commands that act late are one thing to the recordings: the name of",
        "the other is right where it says that it cannot be told from the one. Cannot be seen: nothing is named, and",
        "the diagnosis lists the effect (of that stream, or that number of it) as not shown, tells a size from which",
        "it would be named that is above the one put in, or warns that it may differ but that it cannot tell.", "",
        sentence(source), "",
        *by_kind(rows),
        "| recordings | altered | to be found | outcome | named | halves of GOOD |", "|---|---|---|---|---|---|",
        *lines, "",
    ]  # fmt: skip
