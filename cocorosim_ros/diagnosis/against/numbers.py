"""Differences of a platform's own numbers as entries: gains of thrusters, drags, inertia, gain of pumps, delay."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry
from cocorosim_ros.diagnosis.criteria.against import CHANGES, LEARNING
from cocorosim_ros.diagnosis.fitting.base_model import RECALIBRATED
from cocorosim_ros.diagnosis.tracks.columns import ALL_THRUSTERS, COLUMN, COMMAND_DELAY, MOST_THRUSTERS
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.groups import DRAG, LATE, TURN, WEIGHT
from cocorosim_ros.world.terms.search import DELAYS

ONE_THRUSTER = "thruster_gain"
THRUST, DELAY = "thrust_gain", "command_delay"
# By column: identifier, channel and group. The gain of all thrusters together is a number of its own.
_WHERE = {
    "yaw_torque_gain": ("yaw", TURN),
    "drag": ("surge", DRAG),
    "yaw_drag": ("yaw", DRAG),
    "yaw_inertia": ("yaw", TURN),
    "buoyancy_gain": ("heave", WEIGHT),
}


def number_entries(tracks: Sequence[Track], rows: Floats, thrusters: Sequence[str]) -> list[Entry]:
    """Make entries of the platform's numbers that these tracks may have otherwise, each as a factor, and of a delay.

    rows (tracks, columns): the model; numbers that are 0 in it are left out. thrusters: names, in order.
    """
    found = [
        _factor(RECALIBRATED[column][0], column, channel, group)
        for column, (channel, group) in _WHERE.items()
        if (rows[:, COLUMN[column]] > 0.0).all() and (column != "buoyancy_gain" or _has_pump(tracks))
    ]
    if thrusters:
        found.append(_factor(THRUST, ALL_THRUSTERS, "surge", DRAG))
    found.append(delay_entry())
    return [*found, *thruster_entries(tracks, thrusters)]


def thruster_entries(tracks: Sequence[Track], thrusters: Sequence[str]) -> list[Entry]:
    """Make an entry of the gain of every single thruster whose commands differ from those of the others."""
    return [
        _factor(f"{ONE_THRUSTER}:{name}", f"own_gain.{number}", "yaw", TURN, name)
        for number, name in _told_alone(tracks, thrusters)
    ]


def curve_entries(tracks: Sequence[Track], thrusters: Sequence[str]) -> list[Entry]:
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
        for number, name in _told_alone(tracks, thrusters)
    ]


def _told_alone(tracks: Sequence[Track], thrusters: Sequence[str]) -> list[tuple[int, str]]:
    """Numbers, from 1, and names of the thrusters whose commands differ from those of the others."""
    numbered = zip(range(1, MOST_THRUSTERS + 1), thrusters, _commanded_alone(tracks), strict=False)
    return [(number, name) for number, name, alone in numbered if alone]


def _factor(identifier: str, column: str, channel: str, group: str, name: str = "") -> Entry:
    """Make the entry of a number that is a factor of what it is in other recordings."""
    words = number_words(identifier)
    least, most = CHANGES.bounds
    amplitude = Amplitude(
        column, name or identifier, "1", CHANGES.large_factor, neutral=1.0, factor=True, least=least, most=most
    )
    return Entry(identifier, f"{words} that differs", f"{words} = factor * before", channel, (amplitude,), group=group)


def number_words(identifier: str) -> str:
    """Words for a number that may differ, such as 'thrust of left' and 'yaw drag', by the identifier of its entry."""
    kind, _, thruster = identifier.partition(":")
    return f"thrust of {thruster}" if kind == ONE_THRUSTER else identifier.replace("_", " ")


def delay_entry() -> Entry:
    """Make the entry of commands that act late: an error of stamps, which with poses alone is one of the poses' stamps.

    So its channel is the clock, and it is told by the readings alone as theirs is, not by free runs.
    """
    ends = tuple(-each for each in reversed(DELAYS))
    amplitude = Amplitude(COMMAND_DELAY, "delay", "s", CHANGES.large_delay, searched=(*ends, *DELAYS))
    return Entry(DELAY, "commands that act later than they are logged", "F(t) = F_command(t - delay)", "clock",
                 (amplitude,), group=LATE)  # fmt: skip


def _has_pump(tracks: Sequence[Track]) -> bool:
    return bool(tracks[0].vehicle.is_pump.any())


def _commanded_alone(tracks: Sequence[Track]) -> list[bool]:
    """Tell for each thruster whether its commands have a part that no sum of the other thrusters' commands makes up."""
    thrusters = tracks[0].vehicle.is_thruster
    commands = np.concatenate([track.log.command[:, thrusters] for track in tracks])
    commands = np.where(np.isfinite(commands), commands, 0.0)
    found = []
    for number in range(commands.shape[1]):
        own, others = commands[:, number], np.delete(commands, number, axis=1)
        left = own - others @ np.linalg.lstsq(others, own, rcond=None)[0] if others.shape[1] else 0.0 * own
        size = float(np.sqrt(np.mean(own**2)))
        found.append(bool(size > 0.0 and np.sqrt(np.mean(left**2)) > LEARNING.alone * size))
    return found
