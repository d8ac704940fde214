"""From platforms with six degrees of freedom to the numbers of their vehicles."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.six_degrees.bodies import build_bodies
from cocorosim_ros.world.six_degrees.description import vehicle_of
from cocorosim_ros.world.six_degrees.swimming import School
from cocorosim_ros.world.vehicle_model.curves import build_curves


def build_school(platforms: Sequence[Platform]) -> School | None:
    """The vehicles among the robots of these platforms that have six degrees of freedom; None if there are none.

    Raises CocorosimError for a mass matrix that no body has, and for linear damping that gives energy.
    """
    numbers = [number for number, platform in enumerate(platforms) if platform.six_degrees is not None]
    if not numbers:
        return None
    own = [platforms[number] for number in numbers]
    bodies = build_bodies([vehicle_of(platform) for platform in own], build_curves(own))
    return School(bodies, np.array(numbers, dtype=np.int64))
