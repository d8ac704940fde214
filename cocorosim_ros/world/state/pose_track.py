"""The track of one robot, as a recording or a simulation delivers it."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.foundation.arrays import Floats, Integers


@dataclass(frozen=True)
class PoseTrack:
    """Poses of one robot in the order of their stamps."""

    stamp_ns: Integers
    """(t,) moment of each pose [ns]."""
    position: Floats
    """(t, 3) position [m; world]."""
    yaw: Floats
    """(t,) heading [rad; world, counter-clockwise from +x]."""
