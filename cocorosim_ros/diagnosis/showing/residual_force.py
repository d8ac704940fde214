"""The residual: the force that a model lacks over time, taken from the smoothed random force, in body axes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.findings import ResidualForce
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.passes import FORCE_X, FORCE_Y, FORCE_Z, YAW_MOMENT, Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import YAW


def residual_forces(fit: Fit, courses: Sequence[Smoothed]) -> tuple[ResidualForce, ...]:
    """Residual force of every track under a fit; courses: the smoothed course of each track."""
    return tuple(_of(track, row, course) for track, row, course in zip(fit.tracks, fit.filled, courses, strict=True))


def _of(track: Track, row: Floats, course: Smoothed) -> ResidualForce:
    """Turn the random force of a course (world axes) and its standard deviation to the axes of the body."""
    mean, spread = course.mean, course.spread
    sine, cosine = np.sin(mean[:, YAW]), np.cos(mean[:, YAW])
    east, north = mean[:, FORCE_X], mean[:, FORCE_Y]
    forward, left = east * cosine + north * sine, north * cosine - east * sine
    force = np.column_stack([forward, left, mean[:, FORCE_Z], mean[:, YAW_MOMENT]])
    across = np.sqrt((spread[:, FORCE_X] * cosine) ** 2 + (spread[:, FORCE_Y] * sine) ** 2)
    aside = np.sqrt((spread[:, FORCE_Y] * cosine) ** 2 + (spread[:, FORCE_X] * sine) ** 2)
    wide = np.column_stack([across, aside, spread[:, FORCE_Z], spread[:, YAW_MOMENT]])
    return ResidualForce(track.name, force, wide, track.actuation.course_along(course, row), track.log.clock)
