"""A controller of your own in plain Python: swim to the nearest robot in sight, and tell how many robots are heard.

    cocorosim run eleven_lilys --controller test/examples/own_controller.py:Follow --in-process

Without --in-process the same class runs as a node for each robot. In a scenario:

    controller: {file: own_controller.py:Follow, parameters: {depth: 1.2}}

Each robot has its own object in each run. It is called once a tick with what its robot senses, and returns a Course
for the robot's operating system, a Command for its actuators, or a mapping such as {"left": 0.5, "right": 0.4}.
"""

import math

from cocorosim_ros.world.controllers.plain import Course


class Follow:
    """Follows the nearest robot that it sees, and wanders where it sees none."""

    def __init__(self, depth=1.0, speed=0.5, random=None):
        """`depth` [m], `speed` (fraction of full thrust); `random` is this robot's own generator, from the seed."""
        self.depth, self.speed, self.random = depth, speed, random

    def __call__(self, sensed):
        """One tick."""
        ranges = sensed.neighbour_range
        nearest = min(ranges, key=ranges.get)
        if math.isfinite(ranges[nearest]):
            x, y, _ = sensed.sensor_axis[nearest]
            turn = math.atan2(y, x)
        else:
            turn = self.random.normal(0.0, 0.3)
        heading = sensed.heading + turn if math.isfinite(sensed.heading) else None
        return Course(heading=heading, speed=self.speed, depth=self.depth, say=[len(sensed.heard)])
