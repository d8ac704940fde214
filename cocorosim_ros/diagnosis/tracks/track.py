"""One robot in one recording: its log, its vehicle, its readings on a grid, and the filter over them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import pressure_per_metre
from cocorosim_ros.diagnosis.tracks.actuation import Actuation
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.grid import grid_begin, grid_step
from cocorosim_ros.diagnosis.tracks.start import beginning_of
from cocorosim_ros.diagnosis.tracks.surroundings import RecordedSurroundings
from cocorosim_ros.diagnosis.tracks.timeline import Timeline
from cocorosim_ros.diagnosis.tracks.track_filter import TrackFilter
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel, vehicle_model
from cocorosim_ros.diagnosis.tracks.vehicle_size import shortest_coasting
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform


def wanted_step(vehicle: VehicleModel, row: Floats) -> float:
    """Step [s] of the filter for a vehicle with the numbers of a row (columns,)."""
    force, inertia = vehicle.force_scale, float(row[COLUMN["yaw_inertia"]])
    pushed = float(np.linalg.norm(force[:3])) / vehicle.mass
    return grid_step(pushed, force[3] / inertia, shortest_coasting(vehicle, row))


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
        actuation = Actuation(vehicle, self.log, self.timeline.grid)
        return replace(self, vehicle=vehicle, actuation=actuation, filter=self.filter.over(self.timeline, actuation))

    def piece(self, first: int, points: int) -> Track:
        """Make a track of `points` grid points of this one, from grid point `first` on, as if it began there.

        Its state at the start is guessed from the readings there; its actuators remember what they did before.
        """
        timeline = self.timeline.between(first, points)
        around = self.vehicle.surroundings.around
        if len(around) > 1:
            around = around[first : first + points]
        vehicle = replace(self.vehicle, surroundings=self.vehicle.surroundings._replace(around=around))
        actuation = Actuation(vehicle, self.log, timeline.grid, before=first)
        beginning = beginning_of(vehicle, self.log, timeline.grid.begin)
        return Track(self.log, vehicle, timeline, actuation, self.filter.over(timeline, actuation, beginning))

    def without_stream(self, name: str) -> Track:
        """Make a track without the readings of a stream."""
        timeline = self.timeline.without_stream(name)
        return replace(self, timeline=timeline, filter=self.filter.over(timeline, self.actuation))


def make_track(platform: Platform, log: RobotLog, begin: float, end: float, found: Floats | None = None) -> Track:
    """Make the track of a robot as if alone in open water; begin, end: first and last reading [s].

    found (columns,): numbers of the robot that a fit has found, for the step of the grid; None: those of the platform.
    A platform whose numbers were found by a filter has the step of this filter.
    """
    own = platform.of_robot(log.name)
    water = pressure_per_metre(own, log)
    vehicle = replace(vehicle_model(own), tilts=log.attitude is not None, water_weight=water)
    step = own.fitted_step or wanted_step(vehicle, vehicle.row if found is None else found)
    timeline = Timeline(log, step, grid_begin(log.command_time, step, begin), end)
    actuation = Actuation(vehicle, log, timeline.grid)
    return Track(log, vehicle, timeline, actuation, TrackFilter(timeline, actuation, beginning_of(vehicle, log, begin)))
