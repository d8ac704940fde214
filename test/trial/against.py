"""Arm four: altered logs judged against unaltered ones of the same vehicle, drawn by a seed, beside honest controls.

Each vehicle's recordings are split into two halves. One half is GOOD; of the other a log is altered in a way and by
an amount that a seed draws, or nothing is altered. Data sets and their ways stand in one table, SETS: a further data
set is a line there.
"""

from __future__ import annotations

import json
import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from trial.examiner import Task, Terms
from trial.provenance import sentence
from trial.recordings import dives, hovercraft
from trial.sealed import diagnose
from trial.tampered import altered, listed
from trial.ways import Way, answer, effects

WITHIN = 0.3  # of what was put in, by which a number may be off
RIGHT, SILENT, BLIND, WRONG, NONE = "right", "silent", "cannot be seen", "something else", "no diagnosis"
OUTCOMES = (RIGHT, BLIND, SILENT, WRONG, NONE)
Bags = Callable[[Path, Path], list[Path]]


@dataclass(frozen=True)
class Halves:
    """Recordings of one vehicle in one state: those compared with, and those that are judged."""

    name: str
    platform: str
    good: tuple[Path, ...]
    bad: tuple[Path, ...]


@dataclass(frozen=True)
class Draw:
    """How one way to alter a log is drawn: the least and the greatest amount, of either sign where it may have both."""

    how: str
    least: float
    most: float
    both: bool = True

    def drawn(self, chance: random.Random) -> Way:
        """The way with an amount, and what it does."""
        amount = round(chance.uniform(self.least, self.most), 4)
        return way_of(self.how, -amount if self.both and chance.random() < 0.5 else amount)


@dataclass(frozen=True)
class DataSet:
    """A data set: its recordings in groups that are alike, how many of a group are taken, and ways to alter them."""

    folder: str
    platform: str
    groups: Callable[[Path, Path], Iterator[tuple[str, list[Path]]]]
    most: int
    ways: tuple[Draw, ...]


def way_of(how: str, amount: float) -> Way:
    """What is to be found of a way to alter a log: effect, stream, number and its size."""
    kind, _, detail = how.partition(":")
    if kind == "gain":  # what the log understates, the thruster has more of
        factor = 1.0 / (1.0 + amount)
        sign = -1.0 if detail == "0" else 1.0
        return Way(how, amount, "thruster_asymmetry", None, "difference", sign * 2.0 * (factor - 1.0) / (factor + 1.0))
    if how == "delay:thruster_command":  # stamps that are late: thrust is there before its command
        return Way(how, amount, "command_delay", None, "delay", -amount)
    if kind == "delay":
        return Way(how, amount, "sensor_latency", detail, "latency", amount)
    effect, topic, number, change = {
        "scale": ("camera_scale", "pose", "scale", 1.0 + amount),
        "compass": ("compass_distortion", "compass", "sin", amount),
        "heading": ("compass_distortion", "compass", "offset", amount),
        "mirror": ("frame_mixup", "compass", "", math.nan),
        "gyro": ("imu_bias", "imu", "gyro_z", amount),
        "gyroscale": ("unknown:imu~r", "imu", "coefficient", amount),
        "pressure": ("pressure_offset", "pressure", "offset", amount),
        "drift": ("pressure_drift", "pressure", "rate", amount),
    }[kind]
    return Way(how, amount, effect, topic, number, change)


def _by_day(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    runs = hovercraft(data, out)
    for day in ("2019-04-11", "2019-04-16"):
        yield f"hovercraft_{day}", [bag for bag in runs if day in bag.name]


def _of_reference(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    bags = dives(data, out, "reference")
    for first in range(0, len(bags) - 15, 16):
        yield f"haizhe_{first:03d}", bags[first : first + 16]


SETS = (
    DataSet(
        "hovercraft_epfl", "hovercraft_epfl", _by_day, 6,
        (
            Draw("gain:0", -0.3, -0.1, both=False), Draw("gain:1", -0.3, -0.1, both=False),
            Draw("delay:pose", 0.05, 0.2, both=False), Draw("delay:thruster_command", -0.3, -0.1, both=False),
            Draw("scale", 0.05, 0.15),
        ),
    ),
    DataSet(
        "haizhe_auv", "haizhe_auv", _of_reference, 16,
        (
            Draw("delay:compass", 0.1, 0.4, both=False), Draw("delay:imu", 0.1, 0.4, both=False),
            Draw("delay:pressure", 0.3, 0.8, both=False),
            Draw("compass", 0.1, 0.3), Draw("heading", 0.1, 0.5), Draw("mirror", 1.0, 1.0, both=False),
            Draw("gyro", 0.02, 0.08), Draw("gyroscale", 0.1, 0.3), Draw("pressure", 300.0, 1500.0),
            Draw("drift", 20.0, 80.0),
        ),
    ),
)  # fmt: skip


def halves(data: Path, out: Path) -> list[tuple[Halves, DataSet]]:
    """Every second recording of each group against the others, of the data sets that are there."""
    found = []
    for each in SETS:
        if not (data / each.folder).exists():
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


def judged(said: dict[str, Any] | None, way: Way | None) -> dict[str, Any]:
    """The outcome of one diagnosis, and what it names beside what was put in."""
    if said is None:
        return {"outcome": NONE, "beside": [], "named": []}
    named = [*effects(said), *({"id": each["parameter"], "parameters": {}} for each in said["recalibrated"])]
    own = [each for each in named if way and _is_it(each, way)]
    beside = [each["id"] for each in named if each not in own]
    outcome = RIGHT if own and any(_fits(each, way) for each in own) else WRONG if named else SILENT
    if way is None:
        outcome = WRONG if named else RIGHT
    elif outcome == SILENT and way.effect in said["not_shown_by_this_recording"]:
        outcome = BLIND
    return {"outcome": outcome, "beside": beside, "named": [each["id"] for each in named]}


def _is_it(effect: dict[str, Any], way: Way) -> bool:
    topic = effect.get("topic")
    return effect["id"] == way.effect and (not topic or not way.topic or topic == way.topic)


def _fits(effect: dict[str, Any], way: Way | None) -> bool:
    """Tell whether the number of an effect is what was put in, within its interval or WITHIN."""
    if way is None or not way.parameter:
        return True
    told = effect["parameters"].get(way.parameter)
    if told is None or told["value"] is None:
        return False
    low, high = (each if each is not None else math.nan for each in told["ci95"])
    neutral = 1.0 if way.effect == "camera_scale" else 0.0
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
    plan = drawn(halves(data, out), source["count"], source["seed"])
    outcomes = diagnose([task(group, way, out) for group, way in plan], terms)
    seconds = {each.name: each.seconds for each in outcomes}
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
        "Right: the effect is named and its number is what was put in, within 30 % or its interval.", "",
        sentence(source), "",
        "| recordings | altered | to be found | outcome | named | halves of GOOD |", "|---|---|---|---|---|---|",
        *lines, "",
    ]  # fmt: skip
