"""A controller of your own for one robot, in plain rclpy: a slow circle, away from walls.

    cocorosim run eleven_lilys --external lily_03    prints two variables to export in a second shell; there:
    python external_controller.py lily_03

It ends when the run ends, or on Ctrl-C. In lock-step the run waits at each tick for one command that carries the
stamp of the readings that it answers; so it commands once, when compass and blue light of one stamp are there.
"""

import math
import sys

import rclpy
from cocorosim_msgs.msg import BlssScan, Compass, ThrusterCommand
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 120.0  # s for one circle
SPEED = 0.4  # fraction of full thrust
NEAR = 0.25  # m from a wall at which it turns away


class SlowCircle(Node):
    """Steers by compass and blue light."""

    def __init__(self, robot):
        super().__init__("slow_circle", namespace=robot)
        self.commands = self.create_publisher(ThrusterCommand, "thruster_command", 10)
        self.create_subscription(Compass, "compass", self._on_compass, 10)
        self.create_subscription(BlssScan, "blss", self._on_blss, 10)
        self.compass = self.blss = None

    def _on_compass(self, message):
        self.compass = message
        self._answer()

    def _on_blss(self, message):
        self.blss = message
        self._answer()

    def _answer(self):
        """Command once both readings of one moment are there."""
        if self.compass is None or self.blss is None or self.compass.header.stamp != self.blss.header.stamp:
            return
        stamp = self.compass.header.stamp
        wanted = 2 * math.pi * (stamp.sec + stamp.nanosec * 1e-9) / PERIOD
        turn = math.remainder(wanted - self.compass.heading, 2 * math.pi)  # rad, to the left
        ahead = [part for part in self.blss.readings if abs(part.azimuth) < 1.6 and abs(part.elevation) < 0.8]
        wall = min(ahead, key=lambda part: part.obstacle_range, default=None)
        if wall is not None and wall.obstacle_range < NEAR:
            turn = -math.copysign(1.5, wall.azimuth)
        turn = max(-0.5, min(0.5, turn))
        command = ThrusterCommand(name=["left", "right", "buoyancy"], command=[SPEED - turn, SPEED + turn, 0.0])
        command.header.stamp = stamp
        self.commands.publish(command)

    def is_over(self):
        """Whether there were readings and nobody is left who publishes any."""
        return self.compass is not None and self.count_publishers("compass") == 0


def main():
    """Control the robot that the command line names."""
    rclpy.init()
    node = SlowCircle(sys.argv[1])
    try:
        while not node.is_over():
            rclpy.spin_once(node, timeout_sec=0.5)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
