"""Trims of rudders and fins as entries: the angle at which one stands when it is told zero.

A linkage that has slipped, or a zero that was set badly, turns a vehicle by a force that grows with the square of its
speed. It is a number of the platform's file, as a gain of a single thruster is.
"""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry
from cocorosim_ros.diagnosis.criteria.naming import FACTORS
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.own_numbers import trim_key
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.world.terms.groups import TURN, WEIGHT

STEERING_TRIM = "steering_trim"


def trim_entries(tracks: Sequence[Track]) -> list[Entry]:
    """Make an entry of the trim of every rudder and fin of the vehicle."""
    begin, end = trim_key("*").split("*")
    vehicle = tracks[0].vehicle
    trims = {key: each.column for key, each in vehicle.own.items() if key.startswith(begin) and key.endswith(end)}
    return [
        _entry(key.removeprefix(begin).removesuffix(end), column, upright=pushes_upwards(vehicle, column))
        for key, column in trims.items()
    ]


def trimmed(identifier: str) -> str:
    """Name of the rudder or fin that an entry is of; '' for every other entry."""
    kind, _, name = identifier.partition(":")
    return name if kind == STEERING_TRIM else ""


def pushes_upwards(vehicle: VehicleModel, column: str) -> bool:
    """Tell whether a number is of a fin that pushes more upwards than to the side."""
    up, left = (COLUMN.get(f"{column.partition('.')[0]}.{part}") for part in ("up", "left"))
    return up is not None and left is not None and abs(vehicle.nominal[up]) > abs(vehicle.nominal[left])


def _entry(name: str, column: str, *, upright: bool) -> Entry:
    amplitude = Amplitude(column, name, "rad", FACTORS.large_trim)
    return Entry(
        f"{STEERING_TRIM}:{name}",
        f"{name} that stands askew at command zero",
        "angle = command + trim",
        "heave" if upright else "yaw",
        (amplitude,),
        group=WEIGHT if upright else TURN,
    )
