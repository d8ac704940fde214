"""A log of the speed over ground that is off the body's origin, as one through the water may be."""

from __future__ import annotations

from dataclasses import replace

from cocorosim_ros.world.sensors.errors.speed_log_lever import log_off_the_origin

GROUND_LOG_LEVER = replace(
    log_off_the_origin("ground_velocity", "log of the speed over ground off the body's origin"), where_recorded=True
)
