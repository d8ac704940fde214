"""Differences of a platform's own numbers as entries: gains of thrusters, drags, inertia, gain of pumps, delay."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.fitting.base_model import RECALIBRATED
from cocorosim_ros.diagnosis.naming.single_thrusters import factor_entry, thruster_entries, told_alone
from cocorosim_ros.diagnosis.tracks.columns import ALL_THRUSTERS, COLUMN, OWN_SURGE_DRAG
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.groups import DRAG, TURN, WEIGHT

THRUST, DELAY, SURGE_DRAG = "thrust_gain", "command_delay", "surge_drag"
# By column: identifier, channel and group. The gain of all thrusters together is a number of its own, and so is the
# drag ahead alone.
_WHERE = {
    "yaw_torque_gain": ("yaw", TURN),
    "drag": ("surge", DRAG),
    "yaw_drag": ("yaw", DRAG),
    "yaw_inertia": ("yaw", TURN),
    "buoyancy_gain": ("heave", WEIGHT),
}


def number_entries(tracks: Sequence[Track], rows: Floats) -> list[Entry]:
    """Make entries of the platform's numbers that these tracks may have otherwise, each as a factor, and of a delay.

    rows (tracks, columns): the model; numbers that are 0 in it are left out.
    """
    found = [
        factor_entry(RECALIBRATED[column][0], column, channel, group)
        for column, (channel, group) in _WHERE.items()
        if (rows[:, COLUMN[column]] > 0.0).all() and (column != "buoyancy_gain" or _has_pump(tracks))
    ]
    if (rows[:, COLUMN["drag"]] > 0.0).all():
        found.append(factor_entry(SURGE_DRAG, OWN_SURGE_DRAG, "surge", DRAG))
    if tracks[0].vehicle.is_thruster.any():
        found.append(factor_entry(THRUST, ALL_THRUSTERS, "surge", DRAG))
    found.append(delay_entry())
    return [*found, *thruster_entries(tracks)]


def curve_entries(tracks: Sequence[Track]) -> list[Entry]:
    """Make an entry of the curve of every single thruster whose commands differ from those of the others.

    It is that of all thrusters, of one alone.
    """
    (of_all,) = (entry for entry in ENTRIES if entry.id == "thrust_curve")
    (exponent,) = of_all.amplitudes
    return [
        Entry(
            f"thruster_curve:{name}",
            f"curve of the thrust of {name}",
            of_all.equation,
            "yaw",
            (replace(exponent, column=f"own_exponent.{number}", name=name),),
            group=TURN,
        )
        for number, name in told_alone(tracks)
    ]


def delay_entry() -> Entry:
    """Make the catalogue's entry of commands that act late one of differences, which may be of either sign.

    It is then an error of stamps, which with poses alone is one of the poses' stamps. So its channel is the clock, and
    it is told by the readings alone as theirs is, not by free runs.
    """
    return replace(of_either_sign(next(each for each in ENTRIES if each.id == DELAY)), channel="clock")


def of_either_sign(entry: Entry) -> Entry:
    """Copy the entry of a delay, to be one that may be negative, however short, and is searched on both sides."""
    (late,) = entry.amplitudes
    ends = tuple(-each for each in reversed(late.searched))
    either = replace(late, least=-math.inf, negligible=(0.0, 0.0), searched=(*ends, *late.searched))
    return replace(entry, amplitudes=(either,))


def _has_pump(tracks: Sequence[Track]) -> bool:
    return bool(tracks[0].vehicle.is_pump.any())
