"""From the places of a platform's thrusters to the pairs of which one may stand in the jet of the other."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.steering import Azimuth
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.world.terms.jet import JET_COLUMNS


def without_jets(platforms: Iterable[Platform]) -> list[str]:
    """One sentence for each platform whose `effects.wash_loss` does nothing: no thruster has a diameter."""
    silent = {each.origin for each in platforms if "wash_loss" in each.effect_quantities and not _blowing(each)}
    return [
        f"{origin}: 'effects.wash_loss' is thrust lost in jets, and no thruster has the 'diameter' of its propeller, "
        "by which a jet has a width: it does nothing."
        for origin in sorted(silent)
    ]


def build_jets(platforms: Sequence[Platform]) -> Floats:
    """(robots, pairs, JET_COLUMNS) see terms.jet, one robot per platform; rows of zeros where one has fewer pairs."""
    found = [_pairs(platform) for platform in platforms]
    jets = np.zeros((len(platforms), max(map(len, found)), JET_COLUMNS))
    for robot, pairs in enumerate(found):
        jets[robot, : len(pairs)] = np.reshape(pairs, (-1, JET_COLUMNS))
    return jets


def _pairs(platform: Platform) -> list[list[float]]:
    """Rows of all pairs of thrusters in which that with the jet has a diameter, wherever it blows."""
    names = platform.actuator_names
    azimuths = {each.thruster: names.index(each.name) for each in platform.actuators if isinstance(each, Azimuth)}
    thrusters = [each for each in platform.actuators if isinstance(each, Thruster)]
    return [
        [
            names.index(on.name), azimuths.get(on.name, -1), names.index(by.name), azimuths.get(by.name, -1),
            *np.subtract(on.position, by.position).tolist(), by.diameter or 0.0,
        ]
        for by in _blowing(platform)
        for on in thrusters if on is not by
    ]  # fmt: skip


def _blowing(platform: Platform) -> list[Thruster]:
    """Thrusters whose jets have a width."""
    return [each for each in platform.actuators if isinstance(each, Thruster) and each.diameter is not None]
