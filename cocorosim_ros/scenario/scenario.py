"""A whole run as asked for: tank, swarm, time, integrator, seed, lock-step rules, recording."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Literal

from cocorosim_ros.foundation.card import Card, Shown
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.scenario.parts.acoustic import Acoustic
from cocorosim_ros.scenario.parts.controller_choice import AnyController
from cocorosim_ros.scenario.parts.corruption import CORRUPTIONS, Corruption
from cocorosim_ros.scenario.parts.light import Light
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.swarm import SWARM, SwarmGroup
from cocorosim_ros.scenario.parts.tank import Box, Sphere, Tank
from cocorosim_ros.scenario.parts.water import Water
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import nanoseconds_text, read_nanoseconds
from cocorosim_ros.scenario.reading.records import (
    TEXT,
    TIME_FORM,
    choice,
    nested,
    quantity,
    record_tree,
    stored,
)
from cocorosim_ros.scenario.reading.yaml_file import yaml_text

if TYPE_CHECKING:
    import pandas as pd

__all__ = [
    "Box",
    "Integrator",
    "LockStep",
    "Radio",
    "RecordedTopics",
    "RobotDescription",
    "Scenario",
    "Sphere",
    "Tank",
]
_LARGEST_SEED = 2**63 - 1


def _read_names(entry: Entry) -> tuple[str, ...]:
    return tuple(part.text() for part in entry.items())


_SEED = stored(lambda entry: entry.whole_number(0, _LARGEST_SEED), int, form=f"whole number from 0 to {_LARGEST_SEED}")


def _read_topics(entry: Entry) -> Literal["all"] | tuple[str, ...]:
    return "all" if entry.value == "all" else _read_names(entry)


@dataclass(frozen=True)
class Integrator:
    """How the equations of motion are stepped.

    contact: `inelastic` walls take away the velocity into them, `stop_position` walls (the paper's) do not.
    """

    name: Literal["rk4", "semi_implicit_euler"] = field(metadata=choice("rk4", "semi_implicit_euler"))
    step_ns: int = field(metadata=stored(read_nanoseconds, nanoseconds_text, key="step", form=TIME_FORM))
    contact: Literal["inelastic", "stop_position"] = field(
        default="inelastic", metadata=choice("inelastic", "stop_position")
    )

    @property
    def step(self) -> float:
        """The step in seconds."""
        return self.step_ns / 1e9


@dataclass(frozen=True)
class Radio:
    """Settings of the radio that hold for all robots; `range` [m] replaces the platforms' own.

    latency: `one_tick`, what is said at a tick is heard at the next, or `none`, it is heard at the same tick (the
    paper's direct message passing; without ROS only, where all robots can speak before anyone decides).
    """

    range: float | None = field(default=None, metadata=quantity("length", "not negative"))
    latency: Literal["one_tick", "none"] = field(default="one_tick", metadata=choice("one_tick", "none"))


@dataclass(frozen=True)
class BlueLight:
    """Messages over blue light: `to_nearest` robot in each of the sender's cones, or heard `from_nearest`."""

    delivery: Literal["to_nearest", "from_nearest"] = field(
        default="to_nearest", metadata=choice("to_nearest", "from_nearest")
    )


@dataclass(frozen=True)
class LockStep:
    """What happens when a controller gives no answer within `patience` seconds of wall-clock time."""

    silent_controller: Literal["stop", "thrusters_off"] = field(
        default="thrusters_off", metadata=choice("stop", "thrusters_off")
    )
    patience: float = field(default=10.0, metadata=quantity("time", "positive"))


@dataclass(frozen=True)
class RecordedTopics:
    """Which topics are recorded: all, or those with these names."""

    topics: Literal["all"] | tuple[str, ...] = field(
        default="all", metadata=stored(_read_topics, lambda topics: topics, form="all, or a list of names of topics")
    )


@dataclass(frozen=True)
class RobotDescription:
    """One robot: its name (and ROS namespace), body, controller, and whether somebody else controls it.

    acoustic: whether it has an acoustic modem.
    """

    name: str
    platform: Platform
    controller: AnyController
    external: bool
    acoustic: bool = False

    @property
    def radio_range(self) -> float:
        """How far this robot's radio reaches [m]; 0 without radio."""
        return self.platform.sensors.radio_range


@dataclass(frozen=True, repr=False)
class Scenario(Shown):
    """All that a run needs to be the same run again; times in whole nanoseconds. `origin` is its file."""

    name: str = field(metadata=TEXT)
    description: str = field(metadata=TEXT)
    seed: int = field(metadata=_SEED)
    tick_ns: int = field(metadata=stored(read_nanoseconds, nanoseconds_text, key="tick", form=TIME_FORM))
    duration_ns: int = field(metadata=stored(read_nanoseconds, nanoseconds_text, key="duration", form=TIME_FORM))
    tank: Tank = field(metadata=nested(Tank))
    integrator: Integrator = field(metadata=nested(Integrator))
    swarm: tuple[SwarmGroup, ...] = field(metadata=SWARM)
    external: tuple[str, ...] = field(
        default=(), metadata=stored(_read_names, list, form="list of names or patterns of robots")
    )
    radio: Radio = field(default_factory=Radio, metadata=nested(Radio))
    blue_light: BlueLight = field(default_factory=BlueLight, metadata=nested(BlueLight))
    acoustic: Acoustic | None = field(default=None, metadata=nested(Acoustic))
    light: Light = field(default_factory=Light, metadata=nested(Light))
    corruption: tuple[Corruption, ...] = field(default=(), metadata=CORRUPTIONS)
    lockstep: LockStep = field(default_factory=LockStep, metadata=nested(LockStep))
    recording: RecordedTopics = field(default_factory=RecordedTopics, metadata=nested(RecordedTopics))
    water: Water | None = field(default=None, metadata=nested(Water))
    origin: str = field(default="", compare=False)

    @property
    def ticks(self) -> int:
        """The number of ticks of the run."""
        return self.duration_ns // self.tick_ns

    @property
    def tick(self) -> float:
        """The length of a tick in seconds."""
        return self.tick_ns / 1e9

    @property
    def duration(self) -> float:
        """The length of the run in seconds."""
        return self.duration_ns / 1e9

    @property
    def steps_per_tick(self) -> int:
        """The number of integrator steps in a tick."""
        return self.tick_ns // self.integrator.step_ns

    @cached_property
    def robots(self) -> tuple[RobotDescription, ...]:
        """All robots, in the order of all arrays about them, with the scenario's radio range if any."""
        return tuple(
            RobotDescription(
                name,
                self._with_radio(group.platform.of_robot(name)),
                group.controller,
                name in self.external,
                self.acoustic is not None,
            )
            for group in self.swarm
            for name in group.robot_names()
        )

    def to_yaml(self) -> str:
        """The scenario as self-contained YAML, the same bytes each time, which `parse_scenario` reads."""
        return yaml_text(record_tree(self))

    def to_frame(self) -> pd.DataFrame:
        """One row a robot: robot, platform, controller, external."""
        rows = [(each.name, each.platform.name, each.controller.name, each.external) for each in self.robots]
        names = ("robot", "platform", "controller", "external")
        return data_frame({name: [row[place] for row in rows] for place, name in enumerate(names)})

    def card(self) -> Card:
        """What is asked for, and the robots."""
        facts = {
            "robots": str(len(self.robots)),
            "duration": f"{self.duration:g} s",
            "tick": f"{self.tick:g} s",
            "seed": str(self.seed),
            "tank": " x ".join(f"{side:g}" for side in self.tank.size) + " m",
        }
        rows = [(each.name, each.platform.name, each.controller.name) for each in self.robots]
        return Card(f"scenario {self.name}", facts, ("robot", "platform", "controller"), rows, (self.description,))

    def _with_radio(self, platform: Platform) -> Platform:
        if self.radio.range is None:
            return platform
        return replace(platform, sensors=replace(platform.sensors, radio_range=self.radio.range))
