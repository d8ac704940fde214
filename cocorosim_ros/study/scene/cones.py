"""Lines that show a blue-light sensor's cone."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.vehicle_parts import unit_vector

_RIM_POINTS = 13
_SPOKES = 4
_WIDEST = 0.49 * math.pi  # rad: the rim of a wider half cone lies behind the sensor and shows nothing


def cone_lines(azimuth: float, elevation: float, cone_angle: float, reach: float) -> list[Floats]:
    """The rim of a cone and spokes to it, as lines (points, 3) [m; body].

    azimuth, elevation: its axis [rad; body]; cone_angle: full opening [rad]; reach: distance of the rim [m].
    """
    axis = np.array(unit_vector(azimuth, elevation))
    aside = np.array([-math.sin(azimuth), math.cos(azimuth), 0.0])
    above = np.cross(axis, aside)
    half = min(cone_angle / 2, _WIDEST)
    turn = np.linspace(0.0, 2 * math.pi, _RIM_POINTS)[:, None]
    rim = reach * (math.cos(half) * axis + math.sin(half) * (np.cos(turn) * aside + np.sin(turn) * above))
    spokes = [np.stack([np.zeros(3), point]) for point in rim[: -1 : (_RIM_POINTS - 1) // _SPOKES]]
    return [rim, *spokes]
