"""Tracks that a user has made: whether they are such, and fit together."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.world.state.pose_track import PoseTrack


def checked_tracks(tracks: Mapping[Any, Any]) -> dict[str, PoseTrack]:
    """The tracks with arrays, where they have lists; those with arrays as they are.

    Raises ArgumentError for the argument `source`: names that are no text, what is no PoseTrack, and arrays that do not
    fit together.
    """
    return {_name(name): _checked(name, track) for name, track in tracks.items()}


def _name(name: object) -> str:
    if not isinstance(name, str):
        raise _refused(f"has the name {name!r}; give robots names that are texts")
    return name


def _checked(name: str, track: object) -> PoseTrack:
    if not isinstance(track, PoseTrack):
        raise _refused(f"has an object of type '{type(track).__name__}' for '{name}'; give a PoseTrack")
    stamps = np.asarray(track.stamp_ns)
    if stamps.dtype.kind not in "iu" and stamps.size:
        raise _refused(f"has a 'stamp_ns' of '{name}' that is no array of whole numbers; give nanoseconds")
    if stamps.ndim != 1:
        raise _refused(f"has a 'stamp_ns' of '{name}' of the shape {stamps.shape}; give (n,)")
    position = _numbers(track.position, "position", name, (len(stamps), 3))
    yaw = _numbers(track.yaw, "yaw", name, (len(stamps),))
    return PoseTrack(stamps.astype(np.int64), position, yaw)


def _numbers(values: object, field: str, name: str, shape: tuple[int, ...]) -> Floats:
    try:
        numbers = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise _refused(f"has a '{field}' of '{name}' that is no array of numbers; give the shape {shape}") from error
    if numbers.shape != shape:
        raise _refused(f"has a '{field}' of '{name}' of the shape {numbers.shape}; give {shape}")
    return numbers


def _refused(words: str) -> ArgumentError:
    return ArgumentError(f"The argument 'source' {words}.", "source")
