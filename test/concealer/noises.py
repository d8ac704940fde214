"""Noise of sensors beyond the white one: heavy tails, coloured noise, coarse digits, holes in every stream."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.signal import lfilter

from concealer.layout import FloatArray

Numbers = dict[str, Any]


def noise(rng: np.random.Generator, shape: tuple[int, ...], member: Numbers, time: FloatArray) -> FloatArray:
    """Independent columns of standard deviation 1 at these times [s], rows of `shape`, by a member of the family."""
    kind = member.get("kind", "white")
    if kind == "student":
        freedom = member["freedom"]
        return np.asarray(rng.standard_t(freedom, shape) / math.sqrt(freedom / (freedom - 2.0)))
    white = rng.standard_normal(shape)
    if kind != "coloured" or len(time) < 2:
        return np.asarray(white)
    memory = math.exp(-float(np.median(np.diff(time))) / member["correlation"])
    driven = math.sqrt(1.0 - memory**2) * white
    driven[0] = white[0]
    return np.asarray(lfilter([1.0], [1.0, -memory], driven, axis=0))


def in_digits(values: FloatArray, step: float) -> FloatArray:
    """Readings in whole steps; unchanged for a step of 0."""
    return np.asarray(step * np.rint(values / step)) if step else values


def left_by_holes(rng: np.random.Generator, time: FloatArray, member: Numbers) -> FloatArray:
    """(n,) whether a reading at this time [s] is there: holes at random places, so many in ten minutes."""
    keep = np.ones(len(time), dtype=bool)
    span = float(time[-1] - time[0]) if len(time) else 0.0
    for _ in range(round(member.get("holes", 0.0) * span / 600.0)):
        start = rng.uniform(0.0, span)
        keep &= (time < start) | (time > start + rng.uniform(0.0, member["hole"]))
    return keep
