"""Tracks of all robots of the evidence, each with the robots and walls around it, as far as a recording tells."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import SURROUNDINGS
from cocorosim_ros.diagnosis.evidence.holes import holes_of, parts_of
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE, POSITION, YAW, X, Y, Z
from cocorosim_ros.diagnosis.tracks.surroundings import FAR, OPEN_WATER
from cocorosim_ros.diagnosis.tracks.track import Track, make_track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.moment import NEIGHBOUR_FORCE, NEIGHBOUR_SIZE

NONE_FOUND: Mapping[str, Floats] = {}


def introduced(tracks: Sequence[Track], parts: Sequence[Sequence[Track]] | None = None) -> list[Track]:
    """Put the tracks of one recording into their common water, each among the others.

    parts: for each track the tracks to put there in its place, such as its parts between holes of its log.
    """
    lower, upper = _water(tracks)
    water = OPEN_WATER._replace(lower=lower, upper=upper)
    parts = [[track] for track in tracks] if parts is None else parts
    if len(tracks) == 1:
        return [part.among(water) for part in parts[0]]
    return [
        part.among(water._replace(around=_around(tracks, part), own=own))
        for own, own_parts in enumerate(parts)
        for part in own_parts
    ]


def _water(tracks: Sequence[Track]) -> tuple[Floats, Floats]:
    """Lowest and highest corner (3,) [m; world] of a tank around the origin that holds all poses; FAR without poses.

    The contract puts the origin into the middle of the surface. A tank that is nearly square is taken as square. Of
    hulls too wide to come as near to a wall as is assumed no tank is known; of those that keep their depth no surface,
    whose distance never changes.
    """
    places = [track.log.streams["pose"].value[:, POSITION] for track in tracks if "pose" in track.log.streams]
    if not places:
        return np.full(3, -FAR), np.full(3, FAR)
    vehicle, everything = tracks[0].vehicle, np.concatenate(places)
    seen = np.isfinite(everything).any(axis=0)
    if not seen.all():
        return np.full(3, -FAR), np.full(3, FAR)
    low, high = np.nanquantile(everything[:, Z], (SURROUNDINGS.lowest, 1.0 - SURROUNDINGS.lowest))
    surface = 0.0 if high - low > vehicle.height else FAR
    beside = 0.5 * vehicle.width
    if beside > SURROUNDINGS.shore:
        return np.full(3, -FAR), np.array([FAR, FAR, surface])
    half = np.nanmax(np.abs(everything[:, PLANE]), axis=0) + SURROUNDINGS.shore
    if half.max() < SURROUNDINGS.alike * half.min():
        half[:] = half.max()
    floor = min(float(np.nanmin(everything[:, Z])) - SURROUNDINGS.shore, -SURROUNDINGS.shore)
    return np.array([-half[0], -half[1], floor]), np.array([half[0], half[1], surface])


def _around(tracks: Sequence[Track], track: Track) -> Floats:
    """Places and thrusts [m, N; world] of all robots at one track's grid points: (points, robots, NEIGHBOUR_SIZE).

    Robots without poses are FAR away.
    """
    moments = track.timeline.grid.moments
    around = np.zeros((len(moments), len(tracks), NEIGHBOUR_SIZE))
    around[:, :, POSITION] = FAR
    for other, fellow in enumerate(tracks):
        if "pose" not in fellow.log.streams:
            continue
        pose = fellow.log.streams["pose"]
        for axis in (X, Y, Z):
            around[:, other, axis] = np.interp(moments, pose.time, pose.value[:, axis])
        yaw = np.interp(moments, pose.time, pose.value[:, YAW])
        surge, sway = _thrust(fellow, moments)
        around[:, other, NEIGHBOUR_FORCE] = surge * np.cos(yaw) - sway * np.sin(yaw)
        around[:, other, NEIGHBOUR_FORCE + 1] = surge * np.sin(yaw) + sway * np.cos(yaw)
    return around


def _thrust(track: Track, moments: Floats) -> tuple[Floats, Floats]:
    """Forward and leftward force (points,) of the thrusters [N; body] at `moments` (points,) [s], as commanded."""
    drive = track.actuation.nominal_force()
    own = track.timeline.grid.moments
    index = np.clip(np.searchsorted(own, moments, side="right") - 1, 0, len(own) - 1)
    surge, sway = drive[index].T
    return surge, sway


def make_tracks(evidence: Evidence, found: Mapping[str, Floats] = NONE_FOUND) -> tuple[Track, ...]:
    """Make a track of every robot in every recording that has readings of it, one for each part between holes.

    found: by robot, numbers (columns,) that a fit has found, for the steps of the grids.
    """
    tracks: list[Track] = []
    for recording in evidence.recordings:
        logs = [log for log in recording.robots if _times(log)]
        alone = [make_track(evidence.platform, log, *_span(log), found.get(log.name)) for log in logs]
        tracks += introduced(alone, [_parts(evidence, whole, found.get(whole.name)) for whole in alone])
    return tuple(tracks)


def _parts(evidence: Evidence, whole: Track, found: Floats | None) -> list[Track]:
    """Make the tracks of the parts of a log between its holes; the whole track alone where it has none."""
    if not holes_of(whole.log):
        return [whole]
    return [make_track(evidence.platform, whole.log, begin, end, found) for begin, end in parts_of(whole.log)]


def _times(log: RobotLog) -> list[Floats]:
    """Stamps [s] of every stream that has readings."""
    return [stream.time for stream in log.streams.values() if len(stream.time)]


def _span(log: RobotLog) -> tuple[float, float]:
    """Stamps [s] of the first and of the last reading of all streams."""
    times = _times(log)
    return min(float(time[0]) for time in times), max(float(time[-1]) for time in times)
