"""Regimes of a recording: what tells one part of it from another, and by how much two parts differ in it."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUNS
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import HEAVE, SURGE, YAW_RATE, X, Z


class Quantity(NamedTuple):
    """Quantity that tells one regime from another; not said where another one says as much already."""

    name: str
    unit: str
    unless: str = ""


QUANTITIES = (
    Quantity("speed", "m/s"),
    Quantity("turn rate", "rad/s"),
    Quantity("thrust", "N"),
    Quantity("depth", "m"),
    Quantity("thrust ahead", "N", unless="thrust"),
    Quantity("turn to the left", "rad/s", unless="turn rate"),
    Quantity("share of time under thrust", "1", unless="thrust"),
)
DEPTH = [quantity.name for quantity in QUANTITIES].index("depth")


def regimes_along(track: Track, course: Smoothed) -> Floats:
    """Values (points, quantities) of QUANTITIES along a smoothed course, with the platform's own thrust."""
    state, drive = course.mean, track.actuation.drive(track.vehicle.row)
    is_thruster = track.vehicle.is_thruster  # of the actuators, before what roll and pitch add
    thrust = np.linalg.norm(drive.force[:, : len(is_thruster)][:, is_thruster], axis=1)
    return np.column_stack(
        [
            np.linalg.norm(state[:, SURGE : HEAVE + 1], axis=1),
            np.abs(state[:, YAW_RATE]),
            thrust,
            -state[:, Z],
            track.actuation.thrust(drive)[:, X],
            state[:, YAW_RATE],
            thrust > FREE_RUNS.off * thrust.max(initial=0.0),
        ]
    )


def unlikeness(one: Floats, other: Floats) -> float:
    """Largest difference between the means of two parts (n, quantities), (m, quantities), in standard deviations.

    The standard deviation is that of both parts together. Depth counts less, quantities that hardly vary for nothing.
    Infinite where one of them is empty: what holds out nothing, or all, is worse than any other choice.
    """
    both = np.concatenate([one, other])
    if not len(one) or not len(other):
        return math.inf
    spread = both.std(axis=0)
    varies = spread > FREE_RUNS.steady * np.abs(both).max(axis=0)
    apart = np.abs(one.mean(axis=0) - other.mean(axis=0)) / np.where(varies, spread, np.inf)
    apart[DEPTH] *= FREE_RUNS.of_depth
    return float(apart.max())
