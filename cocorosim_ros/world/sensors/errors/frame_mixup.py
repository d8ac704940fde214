"""Axes, signs or units of a stream that are mixed up: found and put right before any physics is, by evidence.frames.

It has no numbers: a platform file says it in words, below `frame_corrections`.
"""

from __future__ import annotations

from cocorosim_ros.world.sensors.sensor_error import SensorError

FRAME_MIXUP = SensorError(
    summary="axes, signs or units that are mixed up",
    parameters=(),
    check="Axes, signs and units of the driver of this stream; correct them there or in `cocorosim convert`.",
)
