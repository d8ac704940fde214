"""Poses of all robots at common moments: looked up and interpolated, all at once or in parts.

Positions are interpolated linearly and yaw along the shorter arc. What a moment's poses are depends on no other moment,
so that a long recording is measured in parts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.world.state.pose_track import POSES_AT_ONCE, Poses


@dataclass(frozen=True)
class SampledTracks:
    """Poses of all robots at common moments."""

    names: tuple[str, ...]
    """(n,) robots in alphabetical order."""
    stamp_ns: Integers
    """(t,) moments [ns]."""
    position: Floats
    """(t, n, 3) position [m; world], NaN where absent."""
    yaw: Floats
    """(t, n) heading [rad; world], NaN where absent."""
    present: Flags
    """(t, n) robot has a pose at this moment."""
    findings: tuple[str, ...]
    """What was found on the way, in sentences: rates, gaps, poses left out."""

    def parts(self) -> Iterator[SampledTracks]:
        """The poses themselves, all at once."""
        yield self


@dataclass(frozen=True, eq=False)
class Sampling:
    """The common moments of all robots, and whence their poses come when they are asked for."""

    tracks: Mapping[str, Poses]
    """By robot in alphabetical order: growing stamps, finite poses."""
    stamp_ns: Integers
    """(t,) moments [ns]."""
    gap_limits_ns: Mapping[str, int]
    """Longest gap that is interpolated [ns], by robot; robots without poses have none."""
    findings: tuple[str, ...]
    """What was found on the way, in sentences: rates, gaps, poses left out."""

    @property
    def names(self) -> tuple[str, ...]:
        """(n,) robots in alphabetical order."""
        return tuple(self.tracks)

    def parts(self) -> Iterator[SampledTracks]:
        """The poses at successive moments, so many at once that memory does not grow with the recording."""
        moments = max(1, POSES_AT_ONCE // len(self.tracks))
        for begin in range(0, self.stamp_ns.size, moments):
            yield self.at(self.stamp_ns[begin : begin + moments])

    def at(self, moments: Integers) -> SampledTracks:
        """The poses at these moments (t,) [ns]."""
        shape = (moments.size, len(self.tracks))
        position, yaw, present = np.full((*shape, 3), np.nan), np.full(shape, np.nan), np.zeros(shape, np.bool_)
        for column, (name, track) in enumerate(self.tracks.items()):
            if track.stamp_ns.size:
                beside = beside_moments(track.stamp_ns, moments, self.gap_limits_ns[name])
                position[:, column], yaw[:, column] = _interpolated(track, moments, beside)
                present[:, column] = beside.present
        return SampledTracks(self.names, moments, position, yaw, present, self.findings)


class Beside(NamedTuple):
    """Which poses (t,) of one robot lie before and after each moment; the same one twice where a moment has a pose."""

    before: Integers
    after: Integers
    exact: Flags
    gap: Integers  # [ns]
    present: Flags


def beside_moments(stamp_ns: Integers, moments: Integers, limit_ns: int) -> Beside:
    """Where moments (t,) lie among the stamps (n,) [ns], one at least, and whether a gap is short enough there."""
    last = stamp_ns.size - 1
    after = np.clip(np.searchsorted(stamp_ns, moments), 0, last)
    exact = stamp_ns[after] == moments
    before = np.where(exact, after, np.maximum(after - 1, 0))
    gap = stamp_ns[after] - stamp_ns[before]
    inside = (moments > stamp_ns[0]) & (moments < stamp_ns[-1])
    return Beside(before, after, exact, gap, exact | (inside & (gap <= limit_ns)))


def _interpolated(track: Poses, moments: Integers, beside: Beside) -> tuple[Floats, Floats]:
    """Position (t, 3) and yaw (t,) of one robot, NaN where absent; a moment that has a pose gets just this pose."""
    before, after, exact, gap, present = beside
    rows = np.unique(np.concatenate([before, after]))
    position, yaw = track.at(rows)
    first, second = np.searchsorted(rows, before), np.searchsorted(rows, after)
    share = np.where(exact, 0.0, (moments - track.stamp_ns[before]) / np.maximum(gap, 1))
    place = position[first] + share[:, None] * (position[second] - position[first])
    turn = _wrapped(yaw[second] - yaw[first])
    heading = np.where(exact, yaw[first], _wrapped(yaw[first] + share * turn))
    return np.where(present[:, None], place, np.nan), np.where(present, heading, np.nan)


def _wrapped(angle: Floats) -> Floats:
    """The angle in (-pi, pi]."""
    wrapped: Floats = np.pi - np.mod(np.pi - angle, 2.0 * np.pi)
    return wrapped
