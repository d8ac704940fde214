"""One robot in one recording: its log, its vehicle, its readings on a grid, and the filter over them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.tracks.actuation import Actuation
from cocorosim_ros.diagnosis.tracks.grid import grid_begin, grid_step
from cocorosim_ros.diagnosis.tracks.start import start_of
from cocorosim_ros.diagnosis.tracks.surroundings import RecordedSurroundings
from cocorosim_ros.diagnosis.tracks.timeline import Timeline
from cocorosim_ros.diagnosis.tracks.track_filter import TrackFilter
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel, vehicle_model
from cocorosim_ros.scenario.parts.platform import Platform


@dataclass(frozen=True)
class Track:
    """One robot in one recording, in parts that are used alone: a function takes the part that it needs."""

    log: RobotLog
    vehicle: VehicleModel
    timeline: Timeline
    actuation: Actuation
    filter: TrackFilter

    @property
    def name(self) -> str:
        """Name of the robot."""
        return self.log.name

    def among(self, surroundings: RecordedSurroundings) -> Track:
        """Copy the track into other surroundings."""
        vehicle = replace(self.vehicle, surroundings=surroundings)
        return self._with(vehicle, self.timeline)

    def until(self, share: float) -> Track:
        """Make a track of the first part of this one, up to `share` of its duration, on the same grid."""
        return self._with(self.vehicle, self.timeline.until(share))

    def _with(self, vehicle: VehicleModel, timeline: Timeline) -> Track:
        """Copy the track with another vehicle and timeline; actuation and filter follow them."""
        actuation = Actuation(vehicle, self.log, timeline.grid)
        return Track(self.log, vehicle, timeline, actuation, self.filter.over(timeline, actuation))


def make_track(platform: Platform, log: RobotLog, begin: float, end: float) -> Track:
    """Make the track of a robot as if alone in open water; begin, end: first and last reading [s]."""
    vehicle = replace(vehicle_model(platform.of_robot(log.name)), tilts=log.attitude is not None)
    force = vehicle.force_scale
    step = grid_step(float(np.linalg.norm(force[:3])) / vehicle.mass, force[3] / vehicle.yaw_inertia)
    timeline = Timeline(log, step, grid_begin(log.command_time, step, begin), end)
    actuation = Actuation(vehicle, log, timeline.grid)
    return Track(log, vehicle, timeline, actuation, TrackFilter(timeline, actuation, start_of(vehicle, log, begin)))
