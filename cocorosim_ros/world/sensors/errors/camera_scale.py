"""A camera whose lengths are wrong by a factor: shown = scale * place. It is of a recording, not of a simulation."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError


@kernel
def shown(value: float, truth: float, stamp: float, scale: float) -> float:
    """Coordinate [m] in place of `value`."""
    return scale * value


@kernel
def slope(row: Floats, scale: float) -> float:
    """Derivative of what is shown by the place."""
    return scale


CAMERA_SCALE = SensorError(
    summary="the camera's lengths are wrong by a factor",
    parameters=(Parameter("scale", "1", "lengths as seen over lengths", 1.0, "positive"),),
    sensor="pose",
    changes=tuple(Change(kind, ("scale",), shown, slope) for kind in ("pose_x", "pose_y", "pose_z")),
    against="x",
)
