"""Everything that does not change during a run, as arrays: what a scenario becomes before the first tick."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.corruption import Corruption
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers.crew import Crew
from cocorosim_ros.world.links.acoustic_channel import Channel
from cocorosim_ros.world.links.blue_light import TO_NEAREST
from cocorosim_ros.world.motion.motion import Stepping
from cocorosim_ros.world.sensors.exact_neighbours import EXACT_RANGE
from cocorosim_ros.world.sensors.faults import Faults
from cocorosim_ros.world.sensors.instruments import Instruments
from cocorosim_ros.world.six_degrees.swimming import School
from cocorosim_ros.world.surroundings.lamps import Lamps, darkness
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.tick.wants import Wants
from cocorosim_ros.world.tick.water import Water
from cocorosim_ros.world.vehicle_model.vehicles import Vehicles


@dataclass(frozen=True)
class World:
    """The fixed numbers of `runs` runs with the same robots."""

    names: tuple[str, ...]  # of the robots
    tick_ns: int
    tank: Tank
    stepping: Stepping
    vehicles: Vehicles
    instruments: Instruments
    crew: Crew
    radio_range: Floats  # (robots,) [m]
    wants: Wants | None = None  # None: nobody wants anything
    lamps: Lamps = field(default_factory=darkness)
    light_delivery: int = TO_NEAREST  # DELIVERY_CODE of blue light
    channel: Channel | None = None  # of sound
    instant_radio: bool = False  # what is said is heard at the same tick
    faults: Faults | None = None  # of the instruments
    command_delay: Floats = field(default_factory=lambda: np.zeros(0))  # (robots,) [s]; 0, or empty: none is late
    corruption: tuple[Corruption, ...] = ()
    seed: int = 0  # of what is random while the run goes on
    first_run: int = 0  # the number of the first of the runs, by which their random numbers differ
    water: Water = field(default_factory=Water)
    school: School | None = None  # of the robots that roll and pitch
    plain: Mapping[int, RobotDescription] = field(default_factory=dict)  # robots with a plain Python controller

    @property
    def reach(self) -> float:
        """As far as any robot sees, is heard, or knows its neighbours exactly [m]."""
        exact = EXACT_RANGE if self.wants is not None and self.wants.neighbours.any() else 0.0
        return float(max(exact, self.instruments.neighbour_range.max(), self.radio_range.max()))

    @property
    def robots(self) -> int:
        """How many robots swim in one run."""
        return len(self.names)
