"""The open set: all laws of motion and of readings that are looked for outside the catalogue."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.eddies import EDDY, eddy_entry
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.catalogue.laws import law_entries
from cocorosim_ros.diagnosis.catalogue.sensor_laws import sensor_law_entries
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects import LAWS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS
from cocorosim_ros.world.terms.search import Scene


def open_set(scene: Scene, found: Sequence[Entry], rows: Floats, *, water: bool) -> list[Entry]:
    """Make entries of all laws outside the catalogue, each with the odds against one of so many as its prior.

    A place is one of the few effects of simulator or sensors that can act for a law; each holds one law.
    found: entries that were named already; their places are taken.
    rows (tracks, columns): the base model. Its laws keep their places, and their coefficients may be found to differ;
    all other laws are looked for in the first free place, if there is one.
    water: True if something is wrong with the water, so that an eddy is looked for too, which takes longer.
    """
    taken = {entry.law for entry in found}
    every: list[Entry] = []
    for places, entries in ((LAWS, law_entries), (SENSOR_LAWS, sensor_law_entries)):
        held = [place for place in places if _coefficient(rows, place).any()]
        known = [entry for place in held for entry in entries(scene, place) if _is_held(entry, place, scene, rows)]
        free = next((place for place in places if place not in taken and place not in held), None)
        other = entries(scene, free) if free is not None else []
        every += [*known, *(entry for entry in other if entry.name not in {each.name for each in known})]
    if water and EDDY not in taken:
        every.append(eddy_entry(scene))
    against = math.log(max(len(every), 1))
    return [replace(entry, prior_nats=against) for entry in every]


def free_place(rows: Floats) -> str | None:
    """Name the first place for a law of motion that no law of a model, rows (tracks, columns), has taken."""
    return next((place for place in LAWS if not _coefficient(rows, place).any()), None)


def _coefficient(rows: Floats, place: str) -> Floats:
    """Coefficients (tracks,) of the law in a place, 0 where there is none."""
    return rows[:, COLUMN[f"{place}.coefficient"]]


def _is_held(entry: Entry, place: str, scene: Scene, rows: Floats) -> bool:
    """Tell whether an entry is the law that the rows have in a place."""
    having = rows[_coefficient(rows, place) != 0.0]
    return all((having[:, COLUMN[column]] == value(scene)).all() for column, value in entry.fixed.items())
