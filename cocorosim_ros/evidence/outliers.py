"""Single readings that are far off those before and after them: no motion does that, a faulty sensor does."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.evidence.log import Floats
from cocorosim_ros.evidence.noise import WITHIN_ONE_SIGMA

NEIGHBOURHOOD = 5  # readings: up to two in a row are told from the other three
FAR = 12.0  # times the scale of what is usual, and the noise of a reading
MOST, STEPS = 0.95, 3.0  # quantile of the steps between readings, and how many of them are motion
RARE = 0.05  # share of the readings; what is more frequent is how this sensor is


def outliers(value: Floats, noise: float) -> NDArray[np.bool_]:
    """(n,) which readings lie farther from the median of five neighbours than noise and motion ever do.

    Where readings rise or fall steadily the median is the middle one, so that motion does not show. noise is that of a
    single reading; none are found where it is NaN.
    """
    found = np.zeros(value.shape, dtype=bool)
    given = np.flatnonzero(np.isfinite(value))
    if given.size < 4 * NEIGHBOURHOOD or not noise > 0.0:
        return found
    readings = value[given]
    padded = np.pad(readings, NEIGHBOURHOOD // 2, mode="edge")
    middle = np.median(np.lib.stride_tricks.sliding_window_view(padded, NEIGHBOURHOOD), axis=1)
    away = np.abs(readings - middle)
    usual_step = float(np.quantile(np.abs(np.diff(readings)), MOST))
    far = away > FAR * max(noise, float(np.quantile(away, WITHIN_ONE_SIGMA))) + STEPS * usual_step
    if np.mean(far) <= RARE:
        found[given[far]] = True
    return found
