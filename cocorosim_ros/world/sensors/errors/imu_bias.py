"""An IMU that is off by constants: shown = rate or acceleration + bias."""

from __future__ import annotations

from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, added
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.search import Search, Strength

# By kind: unit, what is large, an example.
BIASES = {
    "gyro_z": ("rad/s", 0.02, 0.01),
    "accel_x": ("m/s^2", 0.05, 0.03),
    "accel_y": ("m/s^2", 0.05, 0.0),
    "accel_z": ("m/s^2", 0.05, 0.0),
}
IMU_BIAS = SensorError(
    summary="IMU that is off",
    parameters=tuple(
        Number(
            kind,
            unit,
            "reading less truth",
            gives=unit,
            part=f"{kind} = truth + bias",
            search=Strength(large=large),
            example=Example(value, "at rest"),
        )
        for kind, (unit, large, value) in BIASES.items()
    ),
    sensor="imu",
    changes=tuple(Change(kind, (kind,), added) for kind in BIASES),
    search=Search(channel="imu", topic="imu", manoeuvre="rest"),
    check="Let the robot lie still, level and turned over, and read the sensor.",
)
