"""What is fixed to a robot and has a frame of its own: thrusters, and sensors that look in a direction.

Compass, pressure, imu and velocity have none: a platform's file gives them no place, and they measure in base_link.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster, Vector3, unit_vector

BODY = "base_link"


@dataclass(frozen=True)
class RobotPart:
    """A frame on the body; its x axis is the way that a thruster pushes, or the axis of what a sensor sees.

    position: [m; body]. direction: unit vector of the x axis [body].
    """

    name: str
    position: Vector3
    direction: Vector3

    @property
    def yaw(self) -> float:
        """First turn from the body to the part, about z [rad]."""
        return math.atan2(self.direction[1], self.direction[0])

    @property
    def pitch(self) -> float:
        """Second turn, about the turned y axis [rad]; there is no third."""
        return -math.asin(max(-1.0, min(1.0, self.direction[2])))

    def quaternion(self) -> tuple[float, float, float, float]:
        """Both turns as a quaternion x, y, z, w."""
        sin_yaw, cos_yaw = math.sin(0.5 * self.yaw), math.cos(0.5 * self.yaw)
        sin_pitch, cos_pitch = math.sin(0.5 * self.pitch), math.cos(0.5 * self.pitch)
        return -sin_yaw * sin_pitch, cos_yaw * sin_pitch, sin_yaw * cos_pitch, cos_yaw * cos_pitch


def thruster_parts(platform: Platform) -> list[RobotPart]:
    """One part for each thruster, in the order of the actuators."""
    return [
        RobotPart(f"thruster_{each.name}", each.position, each.direction)
        for each in platform.actuators
        if isinstance(each, Thruster)
    ]


def sensor_parts(platform: Platform) -> list[RobotPart]:
    """One part for each sensor that looks in a direction; all look out from the body's centre."""
    sensors = platform.sensors
    looking = [(f"blss_{each.name}", each.azimuth, each.elevation) for each in sensors.blss]
    looking += [(f"obstacles_{each.name}", each.azimuth, each.elevation) for each in sensors.obstacles or ()]
    return [RobotPart(name, (0.0, 0.0, 0.0), unit_vector(azimuth, elevation)) for name, azimuth, elevation in looking]
