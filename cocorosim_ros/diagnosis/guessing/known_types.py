"""Messages whose fields are known: those of ROS by their types, those of PX4 by their topics."""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.diagnosis.evidence.streams.stream_columns import OVER_GROUND, THROUGH_WATER, VELOCITIES

Fields = Mapping[str, str]


def _vector(path: str, names: str = "x y z") -> dict[str, str]:
    return {name: f"{path}.{axis}" for name, axis in zip(names.split(), "xyz", strict=True)}


def _quaternion(path: str) -> dict[str, str]:
    return {f"q{axis}": f"{path}.{axis}" for axis in "xyzw"}


def _pose(path: str) -> dict[str, str]:
    return {**_vector(f"{path}.position"), **_quaternion(f"{path}.orientation")}


def _twist(path: str) -> dict[str, str]:
    return {**_vector(f"{path}.linear"), "yaw_rate": f"{path}.angular.z"}


def _list(path: str, names: str, first: int = 0) -> dict[str, str]:
    return {name: f"{path}[{first + index}]" for index, name in enumerate(names.split())}


_RATES, _FORCES = "rate_x rate_y rate_z", "acceleration_x acceleration_y acceleration_z"
ROS_TYPES: Mapping[str, Mapping[str, Fields]] = {
    "nav_msgs/msg/Odometry": {"pose": _pose("pose.pose"), OVER_GROUND: _twist("twist.twist")},  # in its own frame
    "geometry_msgs/msg/PoseWithCovarianceStamped": {"pose": _pose("pose.pose")},
    "geometry_msgs/msg/PoseStamped": {"pose": _pose("pose")},
    "geometry_msgs/msg/TransformStamped": {
        "pose": {**_vector("transform.translation"), **_quaternion("transform.rotation")}
    },
    "geometry_msgs/msg/TwistStamped": {THROUGH_WATER: _twist("twist")},
    "geometry_msgs/msg/TwistWithCovarianceStamped": {THROUGH_WATER: _twist("twist.twist")},
    "sensor_msgs/msg/Imu": {
        "imu": {
            **_vector("angular_velocity", _RATES),
            **_vector("linear_acceleration", _FORCES),
            **_quaternion("orientation"),
        }
    },
    "sensor_msgs/msg/FluidPressure": {"pressure": {"pressure": "fluid_pressure"}},
}
"""Streams of the messages of each type: in SI units, axes as REP 103 has them."""
PX4_TOPICS: Mapping[str, Mapping[str, Fields]] = {
    "vehicle_odometry": {"pose": {**_list("position", "x y z"), **_list("q", "qw qx qy qz")}},
    "vehicle_local_position": {"pose": {"x": "x", "y": "y", "z": "z", "yaw": "heading"}},
    "sensor_combined": {"imu": {**_list("gyro_rad", _RATES), **_list("accelerometer_m_s2", _FORCES)}},
    "vehicle_angular_velocity": {"imu": _list("xyz", _RATES)},
    "vehicle_attitude": {"imu": _list("q", "qw qx qy qz")},
    "vehicle_air_data": {"pressure": {"pressure": "baro_pressure_pa"}},
}
"""Streams of the topics of PX4: SI units, north-east-down, docs.px4.io."""
DIMENSIONS = {
    **dict.fromkeys(("x", "y", "z", "depth"), "length"),
    **dict.fromkeys(("roll", "pitch", "yaw", "heading"), "angle"),
    **dict.fromkeys(("qx", "qy", "qz", "qw"), "pure number"),
    **dict.fromkeys(_RATES.split(), "angular velocity"),
    **dict.fromkeys(_FORCES.split(), "acceleration"),
    "pressure": "pressure",
    "yaw_rate": "angular velocity",
}
"""Dimension of every number of a stream, but for x, y and z of a velocity."""


def dimension_of_number(stream: str, name: str) -> str:
    """The dimension of a number of a stream."""
    return "speed" if stream in VELOCITIES and name in ("x", "y", "z") else DIMENSIONS[name]
