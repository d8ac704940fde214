"""State of a robot when its recording began, from the first readings."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import START
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.filter.layout import COMPASS, KINDS_OF_STREAM, POSE_X, POSE_Y, POSE_YAW, POSE_Z, PRESSURE
from cocorosim_ros.diagnosis.filter.records import Start
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE, SURFACE_PRESSURE
from cocorosim_ros.world.state.state import HEAVE, STATE_SIZE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z


def start_of(vehicle: VehicleModel, log: RobotLog, begin: float) -> Start:
    """Guess the state at the first grid point, and its standard deviation, from readings soon after `begin` [s].

    Numbers that no reading shows are 0; speeds are uncertain by what full thrust may reach.
    """
    first = first_values(log, begin, START.window)
    mean, spread = np.zeros(STATE_SIZE), np.full(STATE_SIZE, 1.0)
    mean[X], mean[Y] = first.get(POSE_X, 0.0), first.get(POSE_Y, 0.0)
    height = -(first[PRESSURE] - SURFACE_PRESSURE) / PASCAL_PER_METRE if PRESSURE in first else 0.0
    mean[Z] = first.get(POSE_Z, height)
    mean[YAW] = first.get(POSE_YAW, first.get(COMPASS, 0.0))
    spread[X] = spread[Y] = spread[Z] = START.place
    spread[YAW] = START.yaw
    force, moment = vehicle.force_scale[0], vehicle.force_scale[3]
    speed = max(START.least_speed, math.sqrt(force / vehicle.mass) * START.speed_share)
    spread[SURGE] = spread[SWAY] = spread[HEAVE] = speed
    spread[YAW_RATE] = max(START.least_turn, math.sqrt(moment / vehicle.yaw_inertia))
    return Start(mean, spread)


def first_values(log: RobotLog, begin: float, window: float) -> dict[int, float]:
    """First value by kind within `window` [s] from `begin` [s]; of a stream that is silent there, its next one."""
    found: dict[int, float] = {}
    for name, kinds in KINDS_OF_STREAM.items():
        if name not in log.streams:
            continue
        stream = log.streams[name]
        near = (stream.time >= begin) & (stream.time <= begin + window)
        for column, kind in enumerate(kinds):
            values = stream.value[near, column] if near.any() else stream.value[stream.time >= begin, column][:1]
            values = values[np.isfinite(values)]
            if len(values):
                found[kind] = float(values[0])
    return found
