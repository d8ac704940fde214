"""Numbers of effects and of single actuators that a platform's file gives with a range: fitted beside its mass.

A file that says `effects: {linear_drag: {yaw: {value: 0.3, unit: N m s, range: [0, 1], ...}}}` tells that the vehicle
has this drag and that its size is not known. So it belongs to the base of every model of the vehicle, and is never
named as missing. The range is a limit: no fit leaves it. The same holds of a thruster's own gain, and of
what a rudder leaves open. What the file keeps as given is the vehicle's own as well, and is not fitted.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import RECALIBRATION
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Owner, Unknown, deviation
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, OWN_GAINS
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.scenario.reading.ranges import Range

SECTION = "effects."


def declared_unknowns(tracks: Sequence[Track]) -> list[Unknown]:
    """Make one unknown of each robot for every number of an effect or actuator that its platform gives with a range.

    Numbers that the file keeps as given make none.
    """
    return [
        _unknown(robot, numbers, declared, float(tracks[numbers[0]].vehicle.row[COLUMN[declared.column]]))
        for robot, numbers in tracks_by_robot(tracks).items()
        for declared in _declared(tracks[numbers[0]].vehicle)
        if declared.key not in tracks[numbers[0]].vehicle.kept
    ]


def declared_columns(tracks: Sequence[Track]) -> frozenset[str]:
    """Columns of the effects' numbers that the platforms of some tracks give with a range."""
    every = (declared for track in tracks for declared in _declared(track.vehicle))
    return frozenset(each.column for each in every if "." in each.column)


def is_steered_alone(vehicle: VehicleModel) -> bool:
    """Tell whether the platform gives the own gain of every thruster with a range, so that no common one is left."""
    gains = [key for key, number in vehicle.own.items() if number.column in OWN_GAINS]
    return bool(gains) and len(gains) == np.count_nonzero(vehicle.is_thruster) and set(gains) <= set(vehicle.ranges)


class _Ranged(NamedTuple):
    """A number with a range, and the 95 % interval if there is one.

    key: of the platform's file. name: how a diagnosis calls it.
    """

    key: str
    column: str
    name: str
    limits: Range
    interval: Range | None


def _declared(vehicle: VehicleModel) -> Iterator[_Ranged]:
    """Numbers of effects and of single actuators that have a range."""
    for key, limits in vehicle.ranges.items():
        column = key.removeprefix(SECTION)
        if key.startswith(SECTION) and column in COLUMN:
            yield _Ranged(key, column, column, limits, vehicle.intervals.get(key))
        elif key in vehicle.own:
            yield _Ranged(key, vehicle.own[key].column, key, limits, vehicle.intervals.get(key))


def _unknown(robot: str, numbers: tuple[int, ...], declared: _Ranged, base: float) -> Unknown:
    limits = declared.limits
    width = (limits.high - limits.low) / RECALIBRATION.range_widths
    bounds = ((limits.low - base) / width, (limits.high - base) / width)
    owner = Owner(PLATFORM, (robot,), declared.name, limits.unit)
    given = declared.interval
    stated = deviation(given.low, given.high) / width if given is not None else 0.0
    return Unknown(owner, declared.column, numbers, base, scale=width, prior=1.0, bounds=bounds, stated=stated)
