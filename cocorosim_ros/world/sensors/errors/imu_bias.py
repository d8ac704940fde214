"""An IMU that is off by constants: shown = rate or acceleration + bias."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, added

UNITS = {"gyro_z": "rad/s", "accel_x": "m/s^2", "accel_y": "m/s^2", "accel_z": "m/s^2"}
IMU_BIAS = SensorError(
    summary="the IMU is off by a constant",
    parameters=tuple(Parameter(kind, unit, "reading less truth") for kind, unit in UNITS.items()),
    sensor="imu",
    changes=tuple(Change(kind, (kind,), added) for kind in UNITS),
)
