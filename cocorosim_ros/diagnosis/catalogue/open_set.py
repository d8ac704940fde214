"""Everything that is looked for outside the catalogue: laws of motion and laws of readings."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.eddies import EDDY, eddy_entry
from cocorosim_ros.diagnosis.catalogue.entry import Entry, Scene
from cocorosim_ros.diagnosis.catalogue.laws import law_entries
from cocorosim_ros.diagnosis.catalogue.sensor_laws import sensor_law_entries
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects import LAWS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS


def open_set(scene: Scene, found: Sequence[Entry], rows: Floats, *, water: bool) -> list[Entry]:
    """All laws beside those that are found, each with the odds against one of so many.

    rows (tracks, columns): the base model. What laws it has already keep their places, and their coefficients may turn
    out to be others; all other laws are looked for in the first place that is free, if one is. `water`: something is
    wrong with the water, so that it is worth to look for an eddy, which takes longer.
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


def _coefficient(rows: Floats, place: str) -> Floats:
    """(tracks,) of the law in a place, 0 where there is none."""
    return rows[:, COLUMN[f"{place}.coefficient"]]


def _is_held(entry: Entry, place: str, scene: Scene, rows: Floats) -> bool:
    """Whether this is the law that the rows have in the place."""
    having = rows[_coefficient(rows, place) != 0.0]
    return all((having[:, COLUMN[column]] == value(scene)).all() for column, value in entry.fixed.items())
