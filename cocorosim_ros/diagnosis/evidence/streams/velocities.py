"""Velocities along three axes."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats


class Velocities(NamedTuple):
    """Times (m,) [s] and velocities (m, 3) [m/s], along the axes of the stream or log that has them."""

    time: Floats
    value: Floats
