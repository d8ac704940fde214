"""Units of a map that its log makes doubtful: angles that look like degrees, and times that no vehicle records."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.entry import listed
from cocorosim_ros.wire.conversion.conversion_map import ColumnValue, Value
from cocorosim_ros.wire.conversion.rows import Stamps

MINUTES_NS = 60_000_000_000  # between readings, median; gliders at sea report every 10 s or so
FAST_NS = 240_000  # the same; 4 kHz is the fastest usual rate, of inertial sensors
_DEGREES = (-180.5, 360.5)  # headings in degrees lie between, whichever way they are wrapped
_WRAP = 300.0  # a step of so much is a turn of less than 60 degrees through north
_MANY = 20  # readings, from which their rate is told
_FEW = 0.05  # share of the readings that may be faulty


def like_degrees(angles: Floats) -> bool:
    """Tell whether (n,) angles that should be in radians look like degrees.

    They lie beyond a turn and within a turn of degrees, and are wrapped at 360, or are never within the first turn, or
    take steps of more than half a turn of radians, though most are shorter. An unwrapped heading of a vehicle that
    spins takes none such: it could not have been unwrapped.
    """
    given = angles[np.isfinite(angles)]
    turn = 2.0 * math.pi
    if given.size < 2 or np.mean(np.abs(given) > turn) <= _FEW:
        return False
    if np.mean((given < _DEGREES[0]) | (given > _DEGREES[1])) > _FEW:
        return False
    step = np.abs(np.diff(given))
    long = float(np.mean(step > math.pi + 1e-6))
    return bool((step > _WRAP).any() or np.abs(given).min() > turn or 0.0 < long < 0.5)


def doubtful_angles(place: str, values: Mapping[str, Value], columns: Mapping[str, Floats]) -> list[str]:
    """Sentences on angles of a stream that a map gives in radians and that look like degrees; `columns` [SI]."""
    found = []
    for name, value in values.items():
        if not isinstance(value, ColumnValue) or value.unit_factor != "1" or not value.scale:
            continue
        offset = value.offset if isinstance(value.offset, float) else 0.0
        cells = np.round((columns[name] - offset) / value.scale, 6) + 0.0  # no negative zero
        if like_degrees(cells):
            ends = f"from {np.nanmin(cells):.4g} to {np.nanmax(cells):.4g} rad"
            found.append(f"{place}: '{name}' goes {ends}, as degrees do; check its 'unit' in the map.")
    return found


def doubtful_times(stamps: Mapping[str, Sequence[Stamps]]) -> list[str]:
    """Sentences on topics whose readings are minutes apart, or fractions of a millisecond, or all at one moment.

    stamps: by name of the topic, of its messages [ns].
    """
    moments = {name: np.unique(np.concatenate(parts)) for name, parts in stamps.items() if sum(map(len, parts)) > 2}
    apart = {name: float(np.median(np.diff(each))) for name, each in moments.items() if len(each) > 1}
    # Four thrusters may be reported within nanoseconds, and not again for a second.
    usual = {name: float(np.ptp(each)) / (len(each) - 1) for name, each in moments.items() if len(each) >= _MANY}
    found = []
    if still := [name for name, each in moments.items() if len(each) == 1]:
        found.append(f"All readings of {listed(still, 'and')} have one time; check the column of 'time' in the map.")
    slow = {name: interval for name, interval in apart.items() if interval > MINUTES_NS}
    fast = {name: interval for name, interval in usual.items() if interval < FAST_NS}
    for many in (slow, fast):
        if many:
            seconds = max(many.values()) / 1e9
            told = f"Readings of {listed(list(many), 'and')} are {seconds:.4g} s apart"
            found.append(f"{told}; check the unit of 'time' in the map.")
    return found
