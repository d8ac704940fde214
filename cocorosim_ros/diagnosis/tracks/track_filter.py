"""The filter over one track: passes, slopes, smoothed and free courses, each under a row of numbers."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from cocorosim_ros.diagnosis.filter.covariance import GATE
from cocorosim_ros.diagnosis.filter.filter import filter_pass, slope_pass
from cocorosim_ros.diagnosis.filter.motion import run_free
from cocorosim_ros.diagnosis.filter.records import (
    Belief,
    History,
    PassNumbers,
    Past,
    Readings,
    SlopeNumbers,
    Start,
    Stretch,
)
from cocorosim_ros.diagnosis.filter.smoother import smooth
from cocorosim_ros.diagnosis.tracks.actuation import Actuation
from cocorosim_ros.diagnosis.tracks.columns import READING_COLUMNS, SENSORS, WATER
from cocorosim_ros.diagnosis.tracks.passes import COURSE_SIZE, Pass, Smoothed
from cocorosim_ros.diagnosis.tracks.reading_laws import law_shift, without_laws
from cocorosim_ros.diagnosis.tracks.timeline import Timeline
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.blocks import HORIZONTAL, VERTICAL
from cocorosim_ros.world.terms.course import Course

NO_PUSH = np.zeros((0, 4))


def _blank_history(points: int) -> History:
    means = [np.zeros((points, 16)) for _ in range(2)]
    wide, high = ([np.zeros((points, size, size)) for _ in range(3)] for size in (HORIZONTAL, VERTICAL))
    return History(*means, *wide, *high)


class TrackFilter:
    """The extended Kalman filter of filter.filter, given the readings of a timeline and the forces of an actuation.

    course: along which laws of readings are taken; None: the one that the first row with such laws leads to.
    """

    def __init__(
        self, timeline: Timeline, actuation: Actuation, start: Start, course: Course | None = None
    ) -> None:  # fmt: skip
        self.timeline, self.actuation, self.start = timeline, actuation, start
        self._course = course

    def over(self, timeline: Timeline, actuation: Actuation) -> TrackFilter:
        """The same filter over other readings and forces of the same robot."""
        return TrackFilter(timeline, actuation, self.start, self._course)

    def full(self, row: Floats) -> Pass:
        """The filter's pass: likelihood, innovations, gains."""
        innovation, variance, gain, _ = self._believe(row, _blank_history(0))
        sound = (variance > 0.0) & np.isfinite(variance) & np.isfinite(innovation)
        if not sound.all():  # numbers under which the model cannot be run
            innovation, variance = np.where(sound, innovation, 0.0), np.where(sound, variance, 1.0)
        squared = innovation**2 / variance
        likelihood = -0.5 * float(np.sum(squared + np.log(2.0 * math.pi * variance))) if sound.all() else -math.inf
        return Pass(innovation, variance, gain, squared < GATE * GATE * (1.0 - 1e-9), likelihood)

    def smoothed(self, row: Floats) -> Smoothed:
        """The most likely course given all readings, before and after each moment."""
        grid = self.timeline.grid
        mean, spread = smooth(self._believe(row, _blank_history(grid.points)).history)
        return Smoothed(grid.moments, mean[:, :COURSE_SIZE], spread[:, :COURSE_SIZE])

    def free_run(self, row: Floats, start: Floats, first: int, points: int, push: Floats = NO_PUSH) -> Floats:
        """(points, 8) the model's own course from `start` (8,) at grid point `first`, no reading heeded.

        push (points, 4): random force, world x, y, z [N] and moment [N m], that acts beside the model.
        """
        grid = self.timeline.grid
        drive, body = self.actuation.drive(row), self.actuation.vehicle.body(row)
        path: Floats = run_free(drive, start, body, grid, Stretch(first, points), push)
        return path

    def slope(self, row: Floats, past: Pass, step: float, slope: Floats) -> None:
        """Write (m,) how the innovations of a pass change, gains held, by the number that is `step` off in this row.

        0 where the past pass did not believe the reading.
        """
        numbers = SlopeNumbers(row[SENSORS], np.exp(row[WATER]), step)
        kept = Past(past.innovation, past.gain, past.believed)
        body = self.actuation.vehicle.body(row)
        slope_pass(self.readings(row), self.actuation.drive(row), self.start.mean, body, numbers, kept, slope)

    def _believe(self, row: Floats, kept: History) -> Belief:
        count = len(self.timeline.kind)
        belief = Belief(np.empty(count), np.empty(count), np.zeros((count, HORIZONTAL)), kept)
        numbers = PassNumbers(row[SENSORS], np.exp(row[WATER]), np.exp(2.0 * row[READING_COLUMNS]))
        body = self.actuation.vehicle.body(row)
        filter_pass(self.readings(row), self.actuation.drive(row), self.start, body, numbers, belief)
        return belief

    def readings(self, row: Floats) -> Readings:
        """The readings on the grid, at the moments of which they tell, less what laws of readings in the row add."""
        found = self.timeline.under(row)
        shift = law_shift(row, found, self._course_of(row))
        return found if shift is None else found._replace(value=found.value - shift)

    def law_shift(self, row: Floats) -> Floats:
        """(m,) what laws of readings in this row add, in the order of the timeline."""
        found, shift = self.timeline.under(row), np.zeros(len(self.timeline.kind))
        added = law_shift(row, found, self._course_of(row))
        if added is not None:
            shift[found.origin] = added
        return shift

    def _course_of(self, row: Floats) -> Callable[[], Course]:
        """What laws of readings depend on, if it is asked for: as the first model that asks saw the robot swim."""

        def course() -> Course:
            if self._course is None:
                plain = without_laws(row)
                self._course = self.actuation.course_along(self.smoothed(plain), plain)
            return self._course

        return course
