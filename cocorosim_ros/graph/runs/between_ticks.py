"""What lies between two ticks, for those who look: how many steps there are, and where robots are at each."""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.state.state import YAW, X, Z

ROUNDING = 1e-9  # of a step; 20 Hz and ticks of 0.5 s are 10 steps, not 11


def steps_of_scenario(scenario: Scenario, smooth: float, rate: float) -> int:
    """What `steps_of_tick` gives for a scenario. Raises CocorosimError, too, where a robot rolls and pitches."""
    for robot in scenario.robots:
        if smooth != 0.0 and robot.platform.six_degrees is not None:
            raise CocorosimError(
                f"'smooth' has {smooth:g}, and '{robot.name}' has six degrees of freedom, whose roll and pitch are not "
                "shown between ticks yet; leave it out."
            )
    return steps_of_tick(smooth, rate, scenario.tick)


def steps_of_tick(smooth: float, rate: float, tick: float) -> int:
    """Into how many steps a tick [s] is divided to have at least `smooth` of them per simulated second; 1 for 0.

    Raises CocorosimError in lock-step (`rate` 0), and for so few that ticks alone come as often.
    """
    if smooth == 0.0:
        return 1
    if rate == 0.0:
        raise CocorosimError(
            f"'smooth' has {smooth:g}, and the run is in lock-step, which shows no time between ticks; give a rate as "
            "well, such as 1.0, or leave it out."
        )
    steps = math.ceil(smooth * tick - ROUNDING)
    if steps < 2:
        raise CocorosimError(
            f"'smooth' has {smooth:g}, and ticks of {tick:g} s come {1.0 / tick:g} times a second already; give more, "
            "in Hz, or leave it out."
        )
    return steps


def between(before: Floats, after: Floats, share: float) -> Floats:
    """States (robots, columns) whose places are so far (0 to 1) on the way from one tick's to the next's.

    Straight, and turning the shorter way; the other columns are those of `before`.
    """
    state = before.copy()
    state[:, X : Z + 1] += share * (after[:, X : Z + 1] - before[:, X : Z + 1])
    turn = (after[:, YAW] - before[:, YAW] + math.pi) % (2.0 * math.pi) - math.pi
    state[:, YAW] += share * turn
    return state
