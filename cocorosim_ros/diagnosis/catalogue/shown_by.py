"""Readings by the state that they show, so that an error of a reading is told in terms of other readings.

An error in proportion to a state that this reading alone shows can be had for nothing: the state is bent until the rest
fits. So an error of a reading is looked for only in terms of what other readings show, or of what is known without any:
the time and the commands. Errors of stamps, latencies and skews, are told in terms of the time.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.world.sensors import KINDS, SENSORS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.sensors.sensor_error import SensorError

Kinds = Collection[str]
_LOGS = (("velocity_u", "velocity_v"), ("ground_velocity_u", "ground_velocity_v"))
_SPEED = (("pose_x", "pose_y", "pose_yaw"), ("pose_x", "pose_y", "compass"))
_TOGETHER: dict[str, tuple[tuple[str, ...], ...]] = {
    "x": _LOGS,
    "y": _LOGS,
    "u": _SPEED,
    "v": _SPEED,
    "speed": (*_LOGS, *_SPEED),
    "zero_of_yaw": (("compass",), ("pose_yaw",), *(("pose_x", "pose_y", *log) for log in _LOGS)),
}
_STATES = ("x", "y", "z", "w", "yaw", "sin_yaw", "cos_yaw", "r", "u", "v", "speed", "zero_of_yaw")
SHOWN_BY: dict[str, tuple[tuple[str, ...], ...]] = {
    state: (*((name,) for name, kind in KINDS.items() if state in kind.shows), *_TOGETHER.get(state, ()))
    for state in _STATES
}
"""Sets of kinds of readings, by the state that each of them shows. What is not listed is known without readings.

A gyroscope shows the yaw but for a constant, a compass `zero_of_yaw` too.
"""


class Told(NamedTuple):
    """An error of some kinds of readings, and the states in terms of which it is told."""

    kinds: tuple[str, ...]
    states: tuple[str, ...]


LENGTHS = frozenset(("x", "y"))
"""States that a vehicle of known numbers shows by its motion: how far its own thrust takes it."""


def is_shown(state: str, wrong: Kinds, present: Kinds, known: Collection[str] = ()) -> bool:
    """Tell whether readings of the kinds `present` show a state, those of the kinds `wrong` left out.

    known: states that are shown by something else than readings.
    """
    if state not in SHOWN_BY or state in known:
        return True
    return any(all(kind in present and kind not in wrong for kind in each) for each in SHOWN_BY[state])


def own_state(kind: str) -> tuple[str, ...]:
    """Name the state that readings of one kind show by themselves; () where they show none."""
    return next(((state,) for state, sets in SHOWN_BY.items() if (kind,) in sets), ())


def told_by(entry: Entry) -> tuple[Told, ...]:
    """Errors of readings that an entry is made of; () for an entry of motion, and for errors in time alone.

    An error of the catalogue is told in terms of what it says itself, or of what its reading shows where it changes the
    slope of that reading.
    """
    if entry.form is not None:
        factors = entry.form.product.factors
        return (Told((entry.form.of,), tuple(factor.name for factor in factors)),) if entry.topic else ()
    if entry.id not in ERRORS:
        return ()
    error, changes = ERRORS[entry.id], ERRORS[entry.id].changes
    wrong = erring(error)
    if error.told_by:
        return (Told(wrong, error.told_by),)
    return tuple(Told(wrong, own_state(change.kind)) for change in changes if change.slope)


def erring(error: SensorError) -> tuple[str, ...]:
    """Kinds of readings that do not tell an error: those that it changes, or all of its instrument."""
    if error.by_another:
        return tuple(kind.name for kind in SENSORS[error.sensor].kinds)
    return tuple(change.kind for change in error.changes)


def can_be_told(entry: Entry, recordings: Sequence[Kinds], known: Collection[str] = ()) -> bool:
    """Tell whether any recording of a robot shows what an entry is told in terms of, without the readings in error.

    recordings: kinds of readings of each recording, by name. An error of several readings is told by any of them.
    known: states that are shown by something else. A law outside the catalogue needs readings for all: of these laws
    there are many, and some follow whatever is left.
    """
    told, elsewhere = told_by(entry), () if entry.form is not None else known
    return not told or any(_is_told(each, present, elsewhere) for each in told for present in recordings)


def _is_told(told: Told, present: Kinds, known: Collection[str]) -> bool:
    return any(kind in present for kind in told.kinds) and all(
        is_shown(state, told.kinds, present, known) for state in told.states
    )
