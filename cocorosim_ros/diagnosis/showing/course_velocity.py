"""Velocities along the smoothed courses of a model."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.findings import CourseVelocity
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.body_velocity import body_velocity
from cocorosim_ros.diagnosis.tracks.passes import Smoothed


def course_velocities(fit: Fit, courses: Sequence[Smoothed]) -> tuple[CourseVelocity, ...]:
    """Velocity of every track of a fit over its whole recording; courses: the smoothed course of each track."""
    return tuple(
        CourseVelocity(track.name, course.time, body_velocity(track, course.time, course.mean, row), track.log.clock)
        for track, row, course in zip(fit.tracks, fit.filled, courses, strict=True)
    )
