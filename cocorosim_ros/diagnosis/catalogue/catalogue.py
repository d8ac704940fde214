"""ENTRIES: the effects that a diagnosis knows. Their physics are the simulator's, under the same names.

The file of each effect in world/effects, and of each error of a sensor in world/sensors/errors, says how a diagnosis
looks for it: amplitudes, priors, grids.
"""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.entry import Entry, entries_of_error, entry_of
from cocorosim_ros.world.effects import CATALOGUE_EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS

ENTRIES: tuple[Entry, ...] = (
    *(entry_of(name, effect, effect.search) for name, effect in CATALOGUE_EFFECTS.items() if effect.search is not None),
    *(entry for name in ERRORS for entry in entries_of_error(name)),
)
WHERE_RECORDED: tuple[str, ...] = tuple(name for name, error in ERRORS.items() if error.where_recorded)
"""Errors of instruments that few robots have: only recordings with their topics can be said to leave them unseen."""
IDS: tuple[str, ...] = tuple(dict.fromkeys(entry.id for entry in ENTRIES if entry.id not in WHERE_RECORDED))
"""Effects for which every recording is asked."""
