"""Exact neighbours: place and velocity of every robot within range, which no real robot measures.

The baseline of the paper's comparison ("Vanilla") triangulates exactly all neighbours within 0.5 m.
Source: Read et al. 2013, section 5.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.state.neighbourhood import Neighbourhood
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, X, Y, Z
from cocorosim_ros.world.surroundings.neighbours import Neighbours

EXACT_RANGE = 0.5  # m, Read et al. 2013, section 5


@kernel
def _note(there: Floats, offset: Floats, place: Floats, velocity: Floats) -> None:
    """Write `offset` (3,) into `place` and the world velocity of the robot with state `there` into `velocity`."""
    sine, cosine = sine_cosine(there[YAW])
    for axis in range(3):
        place[axis] = offset[axis]
    velocity[0] = there[SURGE] * cosine - there[SWAY] * sine
    velocity[1] = there[SURGE] * sine + there[SWAY] * cosine
    velocity[2] = there[HEAVE]


@kernel
def exact_neighbours(
    state: Floats, wanted: Flags, reach: float, neighbours: Neighbours, neighbourhood: Neighbourhood
) -> None:
    """Write who is within `reach` [m] of every robot that is `wanted` (robots,) into `neighbourhood`.

    `state` (runs, robots, columns), `neighbours` who may be within reach. In the order of the robots; of more than
    there is room for, the first.
    """
    runs, robots = state.shape[0], state.shape[1]
    offset = stack_array(3)
    for run in range(runs):
        for robot in range(robots):
            if not wanted[robot]:
                continue
            here, count = state[run, robot], 0
            sine, cosine = sine_cosine(here[YAW])
            for other in neighbours.who[run, robot, : neighbours.near[run, robot]]:
                there = state[run, other]
                east, north = there[X] - here[X], there[Y] - here[Y]
                offset[2] = there[Z] - here[Z]
                squared = east * east + north * north + offset[2] * offset[2]
                if squared > reach * reach or count == neighbourhood.who.shape[2]:
                    continue
                offset[0], offset[1] = east * cosine + north * sine, north * cosine - east * sine
                neighbourhood.who[run, robot, count] = other
                _note(there, offset, neighbourhood.offset[run, robot, count], neighbourhood.velocity[run, robot, count])
                count += 1
            neighbourhood.found[run, robot] = count
