"""The tracks of each robot: one robot may be in several recordings."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.tracks.track import Track


def tracks_by_robot(tracks: Sequence[Track]) -> dict[str, tuple[int, ...]]:
    """Numbers of each robot's tracks, by name of the robot, in the order of first appearance."""
    names = [track.name for track in tracks]
    return {robot: tuple(index for index, name in enumerate(names) if name == robot) for robot in dict.fromkeys(names)}
