"""Free runs through the last part of each recording, by models fitted to the first part alone.

Every run starts at a state of the smoothed course, with no random force, and takes no readings; it lasts as long as a
vehicle of that agility can be foretold. The noise floor is the error that random force and the error of the readings
alone would leave a right model.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.showing import FREE_RUNS
from cocorosim_ros.diagnosis.findings import FreeRun, HeldOut
from cocorosim_ros.diagnosis.fitting.climbing import improved, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.showing.bootstrap import drawn, interval_of_root
from cocorosim_ros.diagnosis.showing.held_out_streams import HeldOutPart, held_out_streams
from cocorosim_ros.diagnosis.tracks.columns import WATER_NOISE
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import STATE_SIZE, YAW, YAW_RATE, X, Y, Z

CHANNELS = {"position": "m", "heading": "rad", "depth": "m"}
MODELS = ("nominal", "recalibrated", "augmented")


@dataclass(frozen=True)
class Window:
    """One window of a recording: squared errors (points, 3) by model and of the noise floor, and paths for pictures.

    Columns: position [m^2], heading [rad^2], depth [m^2].
    """

    squared: dict[str, Floats]
    run: FreeRun


def held_out_free_runs(base: Fit, final: Fit) -> tuple[dict[str, HeldOut], tuple[FreeRun, ...]]:
    """Errors of the three models on the held-out part, by channel and by stream, and the windows as paths.

    base, final: the recalibrated fit and the one with all named effects, both to whole recordings.
    """
    tracks = tuple(track.until(FREE_RUNS.seen) for track in base.tracks)
    fits = {"recalibrated": _refitted(base, tracks), "augmented": _refitted(final, tracks)}
    nominal_rows = base.rows
    best = final.filled
    windows: list[Window] = []
    courses = [track.filter.smoothed(row) for track, row in zip(base.tracks, best, strict=True)]
    seconds = window_length(courses)
    for number, (track, course) in enumerate(zip(base.tracks, courses, strict=True)):
        rows = {"nominal": nominal_rows[number], **{name: fit.filled[number] for name, fit in fits.items()}}
        windows += _windows(track, course, rows, seconds)
    if not windows:
        return {}, ()
    models = {"nominal": nominal_rows, **{name: fit.filled for name, fit in fits.items()}}
    streams = held_out_streams(base.tracks, courses, models, HeldOutPart(FREE_RUNS.seen, seconds))
    return {**_table(windows, base.tracks, seconds), **streams}, tuple(window.run for window in windows)


def window_length(courses: Sequence[Smoothed]) -> float:
    """Choose the longest of FREE_RUNS.windows [s] in which the robots turn by no more than FREE_RUNS.most_turned."""
    turned = np.concatenate([course.mean[:, YAW_RATE] for course in courses])
    rate = float(np.sqrt(np.mean(turned**2)))
    return next(
        (seconds for seconds in FREE_RUNS.windows if seconds * rate <= FREE_RUNS.most_turned), FREE_RUNS.windows[-1]
    )


def _refitted(fit: Fit, tracks: tuple[Track, ...]) -> Fit:
    """Fit a model anew to `tracks`, the first part of the recordings alone."""
    start = evaluated(replace(fit, tracks=tracks))
    return improved(with_noise(improved(start, 2), 1, WATER_NOISE), 3)


def _windows(track: Track, course: Smoothed, rows: dict[str, Floats], seconds: float) -> list[Window]:
    """Run all models freely through every window of a track's held-out part; rows (columns,): by model."""
    grid = track.timeline.grid
    first = round(FREE_RUNS.seen * grid.points)
    length = min(round(seconds / grid.step), (grid.points - first - 1) // 2)
    if length < FREE_RUNS.fewest_points:
        return []
    found = []
    for begin in range(first, grid.points - length, length):
        start = course.mean[begin, :STATE_SIZE]
        paths = {name: track.filter.free_run(row, start, begin, length) for name, row in rows.items()}
        measured = course.mean[begin : begin + length, :STATE_SIZE]
        squared = {name: _squared(path, measured) for name, path in paths.items()}
        squared["noise_floor"] = _floor(track, rows["augmented"], course, begin, length)
        time = course.time[begin : begin + length]
        shown = (X, Y, Z, YAW)
        run = FreeRun(track.name, time, measured[:, shown], *(paths[name][:, shown] for name in MODELS))
        found.append(Window(squared, run))
    return found


def _squared(path: Floats, measured: Floats) -> Floats:
    """Squared errors (points, 3) of a path: position [m^2], heading [rad^2] and depth [m^2]."""
    off = path - measured
    turn = off[:, YAW] - 2.0 * np.pi * np.round(off[:, YAW] / (2.0 * np.pi))
    return np.column_stack([off[:, X] ** 2 + off[:, Y] ** 2, turn**2, off[:, Z] ** 2])


def _floor(track: Track, row: Floats, course: Smoothed, begin: int, length: int) -> Floats:
    """Squared errors (points, 3) that a right model would have: its runs with and without the smoothed random force."""
    start = course.mean[begin, :STATE_SIZE]
    free = track.filter.free_run(row, start, begin, length)
    pushed = track.filter.free_run(row, start, begin, length, course.mean[begin : begin + length, STATE_SIZE:])
    return _squared(free, pushed)


def _table(windows: Sequence[Window], tracks: Sequence[Track], seconds: float) -> dict[str, HeldOut]:
    """Root mean squares over all windows with bootstrap intervals, for each channel that a stream shows."""
    shown = {
        "position": any(track.timeline.sees("pose_x") for track in tracks),
        "heading": any(track.timeline.sees("pose_yaw", "compass") for track in tracks),
        "depth": any(track.timeline.sees("pose_z", "pressure") for track in tracks),
    }
    rng = np.random.default_rng(0)  # which windows the bootstrap draws
    table = {}
    for index, (channel, unit) in enumerate(CHANNELS.items()):
        if not shown[channel]:
            continue
        means = {
            name: np.array([window.squared[name][:, index].mean() for window in windows])
            for name in (*MODELS, "noise_floor")
        }
        draws = drawn(rng, len(windows))
        intervals = {name: interval_of_root(values, draws) for name, values in means.items()}
        values = {name: float(np.sqrt(mean.mean())) for name, mean in means.items()}
        table[channel] = HeldOut(**values, unit=unit, intervals=intervals, seconds=seconds)
    return table
