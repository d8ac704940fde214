"""The longest step of time at which an integrator stays stable for a robot.

Quadratic drag pulls a deviation from the speed v back at the rate 2 k |v| / m, fastest at the terminal speed of all
actuators together, sqrt(F / k): the rate is then 2 sqrt(k F) / m, and 2 sqrt(Cr N) / I in yaw. Water that moves at U
makes v greater by U at most, linear drag d adds d / m, drag that is greater sideways takes the place of k. An
integrator is stable while rate times step lies within its interval on the real axis: 2 for the semi-implicit Euler
method, whose drag is explicit, and 2.785 for the classical Runge-Kutta method of fourth order.
Left out: other effects, and forces on patches of water; a motion that runs away all the same ends the run.
Source: Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.2.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.scenario.parts.platform import Platform

STABLE_INTERVAL = {"rk4": 2.785293563405282, "semi_implicit_euler": 2.0}


def fastest_rate(platform: Platform, water: float = 0.0) -> float:
    """The rate [1/s] at which the fastest motion of a robot settles in water of this speed [m/s]; 0 without drag."""
    most = platform.full_forces().max(axis=1, initial=0.0)
    wrench = np.abs(platform.actuator_wrenches()) * most[:, None]
    force = float(np.linalg.norm(wrench[:, :3].sum(axis=0)))
    torque = float(wrench[:, 3].sum())
    linear, uneven = platform.effects.get("linear_drag", {}), platform.effects.get("anisotropic_drag", {})
    drag = platform.drag * max(1.0, uneven.get("sway_ratio", 1.0), uneven.get("heave_ratio", 1.0))
    along = max((linear.get(axis, 0.0) for axis in ("surge", "sway", "heave")), default=0.0)
    swimming = (2.0 * math.sqrt(drag * force) + 2.0 * drag * water + along) / platform.mass
    turning = (2.0 * math.sqrt(platform.yaw_drag * torque) + linear.get("yaw", 0.0)) / platform.yaw_inertia
    return max(swimming, turning)


def longest_stable_step(integrator: str, platform: Platform, water: float = 0.0) -> float:
    """The step [s] above which an integrator is unstable for a robot at its full speed in water of this speed [m/s].

    inf if there is none.
    """
    rate = fastest_rate(platform, water)
    return STABLE_INTERVAL[integrator] / rate if rate > 0.0 else math.inf
