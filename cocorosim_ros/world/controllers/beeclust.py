"""BEECLUST: aggregation where it is bright, by waiting after each meeting as long as the place is bright.

A robot swims straight at one depth. When it meets another (a level sensor reads less than `meeting_range`) it
stops and waits w = longest_wait * E^2 / (E^2 + half_light^2), E being the illuminance there; then it turns and
swims on, and for `parting_time` meets nobody. Walls are the operating system's business. The turn is random in the
original; here it is the golden angle times the number of meetings, which spreads as evenly and needs no dice, so
that a node and a batch turn alike. Without a light sensor E counts as 0: it does not wait.
Source: Schmickl et al., Get in touch: cooperative decision making based on robot-to-robot collisions, Autonomous
Agents and Multi-Agent Systems 18 (2009); Bodi et al. 2015 for underwater vehicles.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.functions import set_depth, set_relative_heading, set_speed
from cocorosim_ros.world.controllers.request import NOTES, TURN_GAIN
from cocorosim_ros.world.state.observation import Observation

SETTINGS = ("meeting_range", "longest_wait", "half_light", "parting_time", "speed", "depth", "turn_gain")
MEETING_RANGE, LONGEST_WAIT, HALF_LIGHT, PARTING_TIME = 0, 1, 2, 3
CRUISE, CRUISE_DEPTH, CRUISE_TURN_GAIN = 4, 5, 6
WAITS_UNTIL, PARTS_UNTIL, MEETINGS = NOTES, NOTES + 1, NOTES + 2  # s, s, number
GOLDEN_ANGLE = math.pi * (3.0 - math.sqrt(5.0))  # rad
LEVEL = 0.5  # a cone whose axis rises or falls by less than 30 degrees


@kernel
def meets_somebody(observation: Observation, sensor_axis: Floats, meeting_range: float) -> bool:
    """Whether a level blue-light sensor sees a robot nearer than `meeting_range` [m]."""
    for sensor in range(sensor_axis.shape[0]):
        level = abs(sensor_axis[sensor, 2]) < LEVEL
        if level and observation.neighbour_range[sensor] < meeting_range:
            return True
    return False


@kernel
def waiting_time(illuminance: float, settings: Floats) -> float:
    """How long to wait [s] at an illuminance [lx]."""
    if not math.isfinite(illuminance) or illuminance <= 0.0:
        return 0.0
    squared = illuminance * illuminance
    wait: float = settings[LONGEST_WAIT] * squared / (squared + settings[HALF_LIGHT] ** 2)
    return wait


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Swim on, or stop and wait, or turn when the waiting is over."""
    now = observation.time
    request[TURN_GAIN] = settings[CRUISE_TURN_GAIN]
    set_depth(request, settings[CRUISE_DEPTH])
    set_speed(request, settings[CRUISE])
    waited = request[WAITS_UNTIL] > 0.0
    if waited and now < request[WAITS_UNTIL]:
        set_speed(request, 0.0)
    elif waited:
        request[WAITS_UNTIL] = 0.0
        request[PARTS_UNTIL] = now + settings[PARTING_TIME]
        set_relative_heading(request, observation.compass, request[MEETINGS] * GOLDEN_ANGLE)
    elif now >= request[PARTS_UNTIL] and meets_somebody(observation, sensor_axis, settings[MEETING_RANGE]):
        request[MEETINGS] += 1.0
        wait = waiting_time(observation.illuminance, settings)
        request[WAITS_UNTIL] = now + wait
        if wait > 0.0:
            set_speed(request, 0.0)


BEECLUST = Controller(
    summary="aggregation at light by waiting after meetings",
    settings=SETTINGS,
    decide=decide,
    needs=("illuminance",),
)
