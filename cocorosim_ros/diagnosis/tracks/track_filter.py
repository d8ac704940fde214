"""The filter over one track: passes, slopes, smoothed courses and free runs, each under a row of numbers."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from cocorosim_ros.diagnosis.criteria.filter import FILTER
from cocorosim_ros.diagnosis.filter.coloured import shares_left
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
from cocorosim_ros.diagnosis.tracks.agitation import Agitation
from cocorosim_ros.diagnosis.tracks.columns import MEMORY_COLUMNS, READING_COLUMNS, SENSORS, TIMING, WATER
from cocorosim_ros.diagnosis.tracks.lately import Lately
from cocorosim_ros.diagnosis.tracks.passes import COURSE_SIZE, Pass, Smoothed
from cocorosim_ros.diagnosis.tracks.reading_laws import law_shift, without_laws
from cocorosim_ros.diagnosis.tracks.start import Beginning
from cocorosim_ros.diagnosis.tracks.timeline import Timeline
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.terms.blocks import HORIZONTAL, VERTICAL
from cocorosim_ros.world.terms.course import Course

NO_PUSH = np.zeros((0, 4))
NO_SWELL = np.zeros(0)
KEPT_PASSES = 2
"""Passes that are kept: of a fit, and of the last trial around it."""
KEPT_SHARES = 2
"""Shares of errors that are kept: of a model, and of the same with another memory or stamps."""
KEPT_COURSES = 2
"""Smoothed courses that are kept: of the recalibrated model, and of the one with all its effects."""


def _blank_history(points: int) -> History:
    """Make the arrays into which a pass writes its history; empty ones, 0 points, for a pass without history."""
    means = [np.zeros((points, 16)) for _ in range(2)]
    wide, high = ([np.zeros((points, size, size)) for _ in range(3)] for size in (HORIZONTAL, VERTICAL))
    return History(*means, *wide, *high)


class TrackFilter:
    """The extended Kalman filter of filter.filter, given the readings of a timeline and the forces of an actuation.

    course: smoothed course along which laws of readings are taken; None: it is made when a row with such laws is first
    used, under that row without them. agitation: what the random force grows with, None for nothing. Rows are
    (columns,), SI units, by tracks.columns.
    """

    def __init__(
        self, timeline: Timeline, actuation: Actuation, beginning: Beginning, course: Course | None = None,
        agitation: Agitation | None = None,
    ) -> None:  # fmt: skip
        self.timeline, self.actuation, self.beginning = timeline, actuation, beginning
        self._course, self._agitation = course, agitation
        self._passes: Lately[Pass] = Lately(KEPT_PASSES)
        self._left: Lately[Floats] = Lately(KEPT_SHARES)
        self._courses: Lately[Smoothed] = Lately(KEPT_COURSES)
        self._starts: Lately[Start] = Lately()

    def over(self, timeline: Timeline, actuation: Actuation, beginning: Beginning | None = None) -> TrackFilter:
        """Copy the filter for other readings, forces and, if given, another beginning of the same robot."""
        return TrackFilter(timeline, actuation, beginning or self.beginning, self._course, self._agitation)

    def agitated(self, agitation: Agitation) -> TrackFilter:
        """Copy the filter with what the random force may grow with."""
        return TrackFilter(self.timeline, self.actuation, self.beginning, self._course, agitation)

    def lately(self, row: Floats) -> Pass:
        """Return what `full` does, without running the filter again where the same row was asked for just before.

        Steps of the numbers of one robot leave the rows of all others as they were.
        """
        return self._passes.once(row.tobytes(), lambda: self.full(row))

    def full(self, row: Floats, with_gains: bool = True) -> Pass:
        """Run the filter: likelihood, innovations and gains, in the order of the timeline.

        Where the model runs away, the likelihood is minus infinity. Gains (0, HORIZONTAL) are left out where no slopes
        will be asked for: they are most of what a pass writes.
        """
        innovation, variance, gain, _ = self._believe(row, _blank_history(0), with_gains)
        sound = (variance > 0.0) & np.isfinite(variance) & np.isfinite(innovation)
        if not sound.all():  # numbers under which the model cannot be run
            innovation, variance = np.where(sound, innovation, 0.0), np.where(sound, variance, 1.0)
        with np.errstate(over="ignore"):  # a model that is far off has no likelihood, and that is no surprise
            squared = innovation**2 / variance
        likelihood = -0.5 * float(np.sum(squared + np.log(2.0 * math.pi * variance))) if sound.all() else -math.inf
        return Pass(innovation, variance, gain, squared < GATE * GATE * (1.0 - FILTER.rounding), likelihood)

    def smoothed(self, row: Floats) -> Smoothed:
        """Smooth: the most likely state at each grid point given all readings, later ones too.

        The last courses are kept, since several stages ask for that of the same model.
        """
        return self._courses.once(row.tobytes(), lambda: self._smoothed(row))

    def _smoothed(self, row: Floats) -> Smoothed:
        grid = self.timeline.grid
        mean, spread = smooth(self._believe(row, _blank_history(grid.points)).history)
        return Smoothed(grid.moments, mean[:, :COURSE_SIZE], spread[:, :COURSE_SIZE])

    def filtered(self, row: Floats) -> Floats:
        """States (points, STATE_SIZE) at each grid point, given the readings up to that point and no later ones."""
        after: Floats = self._believe(row, _blank_history(self.timeline.grid.points)).history.after
        return after[:, :STATE_SIZE]

    def free_run(self, row: Floats, start: Floats, first: int, points: int, push: Floats = NO_PUSH) -> Floats:
        """Free run of the model: states (points, 8) from `start` (8,) at grid point `first`, without readings.

        push (points, 4): random force that acts beside the model [N, N, N, N m; world]; none without it.
        """
        grid = self.timeline.grid
        drive, body = self.actuation.drive(row), self.actuation.vehicle.body(row)
        path: Floats = run_free(drive, start, body, grid, Stretch(first, points), push)
        return path

    def slope(self, row: Floats, past: Pass, step: float, slope: Floats) -> None:
        """Write into `slope` (m,) the derivative of the innovations of the pass `past` by one unknown, gains held.

        row: the numbers of that pass, but for the unknown, of which q is `step` off. The derivative is 0 for readings
        beyond the gate.
        """
        numbers = SlopeNumbers(row[SENSORS], np.exp(row[WATER]), self._shares_left(row), step)
        kept = Past(past.innovation, past.gain, past.believed)
        body = self.actuation.vehicle.body(row)
        start = self.start(row)
        slope_pass(self.readings(row), self.actuation.drive(row), start.mean, body, numbers, kept, slope)

    def slope_with_gains(self, row: Floats, past: Pass, step: float, slope: Floats) -> None:
        """Write into `slope` (m,) what `slope` does, but gains not held: they are those under the row.

        For numbers by which a reading depends otherwise on the state, as a scale: the gains then change as much as the
        reading does. Held, they pass on a share of each innovation to the next one: a slope of mere noise, and an
        information that is up to thirty times too great.
        """
        slope[:] = past.change_to(self.full(row, with_gains=False), self.timeline.is_angle) / step

    def _believe(self, row: Floats, kept: History, with_gains: bool = False) -> Belief:
        """Run the filter under a row of numbers, and keep the states in `kept` if it is not empty."""
        count = len(self.timeline.kind)
        gain = np.zeros((count if with_gains else 0, HORIZONTAL))
        belief = Belief(np.empty(count), np.empty(count), gain, kept)
        swell = self._agitation.variance(row, self.timeline.grid.moments) if self._agitation else NO_SWELL
        variance = np.exp(2.0 * row[READING_COLUMNS])
        numbers = PassNumbers(row[SENSORS], np.exp(row[WATER]), variance, self._shares_left(row), swell)
        body = self.actuation.vehicle.body(row)
        filter_pass(self.readings(row), self.actuation.drive(row), self.start(row), body, numbers, belief)
        return belief

    def start(self, row: Floats) -> Start:
        """Start under the errors of sensors in a row; slopes by most numbers ask for the same one again."""
        return self._starts.once(row[SENSORS].tobytes(), lambda: self.beginning.under(row[SENSORS]))

    def _shares_left(self, row: Floats) -> Floats:
        """Shares (m,) of errors that are left of those before, in the order of `readings` under the same row."""
        key = row[TIMING].tobytes(), row[MEMORY_COLUMNS].tobytes()
        return self._left.once(key, lambda: shares_left(self.timeline.under(row), np.exp(row[MEMORY_COLUMNS])))

    def readings(self, row: Floats) -> Readings:
        """Readings on the grid, stamps corrected and the errors by laws of readings taken off, as the row has both."""
        found = self.timeline.under(row)
        shift = law_shift(row, found, self._course_of(row))
        return found if shift is None else found._replace(value=found.value - shift)

    def law_shift(self, row: Floats) -> Floats:
        """Errors (m,) that laws of readings in the row add, in the order of the timeline and the units of readings."""
        found, shift = self.timeline.under(row), np.zeros(len(self.timeline.kind))
        added = law_shift(row, found, self._course_of(row))
        if added is not None:
            shift[found.origin] = added
        return shift

    def _course_of(self, row: Floats) -> Callable[[], Course]:
        """Make a function that returns the quantities that laws of readings depend on, by time.

        The course is smoothed at its first call, under the row without such laws, and the same for all later rows.
        """

        def course() -> Course:
            if self._course is None:
                plain = without_laws(row)
                self._course = self.actuation.course_along(self.smoothed(plain), plain)
            return self._course

        return course
