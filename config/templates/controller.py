"""A controller in plain Python: `cocorosim run eleven_lilys --controller NAME.py:CLASS --in-process`.

Each robot has its own object in each run. It is called once a tick with what its robot senses, and returns a Course for
the robot's operating system (which keeps it and avoids walls), or a Command or a mapping {"left": 0.5, ...} for its
actuators. In a scenario: `controller: {file: NAME.py:CLASS, parameters: {depth: 1.2}}`.
"""

import math

from cocorosim_ros.world.controllers.plain import Course


class CLASS:
    """Swims at one depth, and turns away from the nearest robot that it sees."""

    def __init__(self, depth=1.0, speed=0.5, random=None):
        """`depth` [m], `speed` (fraction of full thrust); `random` is this robot's own generator, from the seed."""
        self.depth, self.speed, self.random = depth, speed, random

    def __call__(self, sensed):
        """One tick: what is sensed at its start, in SI units; what was not measured is NaN, a free range infinite."""
        ranges = sensed.neighbour_range  # [m], by the names of the blue-light sensors
        nearest = min(ranges, key=ranges.get)
        turn = self.random.normal(0.0, 0.1)
        if math.isfinite(ranges[nearest]):
            x, y, _ = sensed.sensor_axis[nearest]  # where that sensor looks, in the body
            turn += math.atan2(-y, -x)
        heading = sensed.heading + turn if math.isfinite(sensed.heading) else None
        return Course(heading=heading, speed=self.speed, depth=self.depth)
