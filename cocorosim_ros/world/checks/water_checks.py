"""Whether the water of a scenario fits its tank and its tick."""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.scenario.parts.ocean_current import OceanCurrent
from cocorosim_ros.scenario.parts.plume import Plume
from cocorosim_ros.scenario.parts.stated_file import naming_entry
from cocorosim_ros.scenario.parts.water import patch_counts, patch_that_divides
from cocorosim_ros.scenario.parts.waves import Waves
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import nanoseconds_text
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.water.ocean.model_file import OceanFileError
from cocorosim_ros.world.water.ocean.ocean_field import ocean_field
from cocorosim_ros.world.water.sea_state import breaks

_WHOLE = 1e-9
MOST_PATCHES = 50_000_000


def check_water(scenario: Scenario, entry: Entry) -> None:
    """Nothing, if the water fits tank and tick; CocorosimError names what does not."""
    _check_oceans(scenario, entry)
    _check_waves(scenario, entry)
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


def _check_waves(scenario: Scenario, entry: Entry) -> None:
    for place, current in enumerate(() if scenario.water is None else scenario.water.currents):
        if not isinstance(current, Waves):
            continue
        depth = scenario.tank.depth if current.depth is None else current.depth
        if (highest := breaks(current, depth)) is not None:
            section = entry.mapping()["currents"].items()[place].mapping()
            raise section["height"].problem(
                f"has {section['height'].found()}, but waves of {current.period:g} s in {depth:g} m of water break "
                f"from {highest:.3g} m on; choose lower or longer waves."
            )


def _check_oceans(scenario: Scenario, entry: Entry) -> None:
    for place, current in enumerate(() if scenario.water is None else scenario.water.currents):
        if isinstance(current, OceanCurrent):
            _check_ocean(scenario, current, entry.mapping()["currents"].items()[place].mapping()["file"])


def _check_ocean(scenario: Scenario, current: OceanCurrent, entry: Entry) -> None:
    try:
        ocean_field(current, scenario.tank.size, scenario.duration)
    except OceanFileError as error:
        named = naming_entry(entry)
        raise named.problem(f"has '{named.value}', {error}") from error


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
