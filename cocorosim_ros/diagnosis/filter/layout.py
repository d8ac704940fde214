"""Layout of the arrays of the filter: states, kinds of readings, numbers of sensors and of the random force."""

from __future__ import annotations

from cocorosim_ros.world.sensors import KINDS as KIND_TABLE
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.errors import ERROR_COLUMNS, NEUTRAL
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE

KIND_NAMES = tuple(KIND_TABLE)
"""Kinds of single readings; the place is the code, in the order of streams.log.STREAMS."""
POSE_X, POSE_Y, POSE_Z, POSE_YAW, COMPASS, PRESSURE, GYRO = (
    KIND_NAMES.index(name) for name in ("pose_x", "pose_y", "pose_z", "pose_yaw", "compass", "pressure", "gyro_z")
)
KINDS = len(KIND_NAMES)
KINDS_OF_STREAM = {
    topic: tuple(KIND_NAMES.index(kind.name) for kind in sensor.kinds)
    for topic, sensor in SENSORS.items()
    if sensor.kinds
}
ANGLES = tuple(code for code, kind in enumerate(KIND_TABLE.values()) if kind.angle)
UPRIGHT = tuple(code for code, kind in enumerate(KIND_TABLE.values()) if kind.upright)

WATER_WEIGHT = "water_weight"
"""Pressure per metre of depth [Pa/m] by which a pressure sensor shows it; no error, and no fit looks for it."""
# Numbers of the sensors' errors, by the contract's names, and that of their water.
SENSOR_COLUMNS = (*ERROR_COLUMNS, WATER_WEIGHT)
NEUTRAL_SENSORS = (*NEUTRAL, PASCAL_PER_METRE)
"""Values of these numbers where nothing is wrong, in the contract's fresh water."""

# The random force of the water: rms of its processes, their correlation time and smoothness; and how far the place that
# an instrument shows wanders in the root of a second.
RMS_LEVEL, RMS_UPRIGHT, RMS_YAW, CORRELATION, SMOOTHNESS, WANDERING = range(6)
