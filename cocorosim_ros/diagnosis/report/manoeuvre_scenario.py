"""The advised manoeuvres as scenarios that `cocorosim run` drives."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.manoeuvres import drives, turns_at_rest
from cocorosim_ros.diagnosis.criteria.report import MANOEUVRE, REPORT
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import full_speed
from cocorosim_ros.diagnosis.report.advice import MANOEUVRES
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.diagnosis.tracks.vehicle_size import slowness
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.steering import Azimuth, Rudder
from cocorosim_ros.scenario.parts.vehicle_parts import BuoyancyPump
from cocorosim_ros.world.controllers.programme import ROWS
from cocorosim_ros.world.controllers.request import DIRECT_LIMIT


class Row(NamedTuple):
    """Commands for `seconds`, if as quick as a Lily: ahead, counter-clockwise turn and rise, each in -1..1."""

    seconds: float
    ahead: float = 0.0
    turn: float = 0.0
    rise: float = 0.0


VARIED = (Row(10, 0.9), Row(6), Row(4, 0.0, 0.4), Row(6), Row(6, 0.5, -0.1), Row(4, 0, 0, -0.3), Row(4, 0, 0, 0.3),
          Row(8, -0.5), Row(6), Row(4, 0.0, -0.4), Row(6))  # fmt: skip
AHEAD_AND_BACK = (Row(15, 0.8), Row(8), Row(15, -0.8), Row(8))
PROGRAMMES: dict[str, tuple[Row, ...]] = {
    "coast_down": (Row(10, 1.0), Row(15), Row(10, 0.6), Row(15), Row(10, 0.3), Row(15), Row(6, 0.0, 0.4), Row(8)),
    "zig_zag": (Row(6, 1.0, 0.3), Row(6, 1.0, -0.3), Row(6, 0.6, 0.3), Row(6, 0.6, -0.3), Row(6, 0.3, 0.2),
                Row(6, 0.3, -0.2), Row(6)),
    "four_headings": (Row(12, 0.7), Row(15), Row(3, 0.0, 0.4), Row(6)),
    "along_wall": AHEAD_AND_BACK,
    "follow_neighbour": AHEAD_AND_BACK,
    "steps": (Row(3, 1.0), Row(2), Row(2, 0.5), Row(4), Row(1.5, 0.5, 0.5), Row(3), Row(1.5, 0.5, -0.5), Row(3)),
    "ramps_through_zero": (Row(20, 0.2, -0.2), Row(20, -0.2, 0.2), Row(10), Row(20, 0.2, 0.2), Row(20, -0.2, -0.2),
                           Row(10)),
    "thrust_staircase": (Row(10, 0.2), Row(10, 0.4), Row(10, 0.6), Row(10, 0.8), Row(10, 1.0), Row(15),
                         Row(6, 0.0, 0.4), Row(8)),
    "reverse_steps": (Row(8, 0.8), Row(8), Row(8, -0.8), Row(8), Row(8, 0.4), Row(8), Row(8, -0.4), Row(8)),
    "crash_stops": (Row(10, 1.0), Row(4, -1.0), Row(8), Row(10, -1.0), Row(4, 1.0), Row(8), Row(10, 1.0), Row(8, -0.4),
                    Row(10, -1.0), Row(8, 0.4), Row(6, 0.0, 0.4), Row(8)),
    "repeat_at_end": VARIED,
    "depth_staircase": (Row(3, 0, 0, -0.3), Row(20)) * 4 + (Row(3, 0, 0, 0.3), Row(20)) * 4,
    "pump_triangle": (Row(10, 0, 0, 0.2), Row(10, 0, 0, -0.2), Row(6, 0, 0, 0.5), Row(6, 0, 0, -0.5), Row(3, 0, 0, 1),
                      Row(3, 0, 0, -1), Row(5)),
    "slow_turns": (Row(60, 0.0, 0.1), Row(10), Row(60, 0.0, -0.1), Row(10)),
    "surface_touch": (Row(20, 0, 0, 0.5), Row(5), Row(10, 0, 0, -0.5), *VARIED),
    "rest": (Row(60), *VARIED),
    "ruler": AHEAD_AND_BACK,
}  # fmt: skip
RAMPED = ("ramps_through_zero", "pump_triangle")


def can_be_driven(platform: Platform) -> bool:
    """Tell whether the controller `programme` can command all actuators of a platform."""
    return len(platform.actuators) <= DIRECT_LIMIT


def scenario_of(name: str, platform: Platform, reference: str) -> str:
    """YAML of a scenario that drives a manoeuvre; `reference` is its platform, by name or by file.

    Raises CocorosimError for a platform with more actuators than can be commanded directly.
    """
    if not can_be_driven(platform):
        raise CocorosimError(
            f"{platform.origin}: 'actuators' has {len(platform.actuators)}, and {DIRECT_LIMIT} are the most that a "
            "programme of commands can drive; drive the manoeuvre with a controller of your own."
        )
    rows, slow = _rows(name, platform), _slowness(platform)
    side = max(MANOEUVRE.least_side, math.ceil(MANOEUVRE.side * slow * full_speed(platform)))
    poses = "\n".join(
        f"        - [{x:g} m, {y:g} m, -{MANOEUVRE.depth / 2:g} m, 0 deg]" for x, y in _places(name, platform, side)
    )
    settings = "\n".join(f"      {key}: {value}" for key, value in _overrides(name, platform, rows).items())
    return f"""# {MANOEUVRES[name][0].upper()}{MANOEUVRES[name][1:]}. Make the tank yours.
name: next_manoeuvre
description: {MANOEUVRES[name].replace(":", ",")}
seed: 1
tick: 0.5 s
duration: {_duration(name, rows):g} s

tank:
  size: [{side:g} m, {side:g} m, {MANOEUVRE.depth:g} m]

integrator:
  name: rk4
  step: 0.05 s
  contact: inelastic

swarm:
  - platform: {reference}
    prefix: robot
    controller: programme
    overrides:
{settings}
    start:
      poses:
{poses}

lockstep:
  silent_controller: thrusters_off
  patience: 10 s

recording:
  topics: all
"""


def _duration(name: str, rows: Sequence[Row]) -> float:
    """Duration [s] of the fewest whole rounds of the programme that last long enough, and repeat what is to be."""
    once = sum(row.seconds for row in rows)
    if name == "repeat_at_end":
        return once * max(2, math.ceil(MANOEUVRE.long / once))
    return once * math.ceil(MANOEUVRE.least_duration / once)


def _places(name: str, platform: Platform, side: float) -> list[tuple[float, float]]:
    """Starting places of the robots [m; world]: one in the middle, and those that the manoeuvre needs beside it."""
    length = platform.hull.length
    if name == "along_wall":
        return [(0.0, 0.0), (0.0, 0.5 * side - length)]
    if name == "follow_neighbour":
        return [(0.0, 0.0), (-2.0 * length, 0.0), (0.0, 0.25 * side)]
    return [(0.0, 0.0)]


def _overrides(name: str, platform: Platform, rows: Sequence[Row]) -> dict[str, str]:
    """The settings of the controller `programme`."""
    found = {"ramps": "true" if name in RAMPED else "false"}
    for number, shares in enumerate(_shares(platform), 1):
        for motion, share in zip(("ahead", "turn", "rise"), shares, strict=True):
            found[f"actuator_{number}_{motion}"] = f"{share:g}"
    for number, row in enumerate(rows, 1):
        found[f"row_{number}_time"] = f"{row.seconds:g} s"
        found |= {f"row_{number}_{motion}": f"{getattr(row, motion):g}" for motion in ("ahead", "turn", "rise")}
    return found


def _rows(name: str, platform: Platform) -> list[Row]:
    """Rows of a programme as a vehicle can drive them: one that turns under way alone turns while it drives ahead.

    A ship that coasts for a minute is not at full speed after ten seconds: what is driven lasts longer, and so do the
    pauses between, in whole seconds. A vehicle that is to change its depth does not sink farther.
    """
    rows, slow = list(PROGRAMMES[name][:ROWS]), _slowness(platform)
    if slow > 1.0 and any(row.ahead or row.turn for row in rows):
        rows = [row if row.rise else row._replace(seconds=math.ceil(slow * row.seconds)) for row in rows]
    if turns_at_rest(platform) or not drives(platform):
        return rows
    return [row._replace(ahead=MANOEUVRE.under_way) if row.turn and not row.ahead else row for row in rows]


def _slowness(platform: Platform) -> float:
    """Times of a vehicle relative to those of a Lily [1]; 1 for one that drives up and down alone."""
    return slowness(vehicle_model(platform)) if drives(platform) else 1.0


def _shares_of_fin(fin: Fin) -> tuple[float, float, float]:
    """Commands as those of `_shares`: by the side to which its lift turns the robot, and by whether that lifts it."""
    turning, rising = fin.position[0] * fin.direction[1] - fin.position[1] * fin.direction[0], fin.direction[2]
    turn = math.copysign(1.0, turning) if abs(fin.direction[1]) > REPORT.along_axis else 0.0
    return 0.0, turn, math.copysign(1.0, rising) if abs(rising) > REPORT.along_axis else 0.0


def _shares(platform: Platform) -> list[tuple[float, float, float]]:
    """Commands -1, 0 or 1, by actuator, that make the robot go ahead, turn counter-clockwise, and rise.

    A vehicle all of whose thrusters push upwards or downwards steps, ramps and climbs with these: it has no others.
    """
    shares = []
    ahead_is_up = not drives(platform)
    for actuator, wrench in zip(platform.actuators, platform.actuator_wrenches(), strict=True):
        if isinstance(actuator, BuoyancyPump):
            shares.append((0.0, 0.0, 1.0))
            continue
        if isinstance(actuator, (Rudder, Azimuth)):  # an azimuth stays where its thruster points
            shares.append((0.0, 1.0 if isinstance(actuator, Rudder) else 0.0, 0.0))
            continue
        if isinstance(actuator, Fin):
            shares.append(_shares_of_fin(actuator))
            continue
        ahead, rise = (math.copysign(1.0, part) if abs(part) > REPORT.along_axis else 0.0 for part in wrench[[0, 2]])
        turn = math.copysign(1.0, wrench[3]) if abs(wrench[3]) > MANOEUVRE.least_arm * platform.hull.length else 0.0
        shares.append((1.0 if ahead_is_up else float(ahead), turn, float(rise)))
    return shares
