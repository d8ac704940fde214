"""A log of the speed over ground that is turned about the vertical, as one through the water may be."""

from __future__ import annotations

from dataclasses import replace

from cocorosim_ros.world.sensors.errors.speed_log_misalignment import turned_log

GROUND_LOG_MISALIGNMENT = replace(
    turned_log("ground_velocity", "log of the speed over ground that is turned against the hull", "ground"),
    where_recorded=True,
)
