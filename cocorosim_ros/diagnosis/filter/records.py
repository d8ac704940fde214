"""Input and output of the filter."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers


class Grid(NamedTuple):
    """The grid points of a filter, evenly spaced."""

    begin: float  # s
    step: float  # s
    points: int

    @property
    def moments(self) -> Floats:
        """(points,) [s]."""
        return self.begin + self.step * np.arange(self.points, dtype=np.float64)

    @property
    def duration(self) -> float:
        """Time from the first point to the last [s]."""
        return self.step * (self.points - 1)


class Readings(NamedTuple):
    """The readings of one robot in the order of the grid points next to them."""

    step: float  # s between grid points
    begin: float  # s, time of grid point 0
    first: Integers  # (points + 1,) first reading of each grid point
    kind: Integers  # (m,)
    after: Floats  # (m,) s after the grid point, may be negative
    apart: Floats  # (m,) s from the grid point, mean of averaged readings
    side: Floats  # (m,) -1 before the grid point, 1 behind it, mean of averaged readings
    stamp: Floats  # (m,) s, as it stands in the recording
    value: Floats  # (m,)
    share: Floats  # (m,) variance as a share of that of a single reading of its kind
    origin: Integers  # (m,) place of each in the order of the track, which is that of all results
    before: Integers  # (m,) place in this order of the reading of its kind before it; -1 where none is near
    gap: Floats  # (m,) s between these two


class When(NamedTuple):
    """The moment of a reading, and how it lies to the grid point next to it."""

    stamp: float  # s, as it stands in the recording
    after: float  # s after the grid point, may be negative
    apart: float  # s from the grid point, mean of averaged readings
    side: float  # -1 before the grid point, 1 behind it, mean of averaged readings


class Rates(NamedTuple):
    """Rates of the state at a grid point, (8,) each."""

    mean: Floats  # of the rates on both sides of it
    leap: Floats  # by how much the rate is greater behind it


class Drive(NamedTuple):
    """Forces and neighbours that act on the robot from each grid point to the next."""

    force: Floats  # (points, A) mean force of every actuator [N]
    rate: Floats  # (points, A) rate of change of the force [N/s]
    around: Floats  # (points, robots, NEIGHBOUR_SIZE) all robots as neighbours feel them; (1, 0, ...) if none does


class History(NamedTuple):
    """State at every grid point, before and after its readings: x y z yaw u v w r, force x y z, moment, their gusts."""

    before: Floats  # (points, 16)
    after: Floats  # (points, 16)
    wide_before: Floats  # (points, HORIZONTAL, HORIZONTAL) covariance of the horizontal block
    wide_after: Floats
    wide_step: Floats  # (points, HORIZONTAL, HORIZONTAL) transition from the grid point before
    high_before: Floats  # (points, VERTICAL, VERTICAL) covariance of the vertical block
    high_after: Floats
    high_step: Floats


class Start(NamedTuple):
    """The state at grid point 0, columns of world.state.state."""

    mean: Floats  # (8,)
    spread: Floats  # (8,) standard deviation


class PassNumbers(NamedTuple):
    """The numbers of a model beside its physics, for a pass of the filter."""

    sensor: Floats  # by SENSOR_COLUMNS
    random_force: Floats  # by WATER_NOISE and WANDER, no logarithms
    reading_variance: Floats  # (KINDS,) of a single reading of each kind
    left: Floats  # (m,) share of the error of the reading before that is still in each, in the order of the grid
    swell: Floats  # (points,) factors of the random force's variance; empty if it is the same at all times


class SlopeNumbers(NamedTuple):
    """The numbers of a model beside its physics, for a slope by one number."""

    sensor: Floats  # by SENSOR_COLUMNS
    random_force: Floats  # by WATER_NOISE and WANDER, no logarithms
    left: Floats  # (m,) share of the error of the reading before that is still in each, in the order of the grid
    step: float  # by which the number is off


class Stretch(NamedTuple):
    """Some grid points behind each other."""

    first: int
    points: int


class Belief(NamedTuple):
    """Results of the filter for each reading, and for each grid point."""

    innovation: Floats  # (m,)
    variance: Floats  # (m,) of the innovation
    gain: Floats  # (m, HORIZONTAL), vertical readings use the first four; empty if not wanted
    history: History  # empty if not wanted


class Past(NamedTuple):
    """Results of a pass of the filter that a pass for slopes needs, by reading."""

    innovation: Floats  # (m,)
    gain: Floats  # (m, HORIZONTAL)
    believed: Flags  # (m,) innovations within the gate
