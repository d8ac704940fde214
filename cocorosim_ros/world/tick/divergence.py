"""A run whose numbers have run away ends with a sentence instead of going on with what is no number."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.tick.world import World


class RanAwayError(CocorosimError):
    """The motion of a robot ran away."""

    def __init__(self, sentence: str, ticks: int) -> None:
        """`ticks`: how many the run had made until then."""
        super().__init__(sentence)
        self.ticks = ticks


@kernel
def _sum_of_motion(state: Floats) -> float:
    """Of all numbers that are the motion of a robot; not finite if one of them is not."""
    sums, total = stack_array(STATE_SIZE), 0.0
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            for column in range(STATE_SIZE):  # side by side: a sum of one number after the other waits for itself
                sums[column] += state[run, robot, column]
    for column in range(STATE_SIZE):
        total += sums[column]
    return total


def check_motion(state: Floats, world: World, tick: int) -> None:
    """Nothing while every state (runs, robots, row) is a number after `tick` ticks; else raises RanAwayError."""
    if math.isfinite(_sum_of_motion(state)):
        return
    moving = state[..., :STATE_SIZE]
    lost = np.argwhere(~np.isfinite(moving).all(axis=2))
    if len(lost) == 0:  # numbers that are finite, but too large to be added
        lost = np.argwhere(np.abs(moving).max(axis=2) == np.abs(moving).max())
    run, robot = lost[0]
    step = world.stepping.step
    raise RanAwayError(
        f"The motion of '{world.names[robot]}' ran away at {tick * world.tick_ns * 1e-9:g} s of simulated time (run "
        f"{world.first_run + run}): forces or currents are too strong for the integrator's step of {step:g} s. "
        "Choose a shorter step ('step' of 'integrator'), or weaker forces.",
        tick - 1,
    )
