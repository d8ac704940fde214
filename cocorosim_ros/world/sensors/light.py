"""Light sensor: the illuminance at the robot's centre, the same from all directions, exact."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import X, Z
from cocorosim_ros.world.surroundings.lamps import Lamps, illuminance_at


@kernel
def measure_light(state: Floats, lamps: Lamps, wanted: Flags, reading: Floats) -> None:
    """Write the illuminance [lx] at every robot that is `wanted` (robots,) into `reading` (runs, robots)."""
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            if wanted[robot]:
                reading[run, robot] = illuminance_at(lamps, state[run, robot, X : Z + 1])
