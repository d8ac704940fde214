"""Compass: the heading, exact, in (-pi, pi].

Source: Read et al. 2013, section 2.1; its operating system returns the exact heading.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import wrap_angle
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import YAW


@kernel
def compass_heading(row: Floats) -> float:
    """Heading [rad; world] of the robot whose state is `row`."""
    heading: float = wrap_angle(row[YAW])
    return heading
