"""The track of one robot, as a recording or a simulation delivers it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class PoseTrack:
    """Poses of one robot in the order of their stamps."""

    stamp_ns: NDArray[np.int64]
    """(t,) moment of each pose [ns]."""
    position: NDArray[np.float64]
    """(t, 3) position [m; world]."""
    yaw: NDArray[np.float64]
    """(t,) heading [rad; world, counter-clockwise from +x]."""
