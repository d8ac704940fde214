"""A log of the speed over ground that is wrong by a factor along all axes, as one through the water may be."""

from __future__ import annotations

from dataclasses import replace

from cocorosim_ros.world.sensors.errors.speed_log_scale import scaled_log

GROUND_LOG_SCALE = replace(
    scaled_log("ground_velocity", "log of the speed over ground that is wrong by a factor", "speed over ground"),
    where_recorded=True,
)
