"""Numbers that a platform's file could give and does not, for want of which an effect is not looked for.

Such an effect would stay unmentioned, and its absence from a page would be read as "it was looked for". An effect that
the vehicle cannot have whatever its file gives, as wind of one that dives, is none of them.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.manoeuvres import dives
from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import NotLookedFor
from cocorosim_ros.diagnosis.fitting.vehicle_needs import has_all, moves_in_air
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster

_IN_A_JET = "thruster_in_a_jet"


def not_looked_for(platform: Platform) -> tuple[NotLookedFor, ...]:
    """List the effects of the catalogue that a vehicle may have, and that the numbers of its file leave out."""
    found: dict[str, NotLookedFor] = {}
    for entry in ENTRIES:
        numbers = tuple(
            number for need in entry.needs if need in KEYS_OF_NEED for number in KEYS_OF_NEED[need](platform)
        )
        if numbers and entry.id not in platform.effect_quantities:
            found[entry.id] = NotLookedFor(entry.id, entry.name, numbers)
    return tuple(found.values())


def _of_cable(platform: Platform) -> tuple[str, ...]:
    """Diameter of the cable of what thrusters drive through water; what drifts or glides tows none."""
    tows = bool(_thrusters(platform)) and not moves_in_air(platform)
    return ("hull.cable_diameter",) if tows and platform.hull.cable_diameter is None else ()


def _above_water(platform: Platform) -> tuple[str, ...]:
    """Areas in the wind, where neither is given, of what floats; one that is given as nothing is nothing."""
    given = platform.hull.front_above_water, platform.hull.side_above_water
    if given != (None, None) or moves_in_air(platform) or not platform.actuators or _can_dive(platform):
        return ()
    return "hull.front_above_water", "hull.side_above_water"


def _can_dive(platform: Platform) -> bool:
    return dives(platform) or any(
        isinstance(each, Fin) and abs(each.direction[2]) > REPORT.along_axis for each in platform.actuators
    )


def _diameters(platform: Platform) -> tuple[str, ...]:
    """Diameters of propellers without which no thruster is known to stand in the jet of another.

    None where that would be so even with the largest propellers for which there is room between two thrusters.
    """
    thrusters = _thrusters(platform)
    lacking = tuple(each.name for each in thrusters if each.diameter is None)
    apart = [math.dist(one.position, other.position) for one, other in itertools.combinations(thrusters, 2)]
    room = min(filter(None, apart), default=None)
    if not lacking or room is None or has_all(vehicle_model(platform), (_IN_A_JET,)):
        return ()
    largest = tuple(
        replace(each, diameter=room) if isinstance(each, Thruster) and each.diameter is None else each
        for each in platform.actuators
    )
    able = has_all(vehicle_model(replace(platform, actuators=largest)), (_IN_A_JET,))
    return tuple(f"actuators.{name}.diameter" for name in lacking) if able else ()


def _thrusters(platform: Platform) -> list[Thruster]:
    return [each for each in platform.actuators if isinstance(each, Thruster)]


KEYS_OF_NEED: Mapping[str, Callable[[Platform], tuple[str, ...]]] = {
    "cable": _of_cable,
    "above_water": _above_water,
    _IN_A_JET: _diameters,
}
"""Keys of numbers that a platform's file lacks, by the need of effects (`vehicle_needs.HAS`) that they would meet."""
