"""Random force that is greater at speed or under thrust: a score on squared innovations.

The likelihood has one random force that is the same at all times. Where the water pushes more at speed, what acts at
speed gains evidence by chance. The squared innovations over their variances, s^2, tell: if the variance is
1 + growth w, with w a quantity less its mean over its standard deviation, the score for growth at 0 is
sum((s^2 - mean s^2) w), and its estimate that over mean s^2 sum(w^2).
Source: Breusch and Pagan, Econometrica 47 (1979) 1287; with squares for the variance, Koenker, J. Econometrics 17
(1981) 107.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.showing import UNEVEN
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import VELOCITIES
from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.growing_force import GROWS_WITH, speed_and_thrust
from cocorosim_ros.diagnosis.tracks.passes import Pass, Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats

WITH = tuple(GROWS_WITH)
OF_MOTION = tuple(number for number, name in enumerate(KIND_NAMES) if name.startswith(("pose", *VELOCITIES, "gyro")))


class Uneven(NamedTuple):
    """A quantity with which the random force grows: by what share of its variance for each standard deviation of it."""

    quantity: str
    growth: float


def uneven_noise(tracks: Sequence[Track], passes: Sequence[Pass], courses: Sequence[Smoothed]) -> tuple[Uneven, ...]:
    """List the quantities with which innovations grow clearly and by much; passes, courses: of the tracks, in order."""
    sums = np.zeros((len(WITH), 3))
    for track, passed, course in zip(tracks, passes, courses, strict=True):
        for kind in OF_MOTION:
            chosen = (track.timeline.kind == kind) & passed.believed
            if np.count_nonzero(chosen) >= UNEVEN.fewest:
                squares = passed.innovation[chosen] ** 2 / passed.variance[chosen]
                sums += _sums(squares, _quantities(track, course, track.timeline.stamp[chosen]))
    return tuple(
        Uneven(name, score / size)
        for name, (score, spread, size) in zip(WITH, sums.tolist(), strict=True)
        if size > 0.0 and score > UNEVEN.growth * size and score > UNEVEN.clear * np.sqrt(spread)
    )


def growth_remarks(fit: Fit) -> tuple[str, ...]:
    """Sentences on the growth of the random force that a fit reckons with, one for each robot and quantity."""
    return tuple(
        f"The random force on {', '.join(unknown.owner.robots)} grows with {quantity}: what comes in at the highest "
        f"{quantity} is {math.hypot(1.0, math.exp(unknown.value(q))):.2g} times as strong as at rest; evidence is "
        "weighed with that."
        for quantity, column in GROWS_WITH.items()
        for unknown, q in zip(fit.noise, fit.q_noise.tolist(), strict=True)
        if unknown.column == column
    )


def _quantities(track: Track, course: Smoothed, stamp: Floats) -> Floats:
    """Speed and thrust (n, 2) at stamps (n,) [s], each less its mean over its standard deviation."""
    along = speed_and_thrust(track, course)
    seen = np.column_stack([np.interp(stamp, course.time, each) for each in along.T])
    spread = seen.std(axis=0)
    return np.asarray((seen - seen.mean(axis=0)) / np.where(spread > 0.0, spread, np.inf))


def _sums(squares: Floats, along: Floats) -> Floats:
    """Score, its variance and its size for a growth of one, by quantity: (quantities, 3).

    Innovations that are exactly zero, as of a depth that never changes, tell nothing.
    """
    if not squares.any():
        return np.zeros((along.shape[1], 3))
    off = squares / squares.mean() - 1.0
    return np.column_stack([off @ along, (off**2) @ along**2, (along**2).sum(axis=0)])
