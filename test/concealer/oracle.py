"""Free runs of a model that knows the truth: what the best tool could reach on held-out data.

The last 40 % of a recording is cut into windows; each starts from the true state and runs on the logged commands
without random forces. Errors are against the camera's measurements, so they contain its noise; those called `_alone`
are against the true course.
"""

from __future__ import annotations

import numpy as np

from concealer import layout as at
from concealer.layout import FloatArray
from concealer.physics import replay, still
from concealer.sensors import Stream

WINDOWS = (5.0, 10.0, 20.0, 30.0)  # s
HELD_OUT = 0.4
Scores = dict[str, dict[str, float]]


def _noise(pose: Stream) -> FloatArray:
    """(4,) standard deviation of the camera's noise in x, y, z [m] and yaw [rad], from second differences."""
    # Copied, because NumPy 1.26 rounds the arctangent of strided columns by where its result lies.
    sine, cosine = np.ascontiguousarray(pose.values[:, 5:7].T)
    yaw = np.unwrap(2.0 * np.arctan2(sine, cosine))
    bends = np.diff(np.column_stack([pose.values[:, :3], yaw]), 2, axis=0)
    return np.asarray(1.4826 * np.median(np.abs(bends), axis=0) / np.sqrt(6.0))


def free_run(p: FloatArray, rows: FloatArray, commands: FloatArray, window: float) -> FloatArray:
    """(robots, 4) mean square error of x, y, z, yaw over windows of the held-out part, without the camera's noise."""
    ticks, begin = round(window / at.TICK), round((1.0 - HELD_OUT) * len(commands))
    errors = []
    for first in range(begin, len(commands) - ticks + 1, ticks):
        part = rows[first * 5 : (first + ticks) * 5 + 1]
        run = replay(p, part[0, :, : at.STATE].copy(), commands[first : first + ticks], still(len(p), ticks), first)
        errors.append(np.mean((run - part)[:, :, :4] ** 2, axis=0))
    return np.asarray(np.mean(errors, axis=0))


def scored(square: FloatArray, floor: FloatArray) -> dict[str, float]:
    """Rms of `position` [m], `depth` [m], `heading` [rad] by the mean square error (4,) of x, y, z, yaw of a free run.

    floor (4,): noise of the readings, which the errors called `_alone` are without.
    """
    total, alone = np.sqrt(square + floor**2), np.sqrt(square)
    scores = {"position": float(np.hypot(*total[:2])), "depth": float(total[2]), "heading": float(total[3])}
    scores |= {"position_alone": float(np.hypot(*alone[:2]))}
    return scores | {"depth_alone": float(alone[2]), "heading_alone": float(alone[3])}


def oracle(p: FloatArray, rows: FloatArray, commands: FloatArray, poses: list[Stream]) -> dict[str, Scores]:
    """Scores by robot and window [s], of windows that fit into the held-out part."""
    out: dict[str, Scores] = {}
    floors = [_noise(pose) for pose in poses]
    for window in WINDOWS:
        if window > HELD_OUT * len(commands) * at.TICK:
            continue
        square = free_run(p, rows, commands, window)
        for i, floor in enumerate(floors):
            out.setdefault(f"lily_{i + 1:02d}", {})[f"{window:g}"] = scored(square[i], floor)
    return out
