"""Errors of readings that count in a free run: those that something else than the erring readings fixes.

A law of a reading that alone shows a state can move the course at will, and would then be confirmed by the very course
that it moved. So a model foretells a reading with its own error of it only where other readings show the same, or
another instrument what the error is told in terms of, as of an antenna off the centre a compass the heading; where none
does, the error is the recalibrated model's, which knows the platform's file alone. Errors of stamps always count,
because the times of the commands fix them.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.catalogue.shown_by import erring, is_shown, own_state
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, TIMING
from cocorosim_ros.diagnosis.tracks.timeline import Timeline
from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.world.laws.readings import READINGS
from cocorosim_ros.world.sensors.errors import ERROR_COLUMNS, ERRORS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS

STATE_OF_FORCE = {"accel_x": "u", "accel_y": "v", "accel_z": "w"}
"""The state of which an accelerometer shows the rate."""


OF_READINGS: Integers = np.array(
    [
        *range(TIMING.start, TIMING.stop),
        *(COLUMN[name] for name in ERROR_COLUMNS),
        *(COLUMN[f"{place}.{number.name}"] for place, numbers in SENSOR_LAWS.items() for number in numbers),
    ]
)
"""Places in a row of all errors of readings and stamps."""


def with_fixed_errors(plain: Floats, row: Floats, timeline: Timeline) -> Floats:
    """Copy the row `plain` (columns,) of the recalibrated model, with those errors of readings in `row` that count."""
    found = plain.copy()
    found[TIMING] = row[TIMING]
    for name in ERROR_COLUMNS:
        if _is_told_by_others(name, timeline) or any(_is_fixed(kind, timeline) for kind in _kinds_of(name)):
            found[COLUMN[name]] = row[COLUMN[name]]
    for place, numbers in SENSOR_LAWS.items():
        columns = [COLUMN[f"{place}.{number.name}"] for number in numbers]
        if row[columns[0]] != 0.0 and _is_fixed(READINGS[int(row[columns[1]])].name, timeline):
            found[columns] = row[columns]
    return np.asarray(found)


def _kinds_of(column: str) -> list[str]:
    """Kinds of readings that an error's number, named by its column, changes."""
    error, _, number = column.partition(".")
    return [change.kind for change in ERRORS[error].changes if number in change.numbers]


def _is_told_by_others(column: str, timeline: Timeline) -> bool:
    """Tell whether readings that do not err show what an error, by a column of it, says that it is told in terms of."""
    error = ERRORS[column.partition(".")[0]]
    wrong = erring(error)
    return bool(error.told_by) and all(is_shown(state, wrong, timeline.kinds) for state in error.told_by)


def _is_fixed(kind: str, timeline: Timeline) -> bool:
    """Tell whether other readings show what readings of this kind show."""
    state = next(iter(own_state(kind)), STATE_OF_FORCE.get(kind))
    return state is not None and is_shown(state, (kind,), timeline.kinds)
