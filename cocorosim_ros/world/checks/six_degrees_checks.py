"""What a scenario with robots that roll and pitch may ask for, and how long their integrator's steps may be."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.ocean_current import OceanCurrent
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.fastest_water import fastest_water
from cocorosim_ros.world.six_degrees.description import vehicle_of
from cocorosim_ros.world.six_degrees.vehicle import Vehicle

INTEGRATOR = "rk4"
STABLE_RADIUS = 2.6  # of the half disc left of the imaginary axis in which the classical Runge-Kutta method is stable


def check_six_degrees(scenario: Scenario, sections: Mapping[str, Entry]) -> None:
    """Nothing, if robots with six degrees of freedom meet only what they know; sections: by key.

    Raises CocorosimError otherwise, and for a step that is too long for them.
    """
    platforms = [group.platform for group in scenario.swarm if group.platform.six_degrees is not None]
    for platform in dict.fromkeys(platforms):
        _check_one(scenario, sections, platform)


def _check_one(scenario: Scenario, sections: Mapping[str, Entry], platform: Platform) -> None:
    named = f"the platform '{platform.name}' has six degrees of freedom"
    place, water = sections["integrator"], scenario.water
    if scenario.integrator.name != INTEGRATOR:
        raise place.problem(
            f"has '{scenario.integrator.name}', and {named}, for which '{INTEGRATOR}' alone is there; choose that."
        )
    layers = water is not None and any(isinstance(each, OceanCurrent) and each.buoyancy for each in water.currents)
    if water is not None and (water.force_currents is not None or layers):
        raise sections["water"].problem(
            f"has forces on patches of water or the density of an ocean model, and {named}, which does not feel these "
            "yet; leave them out ('buoyancy: false' in the ocean model)."
        )
    step, longest = scenario.integrator.step_ns / 1e9, longest_stable_step(platform, fastest_water(scenario))
    if step > longest:
        raise place.problem(
            f"has a step of {step:g} s, beyond the {longest:.3g} s up to which '{INTEGRATOR}' is stable for the "
            f"platform '{platform.name}'; choose a shorter step."
        )


def longest_stable_step(platform: Platform, water: float = 0.0) -> float:
    """The step [s] up to which a vehicle's motion is stable at its terminal speeds in water of this speed [m/s].

    Of the linear motion about upright, M nu_dot = -(D + 2 Q |nu| + |u| L) nu - K eta with the restoring stiffness K,
    all eigenvalues times the step have to lie within STABLE_RADIUS. Terminal speeds are those of each axis by itself,
    under all thrusters along it at once. Left out: Coriolis forces and fins; a motion that runs away all the same ends
    the run. Source: Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.2.
    """
    vehicle = vehicle_of(platform)
    inverse = np.linalg.inv(vehicle.mass_matrix())
    speeds = terminal_speeds(vehicle) + np.array([water, water, water, 0.0, 0.0, 0.0])
    damping = vehicle.linear + 2.0 * np.abs(vehicle.quadratic) * speeds + speeds[0] * vehicle.lift
    stiffness = np.zeros((6, 6))
    stiffness[3, 3] = stiffness[4, 4] = vehicle.moments_of_weight()[2]
    motion = np.block([[-inverse @ damping, -inverse @ stiffness], [np.eye(6), np.zeros((6, 6))]])
    fastest = float(np.abs(np.linalg.eigvals(motion)).max())
    return STABLE_RADIUS / fastest if fastest > 0.0 else math.inf


def terminal_speeds(vehicle: Vehicle) -> Floats:
    """(6,) [m/s, rad/s] at which the damping of each axis balances the most that acts along it; 0 without damping."""
    most = np.abs(vehicle.wrench).T @ vehicle.limit.max(axis=1, initial=0.0)
    most[2] += abs(vehicle.buoyancy - vehicle.weight)
    linear, quadratic = np.diag(vehicle.linear), np.diag(vehicle.quadratic)
    speeds = np.zeros(6)
    for axis in range(6):
        if quadratic[axis] > 0.0:
            root = math.sqrt(linear[axis] ** 2 + 4.0 * quadratic[axis] * most[axis])
            speeds[axis] = (root - linear[axis]) / (2.0 * quadratic[axis])
        elif linear[axis] > 0.0:
            speeds[axis] = most[axis] / linear[axis]
    return speeds
