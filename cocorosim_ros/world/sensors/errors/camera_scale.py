"""A camera whose lengths are wrong by a factor: shown = scale * place. It is of a recording, not of a simulation."""

from __future__ import annotations

from cocorosim_ros.world.sensors.sensor import MostError
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, multiplied, multiplied_slope
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import MEASURE
from cocorosim_ros.world.terms.search import Search, Strength

CAMERA_SCALE = SensorError(
    summary="camera lengths that are wrong by a factor",
    equation="reading = scale * place",
    parameters=(
        Number(
            "scale",
            "1",
            "lengths as seen over lengths",
            1.0,
            "positive",
            multiplies="m",
            gives="m",
            search=Strength(large=0.05),
            example=Example(1.02, "ruler in the picture"),
        ),
    ),
    sensor="pose",
    changes=tuple(Change(kind, ("scale",), multiplied, multiplied_slope) for kind in ("pose_x", "pose_y", "pose_z")),
    against="x",
    most_error=MostError(0.1, 0.35),  # calibrated in air behind a flat window: refraction makes it a third
    search=Search(channel="pose", group=MEASURE, topic="pose", manoeuvre="ruler"),
    check="Measure a known length in the camera's picture, at the depth where the robots swim.",
)
