"""Everything that is looked for outside the catalogue: laws of motion and laws of readings."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.eddies import EDDY, eddy_entry
from cocorosim_ros.diagnosis.entry import Entry, Scene
from cocorosim_ros.diagnosis.laws import law_entries
from cocorosim_ros.diagnosis.sensor_laws import sensor_law_entries


def open_set(scene: Scene, found: Sequence[Entry], *, water: bool) -> list[Entry]:
    """All laws beside those that are found, each with the odds against one of so many.

    `water`: something is wrong with the water, so that it is worth to look for an eddy, which takes longer.
    """
    taken = [entry.law for entry in found if entry.law is not None]
    every = [*law_entries(scene, taken), *sensor_law_entries(scene, taken)]
    if water and EDDY not in taken:
        every.append(eddy_entry(scene))
    against = math.log(max(len(every), 1))
    return [replace(entry, prior_nats=against) for entry in every]
