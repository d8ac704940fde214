"""What acts in a run, in a paragraph: effects, water, errors of sensors, media; and what is named but does nothing.

A number that is zero by mistake is easily overlooked in a file of a hundred lines, and nothing else shows it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from cocorosim_ros.scenario.parts.corruption import LINK_CHANNELS, Corruption
from cocorosim_ros.scenario.parts.force_currents import ForceCurrents
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.scenario.scenario import RobotDescription, Scenario
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.laws.laws_of_platform import effects_of
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.effect import Number
from cocorosim_ros.world.terms.search import Strength
from cocorosim_ros.world.vehicle_model.platform_effects import RECORDING_EFFECTS
from cocorosim_ros.world.water.current_numbers import scenario_currents
from cocorosim_ros.world.water.currents import CURRENTS

_EVERYWHERE = ("quadratic_drag", "net_buoyancy")
_NOTHING_AT = {"noise": "sd", "bias": "offset", "dropout": "probability", "loss": "probability"}  # if it is zero


@dataclass
class _Acting:
    """Names of what acts, and of what is named and does nothing, the latter with the reason."""

    on: list[str] = field(default_factory=list)
    off: list[str] = field(default_factory=list)

    def add(self, name: str, reason: str) -> None:
        """Take what acts, or, for the reason that there is, does not."""
        into, words = (self.off, f"{name} ({reason})") if reason else (self.on, name)
        if words not in into:
            into.append(words)


def active_physics(scenario: Scenario) -> str:
    """What acts in a run of the scenario, and what it names without effect, as one paragraph."""
    parts = {
        "Effects": _effects(scenario.robots),
        "water": _water(scenario),
        "sensor errors": _errors(scenario),
        "media": _media(scenario),
    }
    told = [f"{title}: {', '.join(part.on) or 'none'}" for title, part in parts.items()]
    inactive = [words for part in parts.values() for words in part.off]
    off = f" Named, but without effect: {', '.join(inactive)}." if inactive else ""
    return f"{'; '.join(told)}.{off}"


def _effects(robots: Iterable[RobotDescription]) -> _Acting:
    every = list(robots)
    acting = _Acting(list(_EVERYWHERE))
    for name in EFFECTS:
        having = [robot for robot in every if name in effects_of(robot.platform)]
        _add_by_reason(acting, name, {robot.name: _idle(name, robot, len(every)) for robot in having}, every)
    return acting


def _add_by_reason(acting: _Acting, name: str, reasons: dict[str, str], every: list[RobotDescription]) -> None:
    """Take an effect once for all robots that have the same reason; reasons: by robot, empty where it acts."""
    for reason in dict.fromkeys(reasons.values()):
        same = [robot for robot, own in reasons.items() if own == reason]
        acting.add(f"{name}{_whose(same, every)}", reason)


def _idle(name: str, robot: RobotDescription, robots: int) -> str:
    """Why an effect of a robot does nothing; empty if it does something."""
    if EFFECTS[name].neighbours and robots == 1:
        return "the robot is alone"
    return _zero(EFFECTS[name].parameters, effects_of(robot.platform)[name])


def _zero(parameters: tuple[Parameter, ...], given: dict[str, float]) -> str:
    """Which numbers of an effect are zero, or neutral, so that it does nothing; empty if it does something."""
    strengths = [part for part in parameters if isinstance(part, Number) and isinstance(part.search, Strength)]
    if not strengths or any(part.neutral for part in strengths):
        strengths = list(parameters)  # type: ignore[arg-type]  # it is nothing only if all its numbers are
    if any(given.get(part.name, part.neutral) != part.neutral for part in strengths):
        return ""
    named = [part for part in strengths if part.name in given] or strengths
    return ", ".join(f"{part.name} {part.neutral:g}" for part in named)


def _water(scenario: Scenario) -> _Acting:
    acting = _Acting()
    for current in scenario_currents(scenario):
        fastest = CURRENTS[current.name].fastest(current.numbers, scenario.tank.size)
        acting.add(f"{current.name} current", "" if fastest > 0.0 else "its speed is 0")
    water = scenario.water
    if water is not None and water.force_currents is not None:
        for name, reason in _forces(water.force_currents):
            acting.add(name, reason)
    if water is not None and water.plume is not None:
        acting.add("plume", "")
    if not acting.on:
        acting.on.append("still")
    return acting


def _forces(forces: ForceCurrents) -> Iterator[tuple[str, str]]:
    """What makes forces on patches of water, each with the reason why it does not."""
    spots, wakes = forces.cold_spots, forces.wakes
    if spots is not None:
        reasons = {"force 0": spots.force, "probability 0": spots.probability}
        yield "cold spots", next((words for words, value in reasons.items() if value == 0.0), "")
    if wakes is not None:
        yield "wakes of thrusters", "" if wakes.strength > 0.0 else "strength 0"
    if spots is None and wakes is None:
        yield "force currents", "neither cold spots nor wakes"


def _errors(scenario: Scenario) -> _Acting:
    every = list(scenario.robots)
    acting = _Acting()
    for corruption in scenario.corruption:
        if corruption.channel not in LINK_CHANNELS:
            acting.add(f"{corruption.channel} {corruption.kind}", _perfect(corruption))
    for name, error in ERRORS.items():
        only_recorded = {part.name for part in RECORDING_EFFECTS.get(name, ())}
        simulated = tuple(part for part in error.parameters if part.name not in only_recorded)
        having = [robot for robot in every if simulated and name in effects_of(robot.platform)]
        reasons = {robot.name: _zero(simulated, effects_of(robot.platform)[name]) for robot in having}
        _add_by_reason(acting, name, reasons, every)
    return acting


def _perfect(corruption: Corruption) -> str:
    """Why a corruption changes nothing; empty if it does."""
    numbers = corruption.numbers
    if corruption.kind == "range_factor":
        return "a factor of 1" if numbers["least"] == numbers["most"] == 1.0 else ""
    number = _NOTHING_AT.get(corruption.kind)
    return f"{number} 0" if number is not None and numbers[number] == 0.0 else ""


def _media(scenario: Scenario) -> _Acting:
    acting = _Acting()
    has = {
        "blue light": any(robot.platform.sensors.blss for robot in scenario.robots),
        "radio": any(robot.radio_range > 0.0 for robot in scenario.robots),
        "sound": scenario.acoustic is not None,
        "background light": scenario.light.background > 0.0,
    }
    acting.on += [name for name, there in has.items() if there]
    if scenario.radio.range == 0.0:
        acting.add("radio", "range 0")
    for lamp in scenario.light.lamps:
        acting.add(f"lamp {lamp.name}", "" if lamp.illuminance > 0.0 else "illuminance 0")
    for corruption in scenario.corruption:
        if corruption.channel in LINK_CHANNELS:
            acting.add(f"{corruption.channel.replace('_', ' ')} {corruption.kind}", _perfect(corruption))
    return acting


def _whose(names: list[str], every: list[RobotDescription]) -> str:
    """Words for some of all robots; none for all of them."""
    if len(names) == len(every):
        return ""
    return f" of {names[0]}" if len(names) == 1 else f" of {names[0]} and {len(names) - 1} more"
