"""A gyroscope that is wrong by a factor: shown = scale * yaw rate.

Source: scale factor error of a rate gyro; IEEE Std 528-2019, Inertial Sensor Terminology.
"""

from __future__ import annotations

from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, multiplied, multiplied_slope
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.search import Search, Strength

GYRO_SCALE = SensorError(
    summary="gyroscope that is wrong by a factor",
    equation="reading = scale * yaw rate",
    parameters=(
        Number(
            "scale",
            "1",
            "yaw rate as read over yaw rate",
            1.0,
            "positive",
            multiplies="rad/s",
            gives="rad/s",
            search=Strength(large=0.05),
            example=Example(0.97, "full turns counted"),
        ),
    ),
    sensor="imu",
    changes=(Change("gyro_z", ("scale",), multiplied, multiplied_slope),),
    against="r",
    # A factory sets it; a camera's scale and a mounting's offset are set on site. Four to one: chosen, not measured.
    search=Search(prior_nats=1.4, channel="imu", topic="imu", manoeuvre="slow_turns"),
    check="Turn the robot through ten full circles, and compare the integral of the yaw rate with 20 pi.",
)
