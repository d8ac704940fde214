"""All that one robot may know at one moment. Controllers see this and nothing else."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.radio import MESSAGE_SIZE
from cocorosim_ros.world.state.sound import SOUND_SIZE


class Observation(NamedTuple):
    """What one robot senses and hears; NaN where an instrument gave nothing."""

    time: float  # s since the start of the run
    compass: float  # heading in (-pi, pi] [rad; world]
    pressure: float  # absolute [Pa]
    angular_rate: Floats  # (3,) [rad/s; body]
    specific_force: Floats  # (3,) [m/s^2; body]
    velocity: Floats  # (4,) u v w r through the water [m/s, rad/s; body]
    neighbour_range: Floats  # (sensors,) [m], +inf for none
    obstacle_range: Floats  # (sensors,) [m], +inf for none
    heard_count: int  # messages in `heard`
    heard: Floats  # (capacity, MESSAGE_SIZE) messages, see state.radio
    light_count: int  # messages in `light`
    light: Floats  # (capacity, MESSAGE_SIZE) messages that came over blue light
    sound_count: int  # messages in `sound`
    sound: Floats  # (capacity, SOUND_SIZE) messages that came by sound, with ranges, see state.sound
    neighbour_count: int  # robots in `neighbour_offset`; only the simulation knows them
    neighbour_offset: Floats  # (capacity, 3) true places of the neighbours [m; body]
    neighbour_velocity: Floats  # (capacity, 3) true velocities of the neighbours [m/s; world]
    illuminance: float  # ambient light [lx]
    concentration: float  # of the plume [kg/m^3]


def blank_observation(sensors: int, capacity: int) -> Observation:
    """What a robot with `sensors` blue-light sensors knows when every instrument is out of order."""
    return Observation(
        time=0.0,
        compass=np.nan,
        pressure=np.nan,
        angular_rate=np.full(3, np.nan),
        specific_force=np.full(3, np.nan),
        velocity=np.full(4, np.nan),
        neighbour_range=np.full(sensors, np.inf),
        obstacle_range=np.full(sensors, np.inf),
        heard_count=0,
        heard=np.zeros((capacity, MESSAGE_SIZE)),
        light_count=0,
        light=np.zeros((capacity, MESSAGE_SIZE)),
        sound_count=0,
        sound=np.zeros((capacity, SOUND_SIZE)),
        neighbour_count=0,
        neighbour_offset=np.zeros((capacity, 3)),
        neighbour_velocity=np.zeros((capacity, 3)),
        illuminance=np.nan,
        concentration=np.nan,
    )
