"""Errors of one part of an instrument alone, as of the gyroscope of an IMU whose accelerometer is sound.

An entry that has numbers of both pays for all of them with its evidence, and a law of the readings with a single
number, such as one by a depth that hardly changes, would be named in its stead.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.world.sensors.errors import ERRORS


def parts_of_errors(tracks: Sequence[Track]) -> list[Entry]:
    """Make entries with the amplitudes of one unit alone, of errors of several units that were all recorded.

    A unit of which an error has no amplitude of its own makes none: an offset that a drift begins with is an entry.
    """
    found = []
    for entry in ENTRIES:
        units = dict.fromkeys(amplitude.unit for amplitude in entry.amplitudes)
        if entry.id in ERRORS and len(units) > 1 and _sees_all(entry, tracks):
            parts = [tuple(each for each in entry.amplitudes if each.unit == unit) for unit in units]
            found += [replace(entry, amplitudes=part) for part in parts if _has_own(entry, part)]
    return found


def _has_own(entry: Entry, part: Sequence[Amplitude]) -> bool:
    return any(amplitude.column.startswith(f"{entry.id}.") for amplitude in part)


def _sees_all(entry: Entry, tracks: Sequence[Track]) -> bool:
    """Tell whether readings of every kind that an error changes were recorded."""
    kinds = {change.kind for change in ERRORS[entry.id].changes}
    return all(any(track.timeline.sees(kind) for track in tracks) for kind in kinds)
