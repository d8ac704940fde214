"""Search for what recordings do not show: readings that never vary, and a depth that nothing shows to change.

A map of a vehicle that stays at the surface writes a fixed height, and the filter keeps the vehicle there by it. It is
no reading all the same, and what would be told of it, or of motion upwards, is told of the map.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES, KINDS_OF_STREAM
from cocorosim_ros.diagnosis.findings import Unrecorded
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.world.sensors import KINDS

OF_DEPTH = frozenset(name for name, kind in KINDS.items() if "z" in kind.shows)
"""Kinds of readings that show a depth, or how it changes."""


def unrecorded(tracks: Sequence[Track]) -> Unrecorded:
    """Find kinds of readings that have one value throughout each recording, or none; and whether none shows depth."""
    present, varying, asked = set[str](), set[str](), set[str]()
    for track in tracks:
        for topic, kinds in KINDS_OF_STREAM.items():
            if topic not in track.log.streams:
                continue
            for kind, column in zip(kinds, track.log.streams[topic].value.T, strict=True):
                given = column[np.isfinite(column)]
                asked |= {KIND_NAMES[kind]}
                present |= {KIND_NAMES[kind]} if given.size else set()
                varying |= {KIND_NAMES[kind]} if given.size and np.ptp(given) > 0.0 else set()
    steady = tuple(name for name in KIND_NAMES if name in present - varying)
    absent = tuple(name for name in KIND_NAMES if name in asked - present)
    return Unrecorded(steady, absent, depth=OF_DEPTH.isdisjoint(varying))
