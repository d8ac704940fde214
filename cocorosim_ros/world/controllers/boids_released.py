"""Boids as the authors' released model has them: the four variants of controllers.boids_rules with its own rules.

present_course: a robot alone, or one whose rules sum to zero, asks for the heading that it has now and keeps its dive
mode (elsewhere: for the last one that was asked for, and no dive).
halt_unseen (NA): a robot with a neighbour within 0.5 m that no sensor in use sees is not alone: its rules sum to zero,
and it gets no thrust (elsewhere it is alone). Needs the exact neighbours, which no real robot has.
cone_of_view (Vanilla): 270 degrees of view are a cone about the bow in three dimensions (elsewhere a wedge in azimuth).
body_median (Vanilla): the median of velocities is taken in body axes instead of world axes, those of all other variants
and of the released model; which ones the paper does not say.
Source: the released model run beside ours, cocorosim-facts 8.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.four import LANES
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array, unset_stack_rows
from cocorosim_ros.world.controllers.boids_na import total_without_alignment
from cocorosim_ros.world.controllers.boids_rules import (
    BOIDS_TURN_GAIN,
    SETTINGS,
    add_alignment,
    add_range_rules,
    median_heard_velocity,
    say_velocity,
    swim_alone,
    swim_as_wished,
    take_up_boids,
    weight_total,
)
from cocorosim_ros.world.controllers.boids_vanilla import add_neighbours_rules, note_neighbours
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.request import HEADING, SPEED, TURN_GAIN
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.radio import HEARING_LIMIT

RELEASED_SETTINGS = (*SETTINGS, "present_course")
PRESENT_COURSE = len(SETTINGS)
CONE_OF_VIEW, BODY_MEDIAN = len(RELEASED_SETTINGS), len(RELEASED_SETTINGS) + 1
KEEP_DIVISOR, HALT_UNSEEN = len(RELEASED_SETTINGS), len(RELEASED_SETTINGS) + 1


@kernel
def _ask_for_present_heading(compass: float, settings: Floats, request: Floats) -> None:
    request[HEADING] = compass
    request[TURN_GAIN] = settings[BOIDS_TURN_GAIN]


@kernel
def _go_on_alone(compass: float, settings: Floats, request: Floats) -> None:
    """Ask for what a robot does that senses no other."""
    if settings[PRESENT_COURSE] != 0.0:
        _ask_for_present_heading(compass, settings, request)
    else:
        take_up_boids(settings, request)
    swim_alone(settings, request)


@kernel
def _follow(compass: float, wish: Floats, total: float, settings: Floats, request: Floats) -> None:
    """Turn the sum of the weighted rules `wish` (3,) [body] over `total` into a request; of zero, by present_course."""
    holds = settings[PRESENT_COURSE] != 0.0
    if holds and wish[0] == 0.0 and wish[1] == 0.0:
        _ask_for_present_heading(compass, settings, request)
        if wish[2] == 0.0:
            request[SPEED] = 0.0
            return
    take_up_boids(settings, request)
    swim_as_wished(compass, wish, total, settings, request)


@kernel
def _decide_by_blue_light(
    observation: Observation, heard: Floats, number: int, sensor_axis: Floats, settings: Floats, request: Floats
) -> None:
    """Turn the ranges seen and the first `number` messages of `heard` into heading, speed and dive speed."""
    if math.isnan(observation.compass):
        take_up_boids(settings, request)
        return
    wish, velocity = stack_array(3), stack_array(3)
    seen = add_range_rules(observation, sensor_axis, settings, wish)
    if seen + median_heard_velocity(heard, number, velocity) == 0:
        _go_on_alone(observation.compass, settings, request)
        return
    add_alignment(observation.compass, velocity, settings, wish)
    _follow(observation.compass, wish, weight_total(settings), settings, request)


@kernel
def _decide_blt(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn what is seen and heard on the radio into a request."""
    _decide_by_blue_light(observation, observation.heard, observation.heard_count, sensor_axis, settings, request)


@kernel
def _decide_blc(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn what is seen and heard over blue light into a request."""
    _decide_by_blue_light(observation, observation.light, observation.light_count, sensor_axis, settings, request)


@kernel
def _decide_na(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn what is seen into a request."""
    if math.isnan(observation.compass):
        take_up_boids(settings, request)
        return
    wish = stack_array(3)
    known = add_range_rules(observation, sensor_axis, settings, wish)
    if settings[HALT_UNSEEN] != 0.0:
        known = observation.neighbour_count
    if known == 0:
        _go_on_alone(observation.compass, settings, request)
        return
    _follow(observation.compass, wish, total_without_alignment(settings, KEEP_DIVISOR), settings, request)


@kernel
def _turn_to_body(compass: float, velocities: Floats, count: int) -> None:
    """Turn the first `count` of `velocities` (n, LANES) [m/s] from world to body axes."""
    sine, cosine = sine_cosine(compass)
    for index in range(count):
        east, north = velocities[index, 0], velocities[index, 1]
        velocities[index, 0] = east * cosine + north * sine
        velocities[index, 1] = north * cosine - east * sine


@kernel
def _decide_vanilla(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn places and velocities of the neighbours in view into a request."""
    if math.isnan(observation.compass):
        take_up_boids(settings, request)
        return
    places = unset_stack_rows(HEARING_LIMIT, LANES)
    velocities = unset_stack_rows(HEARING_LIMIT, LANES)
    count = note_neighbours(observation, settings, settings[CONE_OF_VIEW] != 0.0, places, velocities)
    if count == 0:
        _go_on_alone(observation.compass, settings, request)
        return
    wish, to_turn = stack_array(3), observation.compass
    if settings[BODY_MEDIAN] != 0.0:
        _turn_to_body(observation.compass, velocities, count)
        to_turn = 0.0
    add_neighbours_rules(to_turn, places, velocities, count, settings, wish)
    _follow(observation.compass, wish, weight_total(settings), settings, request)


BOIDS_BLT_RELEASED = Controller(
    summary="boids_blt by the rules of the released model",
    settings=RELEASED_SETTINGS,
    decide=_decide_blt,
    speak=say_velocity,
    payload_length=3,
)
BOIDS_BLC_RELEASED = Controller(
    summary="boids_blc by the rules of the released model",
    settings=RELEASED_SETTINGS,
    decide=_decide_blc,
    speak=say_velocity,
    payload_length=3,
    medium="blue_light",
    needs=("blue_light_rx",),
)
BOIDS_NA_RELEASED = Controller(
    summary="boids_na by the rules of the released model",
    settings=(*RELEASED_SETTINGS, "keep_divisor", "halt_unseen"),
    decide=_decide_na,
    needs=("neighbours",),
)
BOIDS_VANILLA_RELEASED = Controller(
    summary="boids_vanilla by the rules of the released model",
    settings=(*RELEASED_SETTINGS, "cone_of_view", "body_median"),
    decide=_decide_vanilla,
    needs=("neighbours",),
)
