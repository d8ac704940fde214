"""Plume tracking: upstream while there is a smell, across the current while there is none (surge and cast).

While the concentration is at least `threshold` the robot surges: it heads where the water comes from. When the smell is
lost it casts: it swims across the current, in legs to alternate sides that grow by `leg` each, while the current takes
it back. A plume narrows towards its source, so that each surge ends nearer to it. At `arrival` and above the source is
found and the robot stops.
Two simple ways of going up the concentration without that knowledge do worse, see
test/world/controllers/test_plume_gradient.py.
Assumes that the direction of the current is known (`upstream`): no instrument of Lily measures it.
Source: Hayes, Martinoli and Goodman 2002, Distributed odor source localization, IEEE Sensors Journal 2(3):260-271, and
Lochmatter and Martinoli 2008, for surge and cast; Read et al. 2013, section 6, for the task; the numbers are choices.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.functions import set_absolute_heading, set_depth, set_speed
from cocorosim_ros.world.controllers.request import NOTES, TURN_GAIN
from cocorosim_ros.world.state.observation import Observation

SETTINGS = ("threshold", "arrival", "upstream", "leg", "speed", "depth", "turn_gain")
THRESHOLD, ARRIVAL, UPSTREAM, LEG = 0, 1, 2, 3
TRACKING_SPEED, TRACKING_DEPTH, TRACKING_TURN_GAIN = 4, 5, 6
LEGS, LEG_ENDS = NOTES, NOTES + 1  # number of legs since the smell was lost; when the present one ends [s]


@kernel
def across(observation: Observation, settings: Floats, request: Floats) -> float:
    """The turn away from upstream [rad] of the present leg, a new one where the last has ended."""
    if request[LEGS] == 0.0 or observation.time >= request[LEG_ENDS]:
        request[LEGS] += 1.0
        request[LEG_ENDS] = observation.time + request[LEGS] * settings[LEG]
    return math.copysign(0.5 * math.pi, request[LEGS] % 2.0 - 0.5)


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Surge, cast, or stop at the source; a sensor that shows nothing smells nothing."""
    request[TURN_GAIN] = settings[TRACKING_TURN_GAIN]
    set_depth(request, settings[TRACKING_DEPTH])
    set_speed(request, settings[TRACKING_SPEED])
    turn = 0.0
    if observation.concentration >= settings[THRESHOLD]:
        request[LEGS] = 0.0
    else:
        turn = across(observation, settings, request)
    set_absolute_heading(request, settings[UPSTREAM] + turn)
    if observation.concentration >= settings[ARRIVAL]:
        set_speed(request, 0.0)


PLUME_TRACKING = Controller(
    summary="up a chemical plume to its source, by surge and cast",
    settings=SETTINGS,
    decide=decide,
    needs=("concentration",),
)
