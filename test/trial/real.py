"""Arm three: real recordings as they are. Some are diagnosed; on the others, unseen, the found model runs freely."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from trial.examiner import Task, Terms
from trial.real_figures import group_figures, merged, read, write
from trial.real_page import write_page
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
from trial.ships import FITTED_ZIGZAGS, TANKER, WINDY, WINDY_DAY, ship_figures
from trial.thruster import FOLDER, thruster_figures
from trial.ways import answer


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


def prove(data: Path, out: Path, pages: Path, terms: Terms, source: dict[str, Any], sets: Sequence[str] = ()) -> int:
    """Converts, diagnoses, tries on what was held out, and writes figures and page; source: what made them.

    sets: data sets by folder, all if left out; what earlier figures tell of others is kept.
    """
    pairs = groups(data, out, [name for name in sets if name != FOLDER] if sets else tuple(SETS))
    diagnose([task for pair in pairs for task in learn(pair, out)], replace(terms, keep_reports=True))
    rest = [replay(pair, out) for pair in pairs if answer(out / "diagnoses" / pair[0].name)]
    diagnose(rest, replace(terms, keep_reports=True))
    of_thruster = thruster_figures(data) if not sets or FOLDER in sets else {}
    made = {name: source[name] for name in ("command", "commit")}
    new = {
        "sources": [made | {"of": [*(own.name for own, _ in pairs), *([FOLDER] if of_thruster else [])]}],
        "groups": {pair[0].name: group_figures(pair, out) for pair in pairs},
        "ships": ship_figures(pairs, data, out),
        "thruster": of_thruster,
    }
    pages.mkdir(parents=True, exist_ok=True)
    write(pages / "real.json", merged(read(pages / "real.json"), new))
    print("\n".join(write_page(pages)))
    return 0
