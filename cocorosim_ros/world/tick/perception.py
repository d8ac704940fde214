"""All that the robots sense and hear at one tick, in one record."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.world.sensors.readings import Readings
from cocorosim_ros.world.state.neighbourhood import Neighbourhood
from cocorosim_ros.world.state.radio import Inbox


class Perception(NamedTuple):
    """What controllers decide by; each part has leading axes (runs, robots)."""

    readings: Readings
    radio: Inbox
    light: Inbox  # heard over blue light
    sound: Inbox  # heard by sound; its messages have SOUND_SIZE columns
    neighbourhood: Neighbourhood
