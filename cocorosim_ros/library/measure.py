"""Shoaling statistics of whatever says where the robots were: recordings, simulations, tracks, plain arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.library.given_tracks import checked_tracks
from cocorosim_ros.library.recording import Recording, read_recording
from cocorosim_ros.library.shoal_statistics import ShoalStatistics, statistics_of
from cocorosim_ros.library.simulated_run import SimulatedRun
from cocorosim_ros.scenario.reading.arguments import LARGEST, Place, Time, names, nanoseconds, place_text, refused
from cocorosim_ros.study.metrics.from_tracks import plan_samples
from cocorosim_ros.study.metrics.sampling import SampledTracks
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.world.state.pose_track import PoseTrack

Tracks = Mapping[str, PoseTrack]
Source = Recording | SimulatedRun | Tracks | Place


@overload
def measure(source: Source, /, *, interval: Time | None = None) -> ShoalStatistics: ...


@overload
def measure(
    time: ArrayLike,
    position: ArrayLike,
    yaw: ArrayLike,
    /,
    *,
    robots: Sequence[str] | None = None,
    interval: Time | None = None,
) -> ShoalStatistics: ...


def measure(
    source: Source | ArrayLike,
    position: ArrayLike | None = None,
    yaw: ArrayLike | None = None,
    /,
    *,
    robots: Sequence[str] | None = None,
    interval: Time | None = None,
) -> ShoalStatistics:
    """Measure a shoal: the numbers of `cocorosim metrics`, over time and for the whole run.

    One argument: a path of a recording, a `Recording`, a `SimulatedRun`, or a mapping from names to tracks
    (`PoseTrack`): `stamp_ns` (n,) [ns], `position` (n, 3) [m; world], `yaw` (n,) [rad].

    Three arguments, arrays or lists: time (t,) [s], growing; position (t, robots, 3) x, y, z [m; world]; yaw (t,
    robots) [rad, counter-clockwise from +x]. A robot with a NaN counts as absent at that moment. robots: names for the
    columns of these.

    interval: measure every so often, such as '0.5 s' or 0.5 [s], by interpolation; left out, at the moments that the
    source has.

    Returns statistics with `values` of the whole run, `series` over time, unit and formula of each metric. Raises
    CocorosimError if there are no poses, if arrays do not fit together, or the interval is no time.

    Example: `measure("runs/demo").values["polarisation"]`; of two robots 0.3 m apart at two moments
    `measure([0.0, 0.5], [[[0, 0, 0], [0.3, 0, 0]]] * 2, [[0, 0]] * 2)["separation"]` is [0.3, 0.3] m.
    """
    if yaw is not None and position is not None:
        given = _sampled(source, position, yaw, robots)
        if interval is None:
            return statistics_of(given, "arrays")
        return statistics_of(plan_samples(_tracks(given), nanoseconds(interval, "interval")), "arrays")
    if position is not None or yaw is not None or robots is not None:
        raise ArgumentError(
            "Arrays are measured by three arguments, 'time', 'position' and 'yaw', and 'robots' names their columns; "
            "give all three, or one recording, simulation or mapping of tracks alone.",
            "time",
            "position",
            "yaw",
            "robots",
        )
    if isinstance(source, Recording | SimulatedRun):
        return source.measure(interval)
    if isinstance(source, Mapping):
        every = None if interval is None else nanoseconds(interval, "interval")
        return statistics_of(plan_samples(checked_tracks(source), every), "tracks")
    return read_recording(place_text(source, "source")).measure(interval)


def _sampled(time: object, position: object, yaw: object, robots: Sequence[str] | None) -> SampledTracks:
    """Arrays as poses at common moments, robots in alphabetical order. Raises CocorosimError if they do not fit."""
    moments, places, headings = _numbers(time, "time"), _numbers(position, "position"), _numbers(yaw, "yaw")
    if places.ndim != 3 or places.shape[2:] != (3,) or headings.shape != places.shape[:2] or 0 in headings.shape:
        raise _misfit("position", places.shape, "(t, robots, 3) with a yaw of (t, robots)")
    if moments.shape != headings.shape[:1]:
        raise _misfit("time", moments.shape, f"({len(headings)},), one number for each moment of the positions")
    columns = _columns(robots, headings.shape[1])
    order = sorted(range(len(columns)), key=lambda robot: columns[robot])
    present = np.isfinite(places).all(axis=2) & np.isfinite(headings)
    return SampledTracks(
        tuple(columns[robot] for robot in order),
        _stamps(moments),
        places[:, order],
        headings[:, order],
        present[:, order],
        (),
    )


def _numbers(values: Any, name: str) -> Floats:
    """A copy as numbers."""
    try:
        given = np.asarray(values)
        if given.dtype.kind in "iufO":
            return np.array(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        pass
    raise refused(values, name, "which is no array of numbers; give an array, or a list, of them")


def _misfit(name: str, shape: tuple[int, ...], wanted: str) -> ArgumentError:
    return ArgumentError(f"The argument '{name}' has the shape {shape}; give {wanted}.", name)


def _columns(robots: Sequence[str] | None, count: int) -> list[str]:
    """The names of the columns."""
    if robots is None:
        return [f"robot_{number:0{len(str(count))}d}" for number in range(1, count + 1)]
    given = names(robots, "robots")
    if len(set(given)) != count or len(given) != count:
        told = f"The argument 'robots' names {len(set(given))} robots; give {count} different names."
        raise ArgumentError(told, "robots")
    return given


def _stamps(time: Floats) -> Integers:
    if not np.isfinite(time).all():
        raise ArgumentError("The argument 'time' has numbers that are not finite; give seconds.", "time")
    if (np.abs(time) >= LARGEST / NANOSECONDS).any():
        told = f"has {np.abs(time).max():g} s, more than 292 years; count the time from a later zero"
        raise ArgumentError(f"The argument 'time' {told}.", "time")
    stamps = np.round(time * NANOSECONDS).astype(np.int64)
    if (np.diff(stamps) <= 0).any():
        told = "The argument 'time' does not grow from moment to moment; sort the poses by time."
        raise ArgumentError(told, "time")
    return stamps


def _tracks(samples: SampledTracks) -> dict[str, PoseTrack]:
    """The poses of each robot where it is present."""
    return {
        name: PoseTrack(samples.stamp_ns[there], samples.position[there, robot], samples.yaw[there, robot])
        for robot, (name, there) in enumerate(zip(samples.names, samples.present.T, strict=True))
    }
