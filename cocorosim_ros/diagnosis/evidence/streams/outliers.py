"""Outliers: readings so far off those before and after them that no motion explains them, but a faulty sensor does."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import OUTLIERS
from cocorosim_ros.diagnosis.evidence.streams.noise import WITHIN_ONE_SIGMA
from cocorosim_ros.foundation.arrays import Flags, Floats

NEIGHBOURHOOD = 5  # readings: up to two faults in a row leave a median of the other three


def outliers(value: Floats, noise: float) -> Flags:
    """Mask (n,) of readings farther from the median of five neighbours than noise and motion ever are.

    Where readings rise or fall steadily the median is the middle one, so that motion does not show. noise: standard
    deviation of a single reading; no outliers are found where it is NaN.
    """
    found = np.zeros(value.shape, dtype=bool)
    given = np.flatnonzero(np.isfinite(value))
    if given.size < OUTLIERS.fewest or not noise > 0.0:
        return found
    readings = value[given]
    padded = np.pad(readings, NEIGHBOURHOOD // 2, mode="edge")
    middle = np.median(np.lib.stride_tricks.sliding_window_view(padded, NEIGHBOURHOOD), axis=1)
    away = np.abs(readings - middle)
    usual_step = float(np.quantile(np.abs(np.diff(readings)), OUTLIERS.most))
    far = away > OUTLIERS.far * max(noise, float(np.quantile(away, WITHIN_ONE_SIGMA))) + OUTLIERS.steps * usual_step
    if np.mean(far) <= OUTLIERS.rare:
        found[given[far]] = True
    return found


def away(time: Floats, angle: Floats, noise: float) -> Flags:
    """Mask (n,) of readings of a heading between a leap and the leap back soon after it.

    A tracker that mistakes one mark of a robot for another makes such leaps; where it takes its bow for its stern, the
    leap back may go on around. time (n,) [s], angle (n,) [rad], not wrapped. No reading is marked where there are too
    many such leaps for faults.
    """
    found = np.zeros(angle.shape, dtype=bool)
    given = np.flatnonzero(np.isfinite(angle))
    if given.size < OUTLIERS.fewest or not noise > 0.0:
        return found
    moment, heading = time[given], angle[given]
    step = np.abs(np.diff(heading))
    calm = step[step < OUTLIERS.no_motion]
    if len(calm) < OUTLIERS.mostly_calm * len(step):
        return found
    usual = float(np.quantile(calm, OUTLIERS.most))
    leaps = np.flatnonzero(step > OUTLIERS.far * noise + OUTLIERS.steps * usual)
    back = 0
    for leap in leaps:
        within = moment[leaps + 1] - moment[leap] <= OUTLIERS.longest_leap
        soon = leaps[(leaps > leap) & within] if leap >= back else leaps[:0]
        off = np.mod(heading[soon + 1] - heading[leap] + np.pi, 2.0 * np.pi) - np.pi
        near = np.abs(off) <= OUTLIERS.far * noise + usual * (soon + 1 - leap)
        if near.any():
            back = int(soon[near][0]) + 1
            found[given[leap + 1 : back]] = True
    return found if np.mean(found) <= OUTLIERS.most_away else np.zeros(angle.shape, dtype=bool)
