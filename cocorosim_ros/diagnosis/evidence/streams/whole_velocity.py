"""Velocities of which all three parts were recorded."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import TILT
from cocorosim_ros.diagnosis.evidence.streams.log import Stream
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import OVER_GROUND, THROUGH_WATER, U, W
from cocorosim_ros.diagnosis.evidence.streams.velocities import Velocities


def whole_velocity(streams: Mapping[str, Stream]) -> Velocities | None:
    """Velocities with all three parts: through the water if that is known, else over ground; None if neither is."""
    for topic in (THROUGH_WATER, OVER_GROUND):
        if topic in streams:
            stream = streams[topic]
            known = np.isfinite(stream.value[:, U : W + 1]).all(axis=1)
            if np.count_nonzero(known) >= TILT.fewest:
                return Velocities(stream.time[known], stream.value[known, U : W + 1])
    return None
