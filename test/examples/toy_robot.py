"""A robot of somebody else's, in plain rclpy: it turns and sinks by a few equations of its own, on wall-clock time.

    python toy_robot.py lily_01
    controller_node --ros-args -r __ns:=/lily_01 -p controller:=heading_hold -p period:=0.2

It obeys `thruster_command` and publishes compass, pressure and imu, but neither blue light nor velocity, as a robot
may. Every second it prints its time, heading and depth.
"""

import math
import sys

import rclpy
from cocorosim_msgs.msg import Compass, ThrusterCommand
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import FluidPressure, Imu

PERIOD = 0.1  # s
INERTIA, YAW_DRAG, LEVER, THRUST = 4e-4, 1.1e-4, 0.025, 0.005  # kg m^2, N m s^2, m, N
MASS, LIFT, DRAG = 0.44, 0.1, 1.8  # kg, N, kg/m


class ToyRobot(Node):
    """Heading and depth of a body with two thrusters and a pump."""

    def __init__(self, robot):
        super().__init__("toy_robot", namespace=robot)
        self.frame = f"{robot}/base_link"
        self.heading, self.rate, self.depth, self.sinking, self.ticks = -1.0, 0.0, 0.5, 0.0, 0
        self.wanted = {"left": 0.0, "right": 0.0, "buoyancy": 0.0}
        self.outlets = {
            name: self.create_publisher(kind, name, 10)
            for name, kind in (("compass", Compass), ("pressure", FluidPressure), ("imu", Imu))
        }
        self.create_subscription(ThrusterCommand, "thruster_command", self._obey, 10)
        self.create_timer(PERIOD, self._tick)

    def _obey(self, message):
        self.wanted.update(zip(message.name, message.command, strict=True))

    def _tick(self):
        self._move()
        compass = Compass(heading=math.remainder(self.heading, 2 * math.pi), variance=0.0)
        pressure = FluidPressure(fluid_pressure=101325.0 + 9810.0 * self.depth)
        imu = Imu()
        imu.orientation_covariance[0] = -1.0  # orientation is not estimated
        imu.angular_velocity.z = self.rate
        imu.linear_acceleration.z = 9.81
        for name, message in (("compass", compass), ("pressure", pressure), ("imu", imu)):
            message.header.stamp = self.get_clock().now().to_msg()
            message.header.frame_id = self.frame
            self.outlets[name].publish(message)
        self.ticks += 1
        if self.ticks % round(1 / PERIOD) == 0:
            print(f"{self.ticks * PERIOD:.0f} {compass.heading:.3f} {self.depth:.3f}", flush=True)

    def _move(self):
        torque = LEVER * THRUST * (self.wanted["right"] - self.wanted["left"]) - YAW_DRAG * abs(self.rate) * self.rate
        self.rate += torque / INERTIA * PERIOD
        self.heading += self.rate * PERIOD
        force = -LIFT * self.wanted["buoyancy"] - DRAG * abs(self.sinking) * self.sinking
        self.sinking += force / MASS * PERIOD
        self.depth = max(0.0, self.depth + self.sinking * PERIOD)


def main():
    """Be the robot that the command line names."""
    rclpy.init()
    try:
        rclpy.spin(ToyRobot(sys.argv[1]))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
