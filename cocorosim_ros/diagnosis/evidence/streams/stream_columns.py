"""Columns of the values of a stream, by name."""

from __future__ import annotations

from cocorosim_ros.diagnosis.evidence.streams.log import STREAMS

X, Y, Z, YAW = (STREAMS["pose"].index(name) for name in ("x", "y", "z", "yaw"))
PLANE = slice(X, Y + 1)
"""The horizontal place among the columns of a pose, or of a velocity stream."""
POSITION = slice(X, Z + 1)
"""The place among the columns of a pose."""
HEADING = STREAMS["compass"].index("heading")
AMBIENT = STREAMS["pressure"].index("pressure")
TURN_RATE, FELT_X, FELT_Y, FELT_Z = (
    STREAMS["imu"].index(name) for name in ("gyro_z", "accel_x", "accel_y", "accel_z")
)  # fmt: skip
FELT = slice(FELT_X, FELT_Z + 1)
"""The specific force among the columns of an IMU."""
U, V, W = (STREAMS["velocity"].index(name) for name in ("u", "v", "w"))
"""The columns of a velocity, through the water or over ground."""
THROUGH_WATER, OVER_GROUND = VELOCITIES = ("velocity", "ground_velocity")
"""Topics of velocities in body axes: that through the water and that over ground."""
