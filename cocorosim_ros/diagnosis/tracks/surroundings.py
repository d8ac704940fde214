"""What surrounds each robot, as far as the recording tells: where the water ends, and the other robots."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import SURROUNDINGS
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.moment import NEIGHBOUR_FORCE, NEIGHBOUR_SIZE

FAR = 1e6  # m


def introduce(tracks: Sequence[Track]) -> None:
    """Tell the tracks of one recording where the water ends and who else swims there."""
    water = _water(tracks)
    for track in tracks:
        track.water = water
    if len(tracks) > 1:
        for own, track in enumerate(tracks):
            track.own, track.around = own, _around(tracks, track)


def _water(tracks: Sequence[Track]) -> tuple[Floats, Floats]:
    """Lowest and highest corner [m; world]: a tank around the origin, as the contract has it, that held all robots."""
    places = [track.log.streams["pose"].value[:, :3] for track in tracks if "pose" in track.log.streams]
    if not places:
        return np.full(3, -FAR), np.full(3, FAR)
    everything = np.concatenate(places)
    seen = np.isfinite(everything).any(axis=0)
    if not seen.all():
        return np.full(3, -FAR), np.full(3, FAR)
    half = np.nanmax(np.abs(everything[:, :2]), axis=0) + SURROUNDINGS.shore
    if half.max() < SURROUNDINGS.alike * half.min():
        half[:] = half.max()
    floor = min(float(np.nanmin(everything[:, 2])) - SURROUNDINGS.shore, -SURROUNDINGS.shore)
    return np.array([-half[0], -half[1], floor]), np.array([half[0], half[1], 0.0])


def _around(tracks: Sequence[Track], track: Track) -> Floats:
    """(points, robots, NEIGHBOUR_SIZE) places and thrusts of all robots at the grid points of one of them."""
    readings = track.readings
    moments: Floats = readings.begin + readings.step * np.arange(readings.points, dtype=np.float64)
    around = np.full((readings.points, len(tracks), NEIGHBOUR_SIZE), 0.0)
    around[:, :, :3] = FAR
    for other, fellow in enumerate(tracks):
        if "pose" not in fellow.log.streams:
            continue
        pose = fellow.log.streams["pose"]
        for axis in range(3):
            around[:, other, axis] = np.interp(moments, pose.time, pose.value[:, axis])
        yaw = np.interp(moments, pose.time, pose.value[:, 3])
        surge, sway = _thrust(fellow, moments)
        around[:, other, NEIGHBOUR_FORCE] = surge * np.cos(yaw) - sway * np.sin(yaw)
        around[:, other, NEIGHBOUR_FORCE + 1] = surge * np.sin(yaw) + sway * np.cos(yaw)
    return around


def _thrust(track: Track, moments: Floats) -> tuple[Floats, Floats]:
    """Forward and sideways force of the thrusters [N] at these moments, as commanded."""
    drive = track.nominal_force()
    own = track.readings.begin + track.readings.step * np.arange(track.readings.points)
    index = np.clip(np.searchsorted(own, moments, side="right") - 1, 0, len(own) - 1)
    return drive[index, 0], drive[index, 1]
