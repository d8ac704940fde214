"""Boids that know everything (Vanilla): exact places and velocities of all neighbours within 0.5 m.

Cohesion is the offset to the coordinate-wise median of the neighbours' places, separation the sum of
(threshold - distance) away from each neighbour nearer than the threshold, alignment the coordinate-wise median of
the neighbours' velocities. Impossible for a real robot: the baseline of the paper's comparison, in simulation only.
`observe_backwards` off leaves out neighbours more than 135 degrees off the bow, the released model's view of 270.
Source: Read et al. 2013, section 5; the released model for the medians; the rest stands in controllers.boids_rules.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array, unset_stack_rows
from cocorosim_ros.world.controllers.boids_rules import (
    COHESION_LENGTH,
    COHESION_WEIGHT,
    OBSERVE_BACKWARDS,
    SEPARATION_THRESHOLD,
    SEPARATION_WEIGHT,
    SETTINGS,
    add_alignment,
    swim_alone,
    swim_as_wished,
    take_up_boids,
    weight_total,
)
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.medians import coordinate_median
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.radio import HEARING_LIMIT

HALF_VIEW = 0.75 * math.pi  # rad


@kernel
def is_in_view(offset: Floats, settings: Floats, cone: bool) -> bool:
    """Whether a robot at `offset` (3,) [m; body] is looked at.

    cone: whether a view of 270 degrees is a cone about the bow in three dimensions, else it is a wedge in azimuth.
    """
    if settings[OBSERVE_BACKWARDS] != 0.0:
        return True
    if cone:
        distance = math.sqrt(offset[0] ** 2 + offset[1] ** 2 + offset[2] ** 2)
        ahead: bool = offset[0] >= math.cos(HALF_VIEW) * distance
        return ahead
    return abs(math.atan2(offset[1], offset[0])) <= HALF_VIEW


@kernel
def add_exact_rules(places: Floats, count: int, settings: Floats, wish: Floats) -> None:
    """Add weighted cohesion and separation for the first `count` of `places` (n, LANES) [m; body] to `wish` (3,)."""
    middle = stack_array(3)
    coordinate_median(places, count, middle)
    for axis in range(3):
        wish[axis] += settings[COHESION_WEIGHT] / settings[COHESION_LENGTH] * middle[axis]
    for index in range(count):
        place = places[index]
        distance = math.sqrt(place[0] ** 2 + place[1] ** 2 + place[2] ** 2)
        if 0.0 < distance < settings[SEPARATION_THRESHOLD]:
            push = settings[SEPARATION_WEIGHT] * (settings[SEPARATION_THRESHOLD] - distance) / distance
            for axis in range(3):
                wish[axis] -= push / settings[COHESION_LENGTH] * place[axis]


@kernel
def note_neighbours(observation: Observation, settings: Floats, cone: bool, places: Floats, velocities: Floats) -> int:
    """Write places [m; body] and velocities [m/s; world] of neighbours in view into (n, LANES) each; their number.

    cone: as for `is_in_view`.
    """
    count = 0
    for index in range(observation.neighbour_count):
        if is_in_view(observation.neighbour_offset[index], settings, cone):
            for axis in range(3):
                places[count, axis] = observation.neighbour_offset[index, axis]
                velocities[count, axis] = observation.neighbour_velocity[index, axis]
            count += 1
    return count


@kernel
def add_neighbours_rules(
    compass: float, places: Floats, velocities: Floats, count: int, settings: Floats, wish: Floats
) -> None:
    """Add all three rules for the first `count` neighbours, at `places` and with `velocities` (n, LANES), to `wish`."""
    velocity = stack_array(3)
    add_exact_rules(places, count, settings, wish)
    coordinate_median(velocities, count, velocity)
    add_alignment(compass, velocity, settings, wish)


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn what is known of the neighbours into heading, speed and dive speed; all stay while the compass fails."""
    take_up_boids(settings, request)
    if math.isnan(observation.compass):
        return
    places = unset_stack_rows(HEARING_LIMIT, LANES)
    velocities = unset_stack_rows(HEARING_LIMIT, LANES)
    count = note_neighbours(observation, settings, False, places, velocities)
    if count == 0:
        swim_alone(settings, request)
        return
    wish = stack_array(3)
    add_neighbours_rules(observation.compass, places, velocities, count, settings, wish)
    swim_as_wished(observation.compass, wish, weight_total(settings), settings, request)


BOIDS_VANILLA = Controller(
    summary="boids that know the exact places and velocities of all neighbours",
    settings=SETTINGS,
    decide=decide,
    needs=("neighbours",),
)
