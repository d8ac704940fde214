"""The water of a scenario: still unless it says otherwise."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from cocorosim_ros.scenario.parts.currents import VELOCITY_CURRENTS, VelocityCurrent
from cocorosim_ros.scenario.parts.force_currents import FORCE_CURRENTS, ForceCurrents
from cocorosim_ros.scenario.parts.plume import Plume
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import nanoseconds_text
from cocorosim_ros.scenario.reading.records import list_of, nested

if TYPE_CHECKING:
    from cocorosim_ros.scenario.scenario import Scenario

_WHOLE = 1e-9
_MICROMETRES = 1e6  # in a metre
MOST_PATCHES = 50_000_000


@dataclass(frozen=True)
class Water:
    """Currents as velocities of the water, currents as forces on patches (the paper's), and what leaks into it."""

    currents: tuple[VelocityCurrent, ...] = field(default=(), metadata=list_of(VELOCITY_CURRENTS))
    force_currents: ForceCurrents | None = field(default=None, metadata=FORCE_CURRENTS)
    plume: Plume | None = field(default=None, metadata=nested(Plume))


def patch_counts(size: tuple[float, float, float], patch: float) -> tuple[int, int, int]:
    """How many patches [m] the tank [m] has along x, y and depth, to the nearest whole number."""
    x, y, z = (round(side / patch) for side in size)
    return x, y, z


def patch_that_divides(size: tuple[float, float, float], patch: float) -> float:
    """The length [m], near `patch`, that divides every side of a tank [m] of whole micrometres."""
    common = max(1, math.gcd(*(round(side * _MICROMETRES) for side in size)))
    wanted = min(common, max(1, round(common / (patch * _MICROMETRES))))
    near = (parts for off in range(common) for parts in (wanted - off, wanted + off))
    parts = next(parts for parts in near if parts >= 1 and common % parts == 0)
    return common / parts / _MICROMETRES


def check_water(scenario: Scenario, entry: Entry) -> None:
    """Nothing, if the water fits tank and tick; CocorosimError names what does not."""
    if scenario.water is not None and scenario.water.plume is not None:
        _check_plume(scenario, scenario.water.plume, entry.mapping()["plume"].mapping())
    forces = None if scenario.water is None else scenario.water.force_currents
    if forces is None:
        return
    section = entry.mapping()["force_currents"]
    if forces.step_ns % scenario.tick_ns:
        raise (
            section.mapping()
            .get("step", section)
            .problem(
                f"has a step of '{nanoseconds_text(forces.step_ns)}', which is not a whole number of ticks of "
                f"'{nanoseconds_text(scenario.tick_ns)}'; choose a multiple of the tick."
            )
        )
    place = section.mapping().get("patch", section)
    counts = patch_counts(scenario.tank.size, forces.patch)
    for axis, side, count in zip(("x", "y", "depth"), scenario.tank.size, counts, strict=True):
        if count < 1 or abs(side / forces.patch - count) > _WHOLE * side / forces.patch:
            fitting = patch_that_divides(scenario.tank.size, forces.patch)
            raise place.problem(
                f"has patches of {forces.patch:g} m, which do not divide the tank's {axis} of {side:g} m; choose a "
                f"patch that divides all sides, e.g. {fitting:.10g} m."
            )
    patches = counts[0] * counts[1] * counts[2]
    if patches > MOST_PATCHES:
        raise place.problem(
            f"has patches of {forces.patch:g} m, {patches:,} of them, more than {MOST_PATCHES:,}; choose larger ones."
        )


def _check_plume(scenario: Scenario, plume: Plume, section: Mapping[str, Entry]) -> None:
    if not scenario.tank.contains(plume.source):
        raise section["source"].problem(
            f"has {section['source'].found()}, which is not in the tank; put it into the water."
        )
    if plume.interval_ns % scenario.tick_ns:
        raise section.get("interval", section["source"]).problem(
            f"lets out a puff every '{nanoseconds_text(plume.interval_ns)}', which is not a whole number of ticks of "
            f"'{nanoseconds_text(scenario.tick_ns)}'; choose an 'interval' that is."
        )
