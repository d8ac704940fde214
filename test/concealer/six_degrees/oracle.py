"""Free runs by a model that knows the truth: errors as those of `concealer.oracle`.

The readings' noise in them is that of the sounded place and of the attitude told with it, against the true course.
"""

from __future__ import annotations

import numpy as np

from concealer.layout import FloatArray
from concealer.oracle import HELD_OUT, Scores, scored
from concealer.sensors import Stream
from concealer.six_degrees import layout as at
from concealer.six_degrees.programme import replay

WINDOWS = (1.0, 2.0, 5.0, 10.0, 20.0)  # s: such a vehicle coasts for a third of a second


def shown(rows: FloatArray) -> FloatArray:
    """(n, 4) x, y, z [m] and yaw [rad] of a trajectory (n, STATE and more)."""
    w, x, y, z = np.ascontiguousarray(rows[:, at.QUATERNION : at.QUATERNION + 4].T)
    yaw = np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
    return np.column_stack([rows[:, at.X : at.Z + 1], yaw])


def apart(one: FloatArray, other: FloatArray) -> FloatArray:
    """(n, 4) difference of places and yaws, angles the shorter way."""
    off = one - other
    off[:, 3] = np.angle(np.exp(1j * off[:, 3]))
    return off


def noise(pose: Stream, rows: FloatArray, late: float) -> FloatArray:
    """(4,) rms error of the readings of the pose in x, y, z [m] and yaw [rad]; late: by how much they are [s]."""
    clock = np.arange(len(rows)) * at.ROW_TIME
    time = np.clip(pose.stamp - late, 0.0, None)
    place, attitude = slice(at.X, at.Z + 1), slice(at.QUATERNION, at.QUATERNION + 4)
    read, true = np.zeros((len(time), at.STATE)), np.zeros((len(time), at.STATE))
    read[:, place], read[:, attitude] = pose.values[:, :3], pose.values[:, [6, 3, 4, 5]]
    for column in range(at.STATE):
        true[:, column] = np.interp(time, clock, rows[:, column])
    return np.asarray(np.sqrt(np.mean(apart(shown(read), shown(true)) ** 2, axis=0)))


def free_run(p: FloatArray, rows: FloatArray, commands: FloatArray, window: float) -> FloatArray:
    """(4,) mean square error of x, y, z, yaw over windows of the held-out part, against the true course."""
    ticks, begin = round(window / at.TICK), round((1.0 - HELD_OUT) * len(commands))
    per = at.STEPS_PER_TICK // at.STEPS_PER_ROW
    errors = []
    for first in range(begin, len(commands) - ticks + 1, ticks):
        part = rows[first * per : (first + ticks) * per + 1]
        run = replay(p, part[0, : at.STATE].copy(), commands[first : first + ticks], first)
        errors.append(np.mean(apart(shown(run), shown(part)) ** 2, axis=0))
    return np.asarray(np.mean(errors, axis=0))


def oracle(p: FloatArray, rows: FloatArray, commands: FloatArray, floor: FloatArray) -> Scores:
    """Scores by window [s]; floor (4,): noise of the readings."""
    held = HELD_OUT * len(commands) * at.TICK
    return {f"{window:g}": scored(free_run(p, rows, commands, window), floor) for window in WINDOWS if window <= held}
