"""Layout of the arrays of the filter: states, kinds of readings, numbers of sensors and of the random force."""

from __future__ import annotations

# The horizontal block of the covariance: pose, velocity, random force of the water, and the gusts that drive it.
HX, HY, HYAW, HU, HV, HR, HFX, HFY, HN, HGX, HGY, HGN = range(12)
HORIZONTAL = 12
# The vertical block.
VZ, VW, VFZ, VGZ = range(4)
VERTICAL = 4

# Kinds of single readings, in the order of streams.log.STREAMS.
(
    POSE_X,
    POSE_Y,
    POSE_Z,
    POSE_YAW,
    COMPASS,
    PRESSURE,
    GYRO,
    ACCEL_X,
    ACCEL_Y,
    ACCEL_Z,
    VELOCITY_U,
    VELOCITY_V,
    VELOCITY_W,
) = range(13)
KINDS = 13
KIND_NAMES = (
    "pose_x", "pose_y", "pose_z", "pose_yaw", "compass", "pressure", "gyro_z", "accel_x", "accel_y", "accel_z",
    "velocity_u", "velocity_v", "velocity_w",
)  # fmt: skip
KINDS_OF_STREAM = {
    "pose": (POSE_X, POSE_Y, POSE_Z, POSE_YAW),
    "compass": (COMPASS,),
    "pressure": (PRESSURE,),
    "imu": (GYRO, ACCEL_X, ACCEL_Y, ACCEL_Z),
    "velocity": (VELOCITY_U, VELOCITY_V, VELOCITY_W),
}
ANGLES = (POSE_YAW, COMPASS)

# Numbers of the sensors, by the contract's names.
SENSOR_COLUMNS = (
    "compass_distortion.offset",
    "compass_distortion.sin",
    "compass_distortion.cos",
    "pressure_offset.offset",
    "pressure_drift.rate",
    "imu_bias.gyro_z",
    "imu_bias.accel_x",
    "imu_bias.accel_y",
    "imu_bias.accel_z",
    "camera_scale.scale",
)
OFFSET, SINE, COSINE, PRESSURE_OFFSET, PRESSURE_RATE, BIAS_GYRO, BIAS_X, BIAS_Y, BIAS_Z, SCALE = range(10)

# The random force of the water: rms of its processes, their correlation time and smoothness.
FORCE_XY, FORCE_Z, MOMENT_YAW, CORRELATION, SMOOTHNESS = range(5)
