"""A kind of robot, as a platform file describes it: everything about the body, nothing about the run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.card import Card, Shown, digits
from cocorosim_ros.scenario.parts.actuator_checks import check_actuators
from cocorosim_ros.scenario.parts.effect_quantities import Effects, effects_tree, read_effects
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.kept_numbers import check_kept, read_kept
from cocorosim_ros.scenario.parts.mixing import Mixing, check_mixing
from cocorosim_ros.scenario.parts.operating_system import OperatingSystem
from cocorosim_ros.scenario.parts.six_degrees import SixDegrees, check_six_degrees
from cocorosim_ros.scenario.parts.sliding_mass import SlidingMass
from cocorosim_ros.scenario.parts.steering import Azimuth, Rudder
from cocorosim_ros.scenario.parts.stick_mixing import StickMixing
from cocorosim_ros.scenario.parts.vehicle_parts import ACTUATORS, Actuator, BuoyancyPump, Hull, Sensors, Thruster
from cocorosim_ros.scenario.reading.arguments import place_text
from cocorosim_ros.scenario.reading.based_on import with_base
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.scenario.reading.entry import Entry, quoted
from cocorosim_ros.scenario.reading.law_text import LawText
from cocorosim_ros.scenario.reading.other_files import refuse_maps
from cocorosim_ros.scenario.reading.quantity import Quantity
from cocorosim_ros.scenario.reading.ranges import INTERVAL, Ranges, collect_ranges, ranges_tree, read_ranges
from cocorosim_ros.scenario.reading.records import (
    TEXT,
    choice,
    list_of,
    nested,
    quantity,
    read_record,
    record_tree,
    stored,
)
from cocorosim_ros.scenario.reading.sources import require_sources
from cocorosim_ros.scenario.reading.yaml_file import load_yaml

DragForm = Literal["total_speed", "own_speed", "strips"]
DRAG_FORMS = ("total_speed", "own_speed", "strips")


def _read_words(entry: Entry) -> dict[str, str]:
    return {name: part.text() for name, part in entry.mapping().items()}


@dataclass(frozen=True, repr=False)
class Platform(Shown):
    """One kind of robot; SI units, body axes forward-left-up, moves in surge, sway, heave and yaw, or in six degrees.

    mass [kg], yaw_inertia [kg m^2], drag: rho*A*Cd/2 for the total speed [kg/m], yaw_drag [N m s^2],
    water_density [kg/m^3], gravity [m/s^2]. `thrust_gain`, `yaw_torque_gain`, `buoyancy_gain`: what the thrusters push
    together, what they turn, and what the pumps lift, as multiples of what the actuators are said to do. `drag_form`:
    whether quadratic drag goes by the total speed or by each axis' own, also over strips of the hull; None where the
    file does not say, and then a simulation takes the total speed. `six_degrees`: what motion with roll and pitch takes
    instead of drag and yaw inertia; a diagnosis takes the platform as `in_four_degrees` makes it. `mixing`: how sticks
    become commands of actuators, where commands may be sticks. `fitted_step`: step [s] of the filter by which the
    numbers were found, where a diagnosis has found them. `kept_as_given`: keys of the numbers that a diagnosis does not
    fit. `ranges`: between what the numbers lie that are
    not known exactly, by dotted key (mass, actuators.left.maximum); `intervals`: the 95 % intervals of those that were
    measured. `frame_corrections`: how axes, signs or units
    of a recorded stream are mixed up, by topic, in the words of a diagnosis. `robots`: those of this kind that
    differ, by name. `origin` is the file it came from, `told` what a diagnosis has to say of it, in sentences.
    """

    name: str = field(metadata=TEXT)
    description: str = field(metadata=TEXT)
    hull: Hull = field(metadata=nested(Hull))
    mass: float = field(metadata=quantity("mass", "positive"))
    yaw_inertia: float = field(metadata=quantity("moment of inertia", "positive"))
    drag: float = field(metadata=quantity("quadratic drag", "not negative"))
    yaw_drag: float = field(metadata=quantity("quadratic yaw drag", "not negative"))
    water_density: float = field(metadata=quantity("density", "positive"))
    gravity: float = field(metadata=quantity("acceleration", "not negative"))
    actuators: tuple[Actuator, ...] = field(metadata=list_of(ACTUATORS))
    sensors: Sensors = field(metadata=nested(Sensors))
    operating_system: OperatingSystem | None = field(default=None, metadata=nested(OperatingSystem))
    effect_quantities: Effects = field(
        default_factory=dict,
        hash=False,
        metadata=stored(read_effects, effects_tree, key="effects", form="mapping of effects to their numbers"),
    )
    thrust_gain: float | None = field(default=None, metadata=quantity("pure number", "positive"))
    yaw_torque_gain: float | None = field(default=None, metadata=quantity("pure number", "positive"))
    buoyancy_gain: float | None = field(default=None, metadata=quantity("pure number", "positive"))
    drag_form: DragForm | None = field(default=None, metadata=choice(*DRAG_FORMS))
    six_degrees: SixDegrees | None = field(default=None, metadata=nested(SixDegrees))
    mixing: Mixing | None = field(default=None, metadata=nested(Mixing))
    fitted_step: float | None = field(default=None, metadata=quantity("time", "positive"))
    kept_as_given: tuple[str, ...] | None = field(
        default=None, metadata=stored(read_kept, list, form="list of the keys of numbers that a diagnosis does not fit")
    )
    ranges: Ranges = field(
        default_factory=dict,
        hash=False,
        metadata=stored(read_ranges, ranges_tree, form="mapping of keys to the lowest and the highest value"),
    )
    intervals: Ranges = field(
        default_factory=dict,
        hash=False,
        metadata=stored(read_ranges, ranges_tree, form="mapping of keys to the ends of their 95 % intervals"),
    )
    frame_corrections: Mapping[str, str] = field(
        default_factory=dict,
        hash=False,
        metadata=stored(_read_words, dict, form="mapping of topics to what is mixed up"),
    )
    robots: Mapping[str, Platform] = field(default_factory=dict, hash=False)
    origin: str = field(default="", compare=False)
    told: tuple[str, ...] = field(default=(), compare=False)

    @property
    def effects(self) -> dict[str, dict[str, float]]:
        """The effects beyond the basic physics, in SI units: {effect id: {parameter: value}}; laws in words left out.

        These are in `laws`; world.laws gives both together.
        """
        return {
            effect: {name: part.value for name, part in parameters.items() if isinstance(part, Quantity)}
            for effect, parameters in self.effect_quantities.items()
        }

    @property
    def laws(self) -> dict[str, dict[str, LawText]]:
        """Laws in words: {effect id: {what the law is of: law}}."""
        found = {
            effect: {name: part for name, part in parameters.items() if isinstance(part, LawText)}
            for effect, parameters in self.effect_quantities.items()
        }
        return {effect: laws for effect, laws in found.items() if laws}

    def of_robot(self, name: str) -> Platform:
        """What this platform says of the robot of that name: its own numbers where it has some."""
        return self.robots.get(name, self)

    @property
    def actuator_names(self) -> tuple[str, ...]:
        """The names of the actuators in the order of all arrays about them."""
        return tuple(actuator.name for actuator in self.actuators)

    def stick_mixing(self) -> StickMixing | None:
        """What makes commands of sticks into those of actuators; None where there are no sticks."""
        return None if self.mixing is None else StickMixing(self.mixing, self.actuators)

    def actuator_wrenches(self) -> Floats:
        """(n_actuators, 4) body force x, y, z [N/N] and moment about z [N m/N] per newton of each.

        An azimuth has the wrench of its thruster turned by 90 deg to the left, a rudder none of its own.
        """
        return np.array([self._wrench(actuator) for actuator in self.actuators], dtype=np.float64).reshape(-1, 4)

    def actuator_limits(self) -> Floats:
        """(n_actuators, 2) force [N] at commands +1 and -1, unsigned; for a pump rho * g * volume range.

        Of rudders, fins and azimuths it is the angle [rad], of a sliding mass its travel [m].
        """
        return np.array([self._limits(actuator) for actuator in self.actuators], dtype=np.float64).reshape(-1, 2)

    def full_forces(self) -> Floats:
        """(n_actuators, 2) greatest force [N] forwards and backwards of each, as its wrench counts it; rudders: 0."""
        return np.array([self._full_force(actuator) for actuator in self.actuators], dtype=np.float64).reshape(-1, 2)

    def card(self) -> Card:
        """Mass, inertia and drag, and the effects beyond the basic physics."""
        facts = {
            "mass": f"{digits(self.mass)} kg",
            "yaw inertia": f"{digits(self.yaw_inertia)} kg m^2",
            "drag": f"{digits(self.drag)} kg/m",
            "actuators": ", ".join(self.actuator_names),
        }
        rows = [
            (effect, name, part.text, "")
            if isinstance(part, LawText)
            else (effect, name, digits(part.value), part.unit)
            for effect, parameters in self.effect_quantities.items()
            for name, part in parameters.items()
        ]
        return Card(f"platform {self.name}", facts, ("effect", "parameter", "value", "unit"), rows, (self.description,))

    def _named(self, name: str) -> Actuator:
        return self.actuators[self.actuator_names.index(name)]

    def _wrench(self, actuator: Actuator) -> tuple[float, float, float, float]:
        if isinstance(actuator, BuoyancyPump):
            return 0.0, 0.0, 1.0, 0.0
        if isinstance(actuator, (Rudder, Fin, SlidingMass)):
            return 0.0, 0.0, 0.0, 0.0
        if isinstance(actuator, Azimuth):
            along, across, _, _ = self._wrench(self._named(actuator.thruster))
            x, y, _ = _place(self._named(actuator.thruster))
            return -across, along, 0.0, x * along + y * across
        (x, y, _), (along, across, up) = actuator.position, actuator.direction
        return along, across, up, x * across - y * along

    def _full_force(self, actuator: Actuator) -> tuple[float, float]:
        if isinstance(actuator, (Rudder, Fin, SlidingMass)):
            return 0.0, 0.0
        if isinstance(actuator, Azimuth):
            force = max(self._limits(self._named(actuator.thruster)))
            return force, force
        return self._limits(actuator)

    def _limits(self, actuator: Actuator) -> tuple[float, float]:
        if isinstance(actuator, BuoyancyPump):
            force = self.water_density * self.gravity * actuator.volume_range
            return force, force
        if isinstance(actuator, SlidingMass):
            return actuator.travel, actuator.travel
        if not isinstance(actuator, Thruster):
            return actuator.largest_angle, actuator.largest_angle
        gain = 1.0 if actuator.gain is None else actuator.gain
        return gain * actuator.maximum, gain * actuator.reverse


def load_platform(name_or_path: str | Path) -> Platform:
    """The platform of that name in config/platforms, or of that file.

    Raises CocorosimError: unknown name, unreadable file, unknown key, wrong unit, number without source.
    """
    return read_platform_file(find_config("platforms", place_text(name_or_path, "name_or_path")))


def read_platform_file(path: Path) -> Platform:
    """The platform that a file describes; every number in it must carry its source."""
    entry = load_yaml(path)
    refuse_maps(entry, "platform")
    require_sources(entry)
    return replace(read_platform(with_base(entry, "platforms")), origin=entry.file)


def read_platform(entry: Entry) -> Platform:
    """The platform that a mapping describes; what stands below 'robots' replaces whole top-level keys for one robot."""
    section = dict(entry.mapping())
    own = section.pop("robots").mapping() if "robots" in section else {}
    platform = _read_one(replace(entry, value=section))
    robots = {name: _read_one(replace(part, value={**section, **part.mapping()})) for name, part in own.items()}
    for name, robot in robots.items():
        if robot.actuator_names != platform.actuator_names:
            raise own[name].problem(
                f"has the actuators {quoted(robot.actuator_names)}; robots of one platform have the same: "
                f"{quoted(platform.actuator_names)}."
            )
    return replace(platform, robots=robots)


def _read_one(entry: Entry) -> Platform:
    platform = read_record(Platform, entry)
    section = entry.mapping()
    for part, kind in (("actuators", platform.actuators), ("sensors", platform.sensors.directed)):
        _refuse_repeated_names(section[part], [each.name for each in kind])
    check_actuators(section["actuators"], platform.actuators, platform.six_degrees is not None)
    if platform.mixing is not None:
        check_mixing(section["mixing"], platform.mixing, platform.actuators)
    if platform.six_degrees is not None:
        check_six_degrees(section["six_degrees"], platform.six_degrees, _of_four_degrees_alone(platform))
    ranges = {**platform.ranges, **collect_ranges(entry)}
    intervals = {**platform.intervals, **collect_ranges(entry, INTERVAL)}
    if platform.kept_as_given:
        check_kept(section["kept_as_given"], ranges)
    return replace(platform, ranges=ranges, intervals=intervals, origin=entry.file)


def _of_four_degrees_alone(platform: Platform) -> dict[str, Any]:
    """By key what a platform has that has no part in motion with six degrees of freedom; empty where it has none."""
    directed = {"sensors.blss": platform.sensors.blss, "sensors.obstacles": platform.sensors.obstacles}
    gains = {key: getattr(platform, key) for key in ("thrust_gain", "yaw_torque_gain", "buoyancy_gain")}
    return {"effects": platform.effect_quantities, **gains, **directed}


def platform_tree(platform: Platform) -> dict[str, Any]:
    """The platform as nested plain values that `read_platform` reads back."""
    tree = record_tree(platform)
    may_lack: dict[str, Any] = {"effects": {}, "ranges": {}, "intervals": {}}
    own = {name: may_lack | record_tree(robot) for name, robot in platform.robots.items()}
    if own:
        full = may_lack | tree
        tree["robots"] = {
            name: {key: part for key, part in robot.items() if part != full.get(key)} for name, robot in own.items()
        }
    return tree


def _place(actuator: Actuator) -> tuple[float, float, float]:
    return actuator.position if isinstance(actuator, Thruster) else (0.0, 0.0, 0.0)


def _refuse_repeated_names(entry: Entry, names: Sequence[str]) -> None:
    repeated = [name for name in names if names.count(name) > 1]
    if repeated:
        raise entry.problem(f"has the name '{repeated[0]}' more than once; give each its own.")
