"""Tracks of robots with their own rates and gaps, brought to common moments.

Lock-step recordings, where all robots have the same stamps, pass through untouched, so that the numbers
equal the live ones bit for bit. Otherwise positions are interpolated linearly and yaw along the shorter
arc; a moment inside a gap that is longer than the limit, or outside a robot's track, finds that robot
absent.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.metrics.sampling import SampledTracks, Sampling, beside_moments
from cocorosim_ros.study.metrics.shoal_monitor import ShoalMonitor
from cocorosim_ros.world.state.pose_track import Poses, poses_in_parts

_SHORTEST_GAP_LIMIT_NS = 1_000_000_000
_INTERVALS_IN_GAP_LIMIT = 3
_MOST_SAMPLES = 10_000_000
_RATE_TOLERANCE = 0.01


def sample_tracks(
    tracks: Mapping[str, Poses], interval_ns: int | None = None, gap_limit_ns: int | None = None
) -> SampledTracks:
    """Poses of all robots at all common moments, as `plan_samples` says."""
    plan = plan_samples(tracks, interval_ns, gap_limit_ns)
    return plan.at(plan.stamp_ns)


def plan_samples(
    tracks: Mapping[str, Poses], interval_ns: int | None = None, gap_limit_ns: int | None = None
) -> Sampling:
    """The common moments of all robots, in the alphabetical order of their names.

    interval_ns: distance of the moments [ns]; left out, the stamps themselves if all robots share them,
    else the median pose interval. gap_limit_ns: longest gap that is interpolated [ns]; left out, per robot
    three times its median interval and at least one second. Raises CocorosimError if no robot has a pose,
    or if the stamps span more moments than can be meant.
    """
    findings: list[str] = []
    clean = {name: _cleaned(name, tracks[name], findings) for name in sorted(tracks)}
    known = {name: track for name, track in clean.items() if track.stamp_ns.size}
    findings += [f"{name} has no usable pose and is absent throughout." for name in clean if name not in known]
    if not known:
        raise CocorosimError("No robot has a usable pose: record the topics .../pose, or `convert` others.")
    moments = _shared_stamps(known) if interval_ns is None else None
    if moments is None:
        interval = _median_interval_ns(known) if interval_ns is None else interval_ns
        moments = _grid(known, interval)
        findings.append(_sampling_sentence(known, interval))
    limits = {name: _gap_limit_ns(track) if gap_limit_ns is None else gap_limit_ns for name, track in known.items()}
    for name, track in known.items():
        findings += _absence_sentences(name, track, moments, limits[name])
    return Sampling(clean, moments, limits, tuple(findings))


def measure_samples(samples: SampledTracks | Sampling) -> ShoalMonitor:
    """A monitor that has seen all moments of the samples."""
    monitor = ShoalMonitor(len(samples.names))
    for part in samples.parts():
        for tick, stamp_ns in enumerate(part.stamp_ns):
            monitor.update(int(stamp_ns), part.position[tick], part.yaw[tick], part.present[tick])
    return monitor


@dataclass(frozen=True, eq=False)
class _Chosen:
    """Some poses of a track."""

    track: Poses
    stamp_ns: Integers
    """(t,) growing [ns]."""
    rows: Integers
    """(t,) which they are."""

    def at(self, rows: Integers) -> tuple[Floats, Floats]:
        """Position (n, 3) [m; world] and yaw (n,) [rad; world] of the poses `rows` (n,)."""
        return self.track.at(self.rows[rows])


def _cleaned(name: str, track: Poses, findings: list[str]) -> Poses:
    """The track with growing stamps and finite poses; of several poses with one stamp the first stays."""
    finite = _finite(track)
    if not finite.all():
        findings.append(f"{name}: {np.count_nonzero(~finite)} poses that are not finite were left out.")
    stamps = track.stamp_ns[finite]
    late = np.count_nonzero(np.diff(stamps) < 0)
    if late:
        findings.append(f"{name}: poses were out of order at {late} places and were sorted by their stamps.")
    unique, first = np.unique(stamps, return_index=True)
    if unique.size < stamps.size:
        findings.append(f"{name}: {stamps.size - unique.size} poses repeated a stamp and were left out.")
    if late == 0 and unique.size == track.stamp_ns.size:
        return track
    return _Chosen(track, unique.astype(np.int64), np.flatnonzero(finite)[first])


def _finite(track: Poses) -> Flags:
    """(t,) which poses are finite."""
    finite = np.empty(track.stamp_ns.size, np.bool_)
    for rows, position, yaw in poses_in_parts(track):
        finite[rows] = np.isfinite(position).all(axis=1) & np.isfinite(yaw)
    return finite


def _shared_stamps(tracks: Mapping[str, Poses]) -> Integers | None:
    first, *others = tracks.values()
    if all(np.array_equal(first.stamp_ns, other.stamp_ns) for other in others):
        return first.stamp_ns
    return None


def _median_interval_ns(tracks: Mapping[str, Poses]) -> int:
    intervals = [np.median(np.diff(track.stamp_ns)) for track in tracks.values() if track.stamp_ns.size > 1]
    return max(1, round(float(np.median(intervals)))) if intervals else _SHORTEST_GAP_LIMIT_NS


def _grid(tracks: Mapping[str, Poses], interval_ns: int) -> Integers:
    if interval_ns <= 0:
        raise CocorosimError(f"The interval of {interval_ns} ns between moments must be positive.")
    start = min(int(track.stamp_ns[0]) for track in tracks.values())
    end = max(int(track.stamp_ns[-1]) for track in tracks.values())
    if (end - start) // interval_ns > _MOST_SAMPLES:
        raise CocorosimError(
            f"The poses span {(end - start) / 1e9:.0f} s, which is more than {_MOST_SAMPLES} moments "
            f"{interval_ns} ns apart: do all robots use one clock? Give a longer interval if they do."
        )
    return np.arange(start, end + 1, interval_ns, dtype=np.int64)


def _sampling_sentence(tracks: Mapping[str, Poses], interval_ns: int) -> str:
    several = [track.stamp_ns for track in tracks.values() if track.stamp_ns.size > 1]
    rates = [1e9 / float(np.median(np.diff(stamps))) for stamps in several] or [float("nan")]
    slowest, fastest = min(rates), max(rates)
    same = fastest - slowest <= _RATE_TOLERANCE * fastest
    spread = f"{fastest:.3g} Hz" if same else f"{slowest:.3g} to {fastest:.3g} Hz"
    return (
        f"The robots' poses have different stamps (median rates {spread}): "
        f"they were interpolated to moments {interval_ns / 1e9:.6g} s apart."
    )


def _gap_limit_ns(track: Poses) -> int:
    if track.stamp_ns.size < 2:
        return _SHORTEST_GAP_LIMIT_NS
    median = float(np.median(np.diff(track.stamp_ns)))
    return max(_SHORTEST_GAP_LIMIT_NS, round(_INTERVALS_IN_GAP_LIMIT * median))


def _absence_sentences(name: str, track: Poses, moments: Integers, limit_ns: int) -> list[str]:
    present = beside_moments(track.stamp_ns, moments, limit_ns).present
    gaps = np.diff(track.stamp_ns)
    long = gaps > limit_ns
    sentences = []
    if long.any():
        sentences.append(
            f"{name}: {np.count_nonzero(long)} gaps longer than {limit_ns / 1e9:.3g} s (the longest "
            f"{gaps.max() / 1e9:.3g} s); the robot counts as absent there."
        )
    if not present.all():
        sentences.append(f"{name} is absent at {np.count_nonzero(~present)} of {present.size} moments.")
    return sentences
