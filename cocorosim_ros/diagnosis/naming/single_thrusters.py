"""Gains of single thrusters as entries: what one pushes, as a factor of what a model has of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry
from cocorosim_ros.diagnosis.criteria.naming import FACTORS
from cocorosim_ros.diagnosis.tracks.columns import MOST_THRUSTERS, OWN_GAINS
from cocorosim_ros.diagnosis.tracks.own_numbers import gain_key
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.curve import AZIMUTH, FORM, NUMBER
from cocorosim_ros.world.terms.groups import TURN

ONE_THRUSTER = "thruster_gain"
SIDES = 2
"""Thrusters of which a weak one is an asymmetry, which the catalogue has."""


def looked_for_alone(tracks: Sequence[Track]) -> list[Entry]:
    """Make the entries beside the catalogue's: gains of single thrusters, where there are more than two.

    A thruster that is much stronger than all the others is none: such a gain stands in for something else. Of one that
    an azimuth turns, the angle by which it is off, or late, looks like a gain.
    """
    vehicle = tracks[0].vehicle
    if np.count_nonzero(vehicle.is_thruster) <= SIDES:
        return []
    entries = [_gain_entry(*each) for each in told_alone(tracks) if not _is_turned(vehicle, each[0])]
    return [
        replace(
            entry,
            name=f"{number_words(entry.id)} unlike that of the others",
            equation="T = factor * T_model",
            amplitudes=tuple(replace(each, most=FACTORS.most_alone) for each in entry.amplitudes),
        )
        for entry in entries
    ]


def turned_remarks(vehicle: VehicleModel) -> tuple[str, ...]:
    """Remark on thrusters that azimuths turn, whose gains are not looked for one by one."""
    names = thruster_names(vehicle)
    turned = [name for number, name in enumerate(names, 1) if _is_turned(vehicle, number)]
    if not turned:
        return ()
    return (
        f"Whether one of {', '.join(turned)} is weak is not looked for: azimuths turn them, and an angle that is off, "
        "or late, looks the same. Weigh their thrust.",
    )


def _is_turned(vehicle: VehicleModel, number: int) -> bool:
    """Tell whether an azimuth turns a thruster, by its number from 1 on."""
    curve = vehicle.actuator_curve
    place = int(np.flatnonzero(vehicle.is_thruster)[number - 1])
    return bool(curve.shape[1] and ((curve[:, FORM] == AZIMUTH) & (curve[:, NUMBER] == place)).any())


def thruster_entries(tracks: Sequence[Track]) -> list[Entry]:
    """Make an entry of the gain of every single thruster whose push differs from that of the others."""
    return [_gain_entry(*each) for each in told_alone(tracks)]


def _gain_entry(number: int, name: str) -> Entry:
    return factor_entry(f"{ONE_THRUSTER}:{name}", f"own_gain.{number}", "yaw", TURN, name)


def told_alone(tracks: Sequence[Track]) -> list[tuple[int, str]]:
    """Numbers, from 1, and names of the thrusters whose push differs from that of the others."""
    names = thruster_names(tracks[0].vehicle)
    numbered = zip(range(1, MOST_THRUSTERS + 1), names, _pushes_alone(tracks), strict=False)
    return [(number, name) for number, name, alone in numbered if alone]


def thruster_names(vehicle: VehicleModel) -> tuple[str, ...]:
    """Names of the thrusters that have a gain of their own, in the order of their numbers."""
    begin, end = gain_key("*").split("*")
    return tuple(
        key.removeprefix(begin).removesuffix(end) for key, each in vehicle.own.items() if each.column in OWN_GAINS
    )


def thruster_of(identifier: str) -> str:
    """Name of the thruster that an entry is of; '' for every other entry."""
    kind, _, name = identifier.partition(":")
    return name if kind == ONE_THRUSTER else ""


def factor_entry(identifier: str, column: str, channel: str, group: str, name: str = "") -> Entry:
    """Make the entry of a number that is a factor of what a model has.

    name: of its amplitude, the identifier if it is empty.
    """
    words = number_words(identifier)
    least, most = FACTORS.bounds
    amplitude = Amplitude(
        column, name or identifier, "1", FACTORS.large, neutral=1.0, factor=True, least=least, most=most
    )
    return Entry(identifier, words, f"{words} = factor * before", channel, (amplitude,), group=group)


def number_words(identifier: str) -> str:
    """Words for a number that may differ, such as 'thrust of left' and 'yaw drag', by the identifier of its entry."""
    thruster = thruster_of(identifier)
    return f"thrust of {thruster}" if thruster else identifier.replace("_", " ")


def alike_of(tracks: Sequence[Track]) -> dict[str, tuple[str, ...]]:
    """Map names of thrusters to the names of those that push the vehicle as they do, at all times.

    Of two vertical thrusters that are always commanded alike, either may be the weak one: their sum is all that shows.
    """
    names = thruster_names(tracks[0].vehicle)
    pushes = _pushes(tracks)
    return {
        name: tuple(names[other] for other in _alike(pushes, number) if other != number and other < len(names))
        for number, name in enumerate(names)
    }


def _pushes_alone(tracks: Sequence[Track]) -> list[bool]:
    """Tell for each thruster whether it pushes and turns the vehicle as no sum of the other thrusters does.

    Commands of four level thrusters that give three wishes are sums of each other; but each pushes another way. Of
    thrusters that push alike the first is told from all that do not.
    """
    pushes = _pushes(tracks)
    found = []
    for number in range(pushes.shape[1]):
        alike = _alike(pushes, number)
        others = np.delete(pushes, alike, axis=1)
        found.append(number == alike[0] and others.shape[1] > 0 and _is_no_sum(pushes[:, number], others))
    return found


def _pushes(tracks: Sequence[Track]) -> Floats:
    """Pushes (4 n, thrusters) at n commands, of one axis after the other, each by a share of its full push."""
    vehicle = tracks[0].vehicle
    thrusters = vehicle.is_thruster
    commands = np.concatenate([track.log.command[:, thrusters] for track in tracks])
    commands = np.where(np.isfinite(commands), commands, 0.0)
    per_command = vehicle.actuator_wrench[thrusters] / [1.0, 1.0, 1.0, vehicle.hull]
    return np.concatenate([commands * along for along in per_command.T])


def _alike(pushes: Floats, number: int) -> list[int]:
    """Numbers of the thrusters that push as one does, its own among them."""
    own = pushes[:, number]
    others = (each for each in range(pushes.shape[1]) if each != number)
    return sorted([number, *(each for each in others if own.any() and not _is_no_sum(own, pushes[:, [each]]))])


def _is_no_sum(own: Floats, others: Floats) -> bool:
    """Tell whether no sum of others (n, m) makes nearly all of a push (n,); one that never pushes is a sum."""
    left = own - others @ np.linalg.lstsq(others, own, rcond=None)[0]
    size = float(np.sqrt(np.mean(own**2)))
    return bool(size > 0.0 and np.sqrt(np.mean(left**2)) > FACTORS.alone * size)
