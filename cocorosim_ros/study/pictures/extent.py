"""What of the world is to be seen in a picture of a run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.study.pictures.facts import ScenarioFacts
from cocorosim_ros.world.state.pose_track import Poses, poses_in_parts

_MARGIN_SHARE = 0.025


class Extent(NamedTuple):
    """Lowest and highest corner (3,) of what is to be seen [m; world]."""

    low: Floats
    high: Floats


def extent(tracks: Mapping[str, Poses], facts: ScenarioFacts) -> Extent:
    """What is to be seen: all poses, and the tank if known."""
    corners = [np.array(c) for c in (facts.low_corner, facts.high_corner) if c is not None]
    for track in tracks.values():
        for _, position, _ in poses_in_parts(track):
            places = position[np.isfinite(position).all(axis=1)]
            corners += [places.min(axis=0), places.max(axis=0)] if len(places) else []
    everything = np.stack(corners)
    low, high = everything.min(axis=0), everything.max(axis=0)
    # A swarm that does not move in some direction still needs an axis to be drawn on.
    margin = np.full(3, _MARGIN_SHARE * np.max(high - low) + 1e-3)
    return Extent(low - margin, high + margin)
