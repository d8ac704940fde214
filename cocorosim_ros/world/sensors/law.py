"""SENSOR_LAWS: places for laws of readings that no catalogue has: reading less truth = coefficient phi_1 phi_2.

The form in which `unknown:<topic>~<regressor>` stands in a platform file. The reading and the regressors are codes
(READINGS_OF_LAWS, terms.regressors); powers are as in effects.law, but `thrust` without its sign is what all
thrusters deliver, each by its own amount: what their motors draw. A diagnosis knows these laws; a simulation has none.
"""

from __future__ import annotations

from cocorosim_ros.scenario.parts.parameter import Parameter

READINGS_OF_LAWS = (
    "pose_x", "pose_y", "pose_z", "pose_yaw", "compass", "pressure", "gyro_z", "accel_x", "accel_y", "accel_z",
    "velocity_u", "velocity_v", "velocity_w",
)  # fmt: skip
NO_REGRESSORS_OF_READINGS = ("sin_t", "cos_t", "neighbour_distance")
LAW_OF_READING = (
    Parameter("coefficient", "*", "in the unit of the reading over the units of the regressors"),
    Parameter("reading", "1", "code of the reading, in the order of sensors.law.READINGS_OF_LAWS"),
    Parameter("regressor_1", "1", "code of the first regressor, in the order of physics.regressors.REGRESSORS"),
    Parameter("power_1", "1", "power of its amount", 1.0),
    Parameter("signed_1", "1", "1 if the power keeps its sign, else 0", 1.0),
    Parameter("regressor_2", "1", "code of the second regressor"),
    Parameter("power_2", "1", "power of its amount", 1.0),
    Parameter("signed_2", "1", "1 if the power keeps its sign, else 0", 1.0),
)
SENSOR_LAWS: dict[str, tuple[Parameter, ...]] = {"sensor_law_1": LAW_OF_READING, "sensor_law_2": LAW_OF_READING}
