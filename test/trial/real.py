"""Arm three: real recordings as they are. Some are diagnosed; on the others, unseen, the found model runs freely."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from trial.examiner import Task, Terms
from trial.other_half import TIERS, kept
from trial.provenance import sentence
from trial.real_page import kept_lines, page_of
from trial.recordings import (
    MANEUVERING1,
    NLP1,
    Group,
    crossings,
    dives,
    flights,
    hovercraft,
    minutes_in_the_pool,
    parts_of_a_mission,
    pond,
    zigzags,
)
from trial.sealed import diagnose
from trial.ships import FITTED_ZIGZAGS, TANKER, WINDY, WINDY_DAY, ships
from trial.thruster import FOLDER, thruster_rows
from trial.unseen import OnUnseen, on_unseen
from trial.ways import answer, effects


def _hovercraft(data: Path, out: Path) -> Iterator[tuple[str, str, list[Path], list[Path]]]:
    runs = hovercraft(data, out)
    for day in ("2019-04-11", "2019-04-16"):
        own = [bag for bag in runs if day in bag.name]
        yield f"hovercraft_{day}", "hovercraft_epfl", own[0::2], own[1::2]


def _haizhe(data: Path, out: Path) -> Iterator[tuple[str, str, list[Path], list[Path]]]:
    for name, kind in (("haizhe_reference", "reference"), ("haizhe_under_test", "runs_under_test")):
        own = dives(data, out, kind)
        yield name, "haizhe_auv", own[0:16:2], own[1:16:2]


def _tauv(data: Path, out: Path) -> Iterator[tuple[str, str, list[Path], list[Path]]]:
    own = minutes_in_the_pool(data, out)[1:9]  # before it the vehicle is let into the water, later it hardly moves
    yield "tauv_pool", "tauv_pool", own[0::2], own[1::2]


def _rgblimp(data: Path, out: Path) -> Iterator[tuple[str, str, list[Path], list[Path]]]:
    own = flights(data, out)
    yield "rgblimp", "rgblimp", own[0::2], own[1::2]


def _glider(data: Path, out: Path) -> Iterator[tuple[str, str, list[Path], list[Path]]]:
    own = parts_of_a_mission(data, out)
    yield "slocum_glider", "slocum_glider", own[:1], own[1:]


def _tanker(data: Path, out: Path) -> Iterator[tuple[str, str, list[Path], list[Path]]]:
    own = zigzags(data, out)
    fitted = [bag for bag in own if bag.name in FITTED_ZIGZAGS]
    yield TANKER, "kvlcc2_hsva", fitted, [bag for bag in own if bag not in fitted]


def _windy(data: Path, out: Path) -> Iterator[tuple[str, str, list[Path], list[Path]]]:
    # Half of the zigzags, which all run to the north, so that wind abeam looks like a ship that pulls to one side; and
    # half of the random drives of the same day. Other days have other winds.
    own = pond(data, out, "zigzag")
    to_all_sides = [bag for bag in pond(data, out, "random") if WINDY_DAY in bag.name]
    yield WINDY, "esso_osaka", own[0::2] + to_all_sides[0::2], own[1::2] + to_all_sides[1::2]


def _ferry(data: Path, out: Path) -> Iterator[tuple[str, str, list[Path], list[Path]]]:
    for trial in (NLP1, MANEUVERING1):
        own = crossings(data, out, *trial)
        yield f"milliampere_{trial[0]}", "milliampere_ferry", own[0::2], own[1::2]


SETS: dict[str, Callable[[Path, Path], Iterator[tuple[str, str, list[Path], list[Path]]]]] = {
    "hovercraft_epfl": _hovercraft,
    "haizhe_auv": _haizhe,
    "tauv_pool": _tauv,
    "rgblimp": _rgblimp,
    "slocum_glider": _glider,
    "kvlcc2_hsva": _tanker,
    "esso_osaka": _windy,
    "milliampere_ferry": _ferry,
}
"""By folder of the data: groups of recordings by name and platform, those learnt from and those held out."""


def groups(data: Path, out: Path, sets: Sequence[str]) -> list[tuple[Group, Group]]:
    """Recordings to learn from, and recordings of the same vehicle that are held out, of the data sets asked for.

    Raises ValueError for a data set that is not in SETS.
    """
    unknown = [name for name in sets if name not in SETS]
    if unknown:
        raise ValueError(f"{unknown[0]} is not a data set of real recordings; there are {', '.join(SETS)}")
    pairs = [pair for name in sets if (data / name).exists() for pair in SETS[name](data, out)]
    return [
        (Group(name, platform, tuple(some)), Group(f"{name}_held_out", platform, tuple(others)))
        for name, platform, some, others in pairs
        if some and others
    ]


def learn(pair: tuple[Group, Group], out: Path) -> list[Task]:
    """Diagnoses by the platform's file, of what is learnt from and of the other half, and of one half by the other."""
    own, others = pair
    return [
        Task(own.name, own.bags, out / "diagnoses" / own.name, own.platform),
        Task(others.name, others.bags, out / "diagnoses" / others.name, own.platform),
        Task(f"{own.name}_halves", others.bags, out / "diagnoses" / f"{own.name}_halves", own.platform, own.bags),
    ]


def replay(pair: tuple[Group, Group], out: Path) -> Task:
    """What is learnt from once more, with the model that it gave as the platform."""
    own = pair[0]
    again = f"{own.name}_by_model"
    return Task(again, own.bags, out / "diagnoses" / again, str(out / "diagnoses" / own.name / "model.yaml"))


def _number(value: Any) -> str:
    """Three digits of a number; words as they are, such as what was wrong with a frame."""
    return "-" if value is None else value if isinstance(value, str) else f"{value:.3g}"


def held_out(pair: tuple[Group, Group], out: Path) -> list[str]:
    """Rows: by channel, errors within the recordings learnt from, and on those that were never seen."""
    own, others = pair
    said = answer(out / "diagnoses" / own.name) or {}
    model = out / "diagnoses" / own.name / "model.yaml"
    never_seen = on_unseen(own.platform, model, others.bags) if model.is_file() else {}
    lines = []
    for channel, scores in ((said.get("fit") or {}).get("held_out") or {}).items():
        inside = " | ".join(_number(scores.get(key)) for key in ("nominal", "recalibrated", "augmented", "noise_floor"))
        lasts = f" after up to {scores['seconds']:g} s" if "seconds" in scores else ""
        ruler = ", course" if scores.get("against") == "course" else ""
        name = f"{own.name} | {channel} [{scores.get('unit', '')}]{lasts}{ruler}"
        lines.append(f"| {name} | {inside} | {_on_unseen(never_seen.get(channel))} |")
    return lines


def _on_unseen(told: OnUnseen | None) -> str:
    """Two cells: the errors of the platform's file and of the found model over the same windows."""
    if told is None:
        return "- | -"
    lasts = f"({told.seconds:g} s, {told.windows} windows, {100 * told.worse:.0f} % worse)"
    return f"{_number(told.nominal)} | {_number(told.found)} {lasts}"


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
    passed = [f"`{each['id']}` ({each.get('nats') or 0:.0f} nats)" for each in said.get("passed_over") or []]
    return [*lines, f"  - passed over, since they may as well be nothing: {', '.join(passed)}"] if passed else lines


def again(pair: tuple[Group, Group], out: Path) -> str:
    """Row: what is said of the recordings learnt from by the model found there, and of one half against the other."""
    cells = []
    for name in (f"{pair[0].name}_by_model", f"{pair[0].name}_halves"):
        said = answer(out / "diagnoses" / name)
        named = ", ".join(f"`{effect['id']}`" for effect in effects(said))
        cells.append("no diagnosis" if said is None else f"{said['verdict']}{': ' if named else ''}{named}")
    return f"| {pair[0].name} | {cells[0]} | {cells[1]} |"


def other_half(pair: tuple[Group, Group], out: Path) -> str:
    """Row: effects of the recordings learnt from that a diagnosis of the other half finds too, by tier."""
    own, others = (answer(out / "diagnoses" / each.name) for each in pair)
    found = [kept(own, others, tier) for tier in TIERS]
    cells = ["no diagnosis" if each is None else each.words for each in found]
    return f"| {pair[0].name} | {' | '.join(cells)} |"


def prove(data: Path, out: Path, pages: Path, terms: Terms, source: dict[str, Any], sets: Sequence[str] = ()) -> int:
    """Converts, diagnoses, tries on what was held out, and writes the page; source: what made it.

    sets: data sets by folder, all if left out; what an earlier page says of others is kept.
    """
    pairs = groups(data, out, [name for name in sets if name != FOLDER] if sets else tuple(SETS))
    diagnose([task for pair in pairs for task in learn(pair, out)], replace(terms, keep_reports=True))
    rest = [replay(pair, out) for pair in pairs if answer(out / "diagnoses" / pair[0].name)]
    diagnose(rest, replace(terms, keep_reports=True))
    of_thruster = thruster_rows(data) if not sets or FOLDER in sets else []
    anew = [pair[0].name for pair in pairs] + [row.split()[1] for row in of_thruster]
    made, kept = kept_lines(pages / "real.md", anew)
    mine = f"{sentence(source)} ({', '.join([pair[0].name for pair in pairs] + [FOLDER] * bool(of_thruster))})"
    own = {
        "found": [line for pair in pairs for line in findings(pair, out)],
        "runs": [line for pair in pairs for line in held_out(pair, out)],
        "again": [again(pair, out) for pair in pairs],
        "other": [other_half(pair, out) for pair in pairs],
        "ships": ships(pairs, data, out),
        "thruster": of_thruster,
    }
    text = page_of(own, [*(line for line in made if line != mine), mine], kept)
    pages.mkdir(parents=True, exist_ok=True)
    (pages / "real.md").write_text("\n".join(text), encoding="utf-8")
    facts = {
        path.parent.name: json.loads(path.read_text()) for path in sorted(Path(out).glob("diagnoses/*/diagnosis.json"))
    }
    (pages / "real.json").write_text(json.dumps(facts, indent=1) + "\n", encoding="utf-8")
    print("\n".join(text))
    return 0
