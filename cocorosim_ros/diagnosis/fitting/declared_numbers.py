"""Numbers of effects that a platform's file gives with a range: fitted beside its mass, drag and gains.

A file that says `effects: {linear_drag: {yaw: {value: 0.3, unit: N m s, range: [0, 1], ...}}}` tells that the vehicle
has this drag and that its size is not known. So it belongs to the base of every model of the vehicle, and is never
named as missing. The range is a limit: no fit leaves it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from cocorosim_ros.diagnosis.criteria.fitting import RECALIBRATION
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Owner, Unknown
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.scenario.reading.ranges import Range, Ranges

SECTION = "effects."


def declared_unknowns(tracks: Sequence[Track]) -> list[Unknown]:
    """Make one unknown of each robot for every number of an effect that its platform gives with a range."""
    return [
        _unknown(robot, numbers, column, limits, float(tracks[numbers[0]].vehicle.row[COLUMN[column]]))
        for robot, numbers in tracks_by_robot(tracks).items()
        for column, limits in _declared(tracks[numbers[0]].vehicle.ranges)
    ]


def declared_columns(unknowns: Sequence[Unknown]) -> frozenset[str]:
    """Columns of the effects' numbers among the unknowns of a platform."""
    return frozenset(each.column for each in unknowns if each.owner.effect == PLATFORM and "." in each.column)


def _declared(ranges: Ranges) -> Iterator[tuple[str, Range]]:
    """Columns of effects that have a range, with it."""
    for key, limits in ranges.items():
        column = key.removeprefix(SECTION)
        if key.startswith(SECTION) and column in COLUMN:
            yield column, limits


def _unknown(robot: str, numbers: tuple[int, ...], column: str, limits: Range, base: float) -> Unknown:
    width = (limits.high - limits.low) / RECALIBRATION.range_widths
    bounds = ((limits.low - base) / width, (limits.high - base) / width)
    owner = Owner(PLATFORM, (robot,), column, limits.unit)
    return Unknown(owner, column, numbers, base, scale=width, prior=1.0, bounds=bounds)
