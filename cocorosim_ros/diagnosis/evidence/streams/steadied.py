"""Velocities without most of the noise of their readings, for forces that are computed of them and of their rates."""

from __future__ import annotations

import numpy as np
from scipy.signal import savgol_filter

from cocorosim_ros.diagnosis.criteria.evidence import TILT
from cocorosim_ros.diagnosis.evidence.streams.noise import noise_of
from cocorosim_ros.diagnosis.evidence.streams.velocities import Velocities
from cocorosim_ros.foundation.arrays import Floats, Integers

ORDER = 2  # of the polynomial through neighbours


def steadied(seen: Velocities) -> Velocities:
    """Put a parabola through the neighbours of each velocity, over the longest time that leaves noise alone.

    Each part has a time of its own, among TILT.steadied; where none is short enough, it stays as it was read. Nothing
    is taken from beyond a pause. Source: Savitzky and Golay, Anal. Chem. 36 (1964) 1627.
    """
    if len(seen.time) < TILT.fewest:
        return seen
    gap = float(np.median(np.diff(seen.time)))
    if not gap > 0.0:
        return seen
    pauses = np.flatnonzero(np.diff(seen.time) > TILT.pause * gap) + 1
    return Velocities(seen.time, np.column_stack([_steady(seen.time, part, gap, pauses) for part in seen.value.T]))


def _steady(time: Floats, part: Floats, gap: float, pauses: Integers) -> Floats:
    """One part (n,) of velocities, gap [s] between its readings; pauses: numbers of the first readings behind them."""
    noise = noise_of(time, part)
    for span in TILT.steadied:
        width = 2 * int(0.5 * span / gap) + 1
        if width < TILT.fewest_smoothed:
            break
        smooth = _by_parabolas(part, width, pauses)
        if float(np.sqrt(np.mean((part - smooth) ** 2))) < TILT.noise_alone * noise:
            return smooth
    return part


def _by_parabolas(part: Floats, width: int, pauses: Integers) -> Floats:
    """A part with parabolas through `width` neighbours; a piece that is shorter stays as it is."""
    pieces = np.split(part, pauses)
    return np.concatenate([savgol_filter(each, width, ORDER) if len(each) >= width else each for each in pieces])
