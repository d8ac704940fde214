"""Evidence for faults of a pump, or of thrusters upwards, from small movements of them, which is not counted.

A depth controller moves the pump a little in answer to the water, and may see the water's push sooner or better than
the recorded sensors. Such a command tells of the water: a sound pump then looks weak or late, and a sound pressure
sensor late. The reason is that likelihoods given the commands hold only for commands that follow from what was recorded
(Ljung, System Identification, 1999, section 13.4). A pulse, a ramp or a new depth moves the pump by far more than an
answer to the water does; such movements count. Of thrusters that push upwards all this is true as well.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import maximum_filter1d, minimum_filter1d

from cocorosim_ros.diagnosis.criteria.naming import PUMP
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import slowness
from cocorosim_ros.foundation.arrays import Flags, Floats


def quiet_gain(base: Fit, more: Fit) -> float:
    """Nats that the fit `more` gains over `base` on vertical readings while nothing drove it upwards; at least 0."""
    gain = 0.0
    rows = more.filled  # in `base` a pump's fault passes for random force, beside which movements look small
    for track, row, one, other in zip(base.tracks, rows, base.passes, more.passes, strict=True):
        chosen = track.timeline.is_upright & ~_is_loud(track, row)
        gain += float(np.sum((_nats(other) - _nats(one))[chosen]))
    return max(gain, 0.0)


def _is_loud(track: Track, row: Floats) -> Flags:
    """Flags (m,), one for each reading of the track: whether it was driven upwards by more than the water can ask for.

    It was where the force of pumps and thrusters upwards [N], within the PUMP.memory before the reading, changed by
    more than PUMP.loud times the rms of the random force in heave. row: a model's numbers.
    """
    force = track.actuation.lift(track.actuation.drive(row))
    grid = track.timeline.grid
    width = max(1, round(slowness(track.vehicle) * PUMP.memory / grid.step))
    back = {"size": width, "origin": (width - 1) // 2, "mode": "nearest"}  # the window ends at each point
    change = maximum_filter1d(force, **back) - minimum_filter1d(force, **back)
    loud = change > PUMP.loud * np.exp(row[COLUMN["random.heave_force"]])
    point = np.rint((track.timeline.stamp - grid.begin) / grid.step).astype(np.int64)
    return np.asarray(loud[np.clip(point, 0, len(loud) - 1)])


def _nats(passed: Pass) -> Floats:
    """Log-likelihood (m,) of each reading [nats], up to a constant."""
    return np.asarray(-0.5 * (passed.innovation**2 / passed.variance + np.log(passed.variance)))
