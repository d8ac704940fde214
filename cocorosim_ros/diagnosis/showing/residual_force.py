"""The force that a model lacks, over time: the random force of the water as the smoother sees it, in body axes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.findings import ResidualForce
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats


def residual_forces(fit: Fit, courses: Sequence[Smoothed]) -> tuple[ResidualForce, ...]:
    """Of every track."""
    return tuple(_of(track, row, course) for track, row, course in zip(fit.tracks, fit.filled, courses, strict=True))


def _of(track: Track, row: Floats, course: Smoothed) -> ResidualForce:
    mean, spread = course.mean, course.spread
    sine, cosine = np.sin(mean[:, 3]), np.cos(mean[:, 3])
    force = np.column_stack(
        [mean[:, 8] * cosine + mean[:, 9] * sine, mean[:, 9] * cosine - mean[:, 8] * sine, mean[:, 10], mean[:, 11]]
    )
    across = np.sqrt((spread[:, 8] * cosine) ** 2 + (spread[:, 9] * sine) ** 2)
    aside = np.sqrt((spread[:, 9] * cosine) ** 2 + (spread[:, 8] * sine) ** 2)
    wide = np.column_stack([across, aside, spread[:, 10], spread[:, 11]])
    drive = track.actuation.drive(row)
    thrust, pump = track.actuation.thrust(drive), track.actuation.pump_force(drive)
    regressors = {"thrust": thrust[:, 0], "yaw_command": thrust[:, 3], "pump": pump}
    return ResidualForce(track.name, course.time, force, wide, mean[:, :4], mean[:, 4:8], regressors)
