"""Orbital velocity below waves, and their pressure: linear waves over a flat floor.

Of each component of amplitude a, frequency omega, wave number k along (k_x, k_y), with
theta = k_x x + k_y y - omega t + phase: along it a omega cosh(k (z + h)) / sinh(k h) cos(theta), upwards
a omega sinh(k (z + h)) / sinh(k h) sin(theta), and the pressure rho g a cosh(k (z + h)) / cosh(k h) cos(theta). In deep
water all decay as exp(k z).
The numbers are the depth h [m], then for each component a [m], omega [rad/s], k, k_x, k_y [rad/m], phase [rad].
Assumes: walls do not reflect; a robot is moved by drag in the water that oscillates, not by the pressure's gradient.
Source: Dean and Dalrymple, Water Wave Mechanics (1991), equations 4.4, 4.5 and 4.22.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import X, Z
from cocorosim_ros.world.water.current import Current

DEPTH = 0  # place of the depth
SIZE = 6  # numbers of a component


@kernel
def add_component(place: Floats, time: float, depth: float, component: Floats, total: Floats) -> None:
    """Add the orbital velocity of one component, its numbers (SIZE,) as above; depth: infinite without a floor."""
    amplitude, omega, k, east, north, phase = unpack(component, 6)
    z = place[2]
    sine, cosine = sine_cosine(east * place[0] + north * place[1] - omega * time + phase)
    # The quotients of hyperbolic functions by exponentials that never overflow.
    down, up = math.exp(k * z), math.exp(-k * (z + 2.0 * depth))
    speed = amplitude * omega / -math.expm1(-2.0 * k * depth)
    along = speed * (down + up) * cosine / k
    total[0] += along * east
    total[1] += along * north
    total[2] += speed * (down - up) * sine


@kernel
def waves(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the orbital velocity."""
    for first in range(1, parameters.shape[0], SIZE):
        add_component(place, time, parameters[DEPTH], parameters[first : first + SIZE], total)


@kernel
def wave_head(place: Floats, time: float, parameters: Floats) -> float:
    """The pressure of the waves over the weight of the water [m]; at the surface how high it stands."""
    depth, z, head = parameters[DEPTH], place[2], 0.0
    for first in range(1, parameters.shape[0], SIZE):
        omega, k = parameters[first + 1], parameters[first + 2]
        east, north, phase = parameters[first + 3], parameters[first + 4], parameters[first + 5]
        _, cosine = sine_cosine(east * place[0] + north * place[1] - omega * time + phase)
        share = (math.exp(k * z) + math.exp(-k * (z + 2.0 * depth))) / (1.0 + math.exp(-2.0 * k * depth))
        head += parameters[first] * share * cosine
    return head


@kernel
def add_wave_pressure(state: Floats, time: float, parameters: Floats, weight: Floats, pressure: Floats) -> None:
    """Add to `pressure` (runs, robots) [Pa] that of the waves at `time` [s] on every robot of `state`.

    `weight` (robots,): density times gravity of the water [Pa/m].
    """
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            head = wave_head(state[run, robot, X : Z + 1], time, parameters)
            pressure[run, robot] += weight[robot] * head


def fastest(parameters: Floats, size: tuple[float, float, float]) -> float:
    """The speed [m/s] at the surface were all components at their crests in one place."""
    rows = parameters[1:].reshape(-1, SIZE)
    return float((rows[:, 0] * rows[:, 1] / np.tanh(rows[:, 2] * parameters[DEPTH])).sum())


WAVES = Current(summary="orbital velocity below waves", velocity=waves, parameters=(), fastest=fastest)
