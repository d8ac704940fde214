"""The track of one robot, as a recording or a simulation delivers it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.card import Card, Shown
from cocorosim_ros.foundation.data_frame import data_frame

if TYPE_CHECKING:
    import pandas as pd


POSES_AT_ONCE = 16_384
"""Poses that are looked up together, so that memory does not grow with a recording."""


class Poses(Protocol):
    """Poses of one robot, wherever they are kept."""

    @property
    def stamp_ns(self) -> Integers:
        """(t,) moment of each pose [ns]."""
        ...

    def at(self, rows: Integers) -> tuple[Floats, Floats]:
        """Position (n, 3) [m; world] and yaw (n,) [rad; world] of the poses `rows` (n,)."""
        ...


def poses_in_parts(track: Poses) -> Iterator[tuple[Integers, Floats, Floats]]:
    """All poses of a track, part after part: rows (n,), position (n, 3) [m; world] and yaw (n,) [rad; world]."""
    for begin in range(0, track.stamp_ns.size, POSES_AT_ONCE):
        rows = np.arange(begin, min(begin + POSES_AT_ONCE, track.stamp_ns.size))
        yield rows, *track.at(rows)


@dataclass(frozen=True, repr=False)
class PoseTrack(Shown):
    """Poses of one robot in the order of their stamps."""

    stamp_ns: Integers
    """(t,) moment of each pose [ns]."""
    position: Floats
    """(t, 3) position [m; world]."""
    yaw: Floats
    """(t,) heading [rad; world, counter-clockwise from +x]."""

    def at(self, rows: Integers) -> tuple[Floats, Floats]:
        """Position (n, 3) [m; world] and yaw (n,) [rad; world] of the poses `rows` (n,)."""
        return self.position[rows], self.yaw[rows]

    def to_frame(self) -> pd.DataFrame:
        """One row a pose: stamp_ns [ns], x, y, z [m], yaw [rad]; world."""
        places = {name: self.position[:, place] for place, name in enumerate("xyz")}
        return data_frame({"stamp_ns": self.stamp_ns, **places, "yaw": self.yaw})

    def card(self) -> Card:
        """How many poses there are, and the first and the last of them."""
        count = len(self.stamp_ns)
        rows = [self._row(name, place) for name, place in (("first", 0), ("last", -1)) if count]
        length = f"{(self.stamp_ns[-1] - self.stamp_ns[0]) * 1e-9:.3f} s" if count else "-"
        headings = ("pose", "x [m]", "y [m]", "z [m]", "yaw [rad]")
        return Card("track", {"poses": str(count), "length": length}, headings, rows)

    def _row(self, name: str, place: int) -> tuple[str, ...]:
        return name, *(f"{number:.3f}" for number in (*self.position[place], self.yaw[place]))
