"""What a robot perceives: a file for each sensor, its line in SENSORS; their errors in `errors`."""

from __future__ import annotations

from cocorosim_ros.world.sensors.blue_light import BLUE_LIGHT
from cocorosim_ros.world.sensors.chemical import CHEMICAL
from cocorosim_ros.world.sensors.compass import COMPASS
from cocorosim_ros.world.sensors.ground_velocity import GROUND_VELOCITY
from cocorosim_ros.world.sensors.imu import IMU
from cocorosim_ros.world.sensors.light import LIGHT
from cocorosim_ros.world.sensors.pose import POSE
from cocorosim_ros.world.sensors.pressure import PRESSURE
from cocorosim_ros.world.sensors.sensor import Kind, Sensor
from cocorosim_ros.world.sensors.velocity import VELOCITY

_TABLE: tuple[Sensor, ...] = (
    POSE,
    COMPASS,
    PRESSURE,
    IMU,
    BLUE_LIGHT,
    VELOCITY,
    GROUND_VELOCITY,
    LIGHT,
    CHEMICAL,
)

SENSORS: dict[str, Sensor] = {sensor.topic: sensor for sensor in _TABLE}
"""Every sensor by its topic, in the order in which topics are recorded."""
KINDS: dict[str, Kind] = {kind.name: kind for sensor in _TABLE for kind in sensor.kinds}
"""Every number of a reading that a diagnosis knows, in the order of its codes."""
