"""Evidence for a pump's own behaviour counts only where the pump was moved by more than the water could ask for.

Whoever holds a depth moves the pump a little in answer to what the water does, and may see it sooner or better than
the sensors that were recorded. Such a command tells of the water, and then an innocent pump looks weak or late, and an
innocent pressure sensor late: likelihoods given the commands hold only for commands that follow from what was recorded
(Ljung, System Identification, 1999, section 13.4). A pulse, a ramp or a new depth moves the pump by far more than the
water does.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import maximum_filter1d, minimum_filter1d

from cocorosim_ros.diagnosis.criteria.naming import PUMP
from cocorosim_ros.diagnosis.filter.layout import ACCEL_Z, POSE_Z, PRESSURE, VELOCITY_W
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Flags, Floats

UPRIGHT = (POSE_Z, PRESSURE, ACCEL_Z, VELOCITY_W)


def quiet_gain(base: Fit, more: Fit) -> float:
    """Nats that `more` gains over `base` on vertical readings while the pump was hardly moved, if it gains any."""
    gain = 0.0
    rows = more.filled  # a pump's fault that is not yet in the model passes for random force there
    for track, row, one, other in zip(base.tracks, rows, base.passes, more.passes, strict=True):
        chosen = np.isin(track.timeline.kind, UPRIGHT) & ~_is_loud(track, row)
        gain += float(np.sum((_nats(other) - _nats(one))[chosen]))
    return max(gain, 0.0)


def _is_loud(track: Track, row: Floats) -> Flags:
    """(m,) whether the force of the pumps has changed much in the time before each reading."""
    force = track.actuation.pump_force(track.actuation.drive(row))
    grid = track.timeline.grid
    width = max(1, round(PUMP.memory / grid.step))
    back = {"size": width, "origin": (width - 1) // 2, "mode": "nearest"}  # the window ends at each point
    change = maximum_filter1d(force, **back) - minimum_filter1d(force, **back)
    loud = change > PUMP.loud * np.exp(row[COLUMN["random.heave_force"]])
    point = np.rint((track.timeline.stamp - grid.begin) / grid.step).astype(np.int64)
    return np.asarray(loud[np.clip(point, 0, len(loud) - 1)])


def _nats(passed: Pass) -> Floats:
    """(m,) log-likelihood of each reading, up to a constant."""
    return np.asarray(-0.5 * (passed.innovation**2 / passed.variance + np.log(passed.variance)))
