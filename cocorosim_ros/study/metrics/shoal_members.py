"""Which robots belong to one shoal, moment by moment."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Integers
from cocorosim_ros.study.metrics.memory import new_memory
from cocorosim_ros.study.metrics.populations import fill_distances, fill_shoals
from cocorosim_ros.study.metrics.presence import fill_presence
from cocorosim_ros.study.metrics.sampling import SampledTracks
from cocorosim_ros.study.metrics.swarms import new_swarms

_MOMENTS_AT_ONCE = 1000  # the distances of all pairs at that many moments are in memory


def shoal_members(samples: SampledTracks) -> Integers:
    """(t, n) the lowest number of a robot in each robot's shoal, as `shoals` counts them; -1 for absent robots."""
    moments, robots = samples.yaw.shape
    members = np.empty((moments, robots), np.int64)
    for first in range(0, moments, _MOMENTS_AT_ONCE):
        part = slice(first, min(first + _MOMENTS_AT_ONCE, moments))
        count = part.stop - part.start
        swarms = new_swarms(
            np.ascontiguousarray(samples.position[part]), np.zeros(count, np.int64), new_memory(count, robots)
        )
        fill_presence(swarms, np.ascontiguousarray(samples.yaw[part]), np.ascontiguousarray(samples.present[part]))
        fill_distances(swarms)
        fill_shoals(swarms)
        members[part] = swarms.shoal
    return members
