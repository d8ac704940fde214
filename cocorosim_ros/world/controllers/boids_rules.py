"""The rules of boids that all variants share: cohesion, separation, alignment, and what is asked for in the end.

The velocity asked for is (w_c C + w_s S + w_a A) / (w_c + w_s + w_a); its direction is the heading, its
horizontal length the thrust (capped), its vertical part the dive speed. Who perceives nobody keeps heading and
dive speed and swims slowly. The variants differ in how they know of the others:

    variant         cohesion and separation by        velocities by
    boids_vanilla   exact places of all neighbours    exact velocities of all neighbours
    boids_blt       blue-light ranges                 radio, from everybody in range
    boids_blc       blue-light ranges                 blue light, from the nearest
    boids_na        blue-light ranges                 nothing: no alignment

The rules' vectors are pure numbers: `cohesion_length` and `alignment_length` say how many metres (or metres
per second) count as one. Equal lengths are consistent units; for ranges by blue light 1 m and 0.1 m are those of
the authors' released model, where alignment outweighs cohesion ten times more.
Source: Read et al. 2013, section 5; Reynolds 1987; the released model for what the paper leaves open.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine, wrap_angle
from cocorosim_ros.foundation.compiling.four import LANES, chosen, four_at, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array, unset_stack_rows
from cocorosim_ros.world.controllers.medians import coordinate_median
from cocorosim_ros.world.controllers.request import DIVE, DIVE_AT_SPEED, DIVE_MODE, HEADING, SPEED, TURN_GAIN
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.radio import HEARING_LIMIT, MESSAGE_LENGTH

SETTINGS = (
    "cohesion_weight",
    "separation_weight",
    "alignment_weight",
    "separation_threshold",
    "neighbour_trust",
    "observe_backwards",
    "cohesion_length",
    "alignment_length",
    "speed_cap",
    "lone_speed",
    "dive_gain",
    "turn_gain",
)
COHESION_WEIGHT, SEPARATION_WEIGHT, ALIGNMENT_WEIGHT = 0, 1, 2
SEPARATION_THRESHOLD, NEIGHBOUR_TRUST, OBSERVE_BACKWARDS = 3, 4, 5
COHESION_LENGTH, ALIGNMENT_LENGTH = 6, 7
SPEED_CAP, LONE_SPEED, DIVE_GAIN, BOIDS_TURN_GAIN = 8, 9, 10, 11


@kernel
def add_range_rules(observation: Observation, sensor_axis: Floats, settings: Floats, wish: Floats) -> int:
    """Add weighted cohesion and separation to `wish` (3,) [body]; return how many sensors saw a robot.

    Each blue-light sensor gives the range of the nearest robot in its cone, which is taken to lie on the cone's
    axis. Cohesion is the sum of these offsets, separation the sum of (threshold - range) away from those nearer
    than the threshold.
    """
    seen, looks_back = 0, settings[OBSERVE_BACKWARDS] != 0.0
    for sensor in range(sensor_axis.shape[0]):
        distance = observation.neighbour_range[sensor]
        # No branch on who is seen, of which a processor would guess every other one wrong: nobody pulls with zero.
        counts = math.isfinite(distance) & (looks_back | (sensor_axis[sensor, 0] >= -0.5))
        apart = settings[SEPARATION_WEIGHT] * (settings[SEPARATION_THRESHOLD] - distance)
        pull = chosen(counts & (distance < settings[NEIGHBOUR_TRUST]), settings[COHESION_WEIGHT] * distance, 0.0)
        pull -= chosen(counts & (distance < settings[SEPARATION_THRESHOLD]), apart, 0.0)
        seen += int(counts)
        for axis in range(3):
            wish[axis] += pull / settings[COHESION_LENGTH] * sensor_axis[sensor, axis]
    return seen


@kernel
def median_heard_velocity(messages: Floats, number: int, velocity: Floats) -> int:
    """Write the coordinate-wise median of the velocities heard (3,) [m/s; world]; return their number.

    `messages` (capacity, MESSAGE_SIZE), of which `number` were heard; what is no velocity does not count.
    """
    rows, count = unset_stack_rows(HEARING_LIMIT, LANES), 0
    fours = in_fours(rows)
    for index in range(number):
        said = messages[index]
        fours[count] = four_at(said, 1)
        if said[MESSAGE_LENGTH] == 3.0 and math.isfinite(said[1] + said[2] + said[3]):
            count += 1
    coordinate_median(rows, count, velocity)
    return count


@kernel
def add_alignment(compass: float, velocity: Floats, settings: Floats, wish: Floats) -> None:
    """Add weighted alignment with `velocity` (3,) [m/s; world] to `wish` (3,) [body]."""
    sine, cosine = sine_cosine(compass)
    weight = settings[ALIGNMENT_WEIGHT] / settings[ALIGNMENT_LENGTH]
    wish[0] += weight * (velocity[0] * cosine + velocity[1] * sine)
    wish[1] += weight * (velocity[1] * cosine - velocity[0] * sine)
    wish[2] += weight * velocity[2]


@kernel
def take_up_boids(settings: Floats, request: Floats) -> None:
    """Ask for dive speeds and the boids' turn gain, whatever avoidance asked for before."""
    request[TURN_GAIN] = settings[BOIDS_TURN_GAIN]
    if request[DIVE_MODE] != DIVE_AT_SPEED:
        request[DIVE_MODE] = DIVE_AT_SPEED
        request[DIVE] = 0.0


@kernel
def swim_alone(settings: Floats, request: Floats) -> None:
    """Ask for the speed of a robot that perceives nobody; heading and dive speed stay."""
    request[SPEED] = settings[LONE_SPEED]


@kernel
def swim_as_wished(compass: float, wish: Floats, total: float, settings: Floats, request: Floats) -> None:
    """Turn the sum of the weighted rules `wish` (3,) [body] over `total` into heading, speed and dive speed."""
    length = math.sqrt(wish[0] ** 2 + wish[1] ** 2) / total
    if length > 0.0:
        request[HEADING] = wrap_angle(compass + math.atan2(wish[1], wish[0]))
    request[SPEED] = min(length, settings[SPEED_CAP])
    request[DIVE] = settings[DIVE_GAIN] * wish[2] / total


@kernel
def weight_total(settings: Floats) -> float:
    """The sum of the three weights."""
    total: float = settings[COHESION_WEIGHT] + settings[SEPARATION_WEIGHT] + settings[ALIGNMENT_WEIGHT]
    return total


@kernel
def swim_by_blue_light(
    observation: Observation, heard: Floats, number: int, sensor_axis: Floats, settings: Floats, request: Floats
) -> None:
    """Turn the ranges seen and the first `number` messages of `heard` into heading, speed and dive speed.

    All stay while the compass fails.
    """
    take_up_boids(settings, request)
    if math.isnan(observation.compass):
        return
    wish, velocity = stack_array(3), stack_array(3)
    seen = add_range_rules(observation, sensor_axis, settings, wish)
    if seen + median_heard_velocity(heard, number, velocity) == 0:
        swim_alone(settings, request)
        return
    add_alignment(observation.compass, velocity, settings, wish)
    swim_as_wished(observation.compass, wish, weight_total(settings), settings, request)


@kernel
def say_velocity(observation: Observation, settings: Floats, message: Floats) -> None:
    """Say the own velocity through the water (3,) [m/s; world]; nothing while it is not known."""
    surge, sway, heave = observation.velocity[0], observation.velocity[1], observation.velocity[2]
    if not math.isfinite(surge + sway + heave + observation.compass):
        message[MESSAGE_LENGTH] = 0.0
        return
    sine, cosine = sine_cosine(observation.compass)
    message[MESSAGE_LENGTH] = 3.0
    message[1] = surge * cosine - sway * sine
    message[2] = surge * sine + sway * cosine
    message[3] = heave
