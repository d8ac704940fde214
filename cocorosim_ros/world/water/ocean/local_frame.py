"""Latitude and longitude to metres east and north of an origin (REP 103: x east, y north).

x = N cos(latitude_0) (longitude - longitude_0), y = M (latitude - latitude_0) with the radii of curvature N and M of
the ellipsoid WGS 84 at the origin (Snyder, Map Projections: A Working Manual, 1987, equations 4-18 and 4-20).
Assumes: distances of some ten kilometres at most; 10 km away a place is off by 8 m tan(latitude).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats

EQUATOR = 6_378_137.0  # m, semi-major axis of WGS 84
ECCENTRICITY_SQUARED = 6.69437999014e-3


@dataclass(frozen=True)
class LocalFrame:
    """The frame of the world, whose origin is at a latitude and a longitude [rad]."""

    latitude: float
    longitude: float

    @property
    def metres_north(self) -> float:
        """Per radian of latitude."""
        return EQUATOR * (1.0 - ECCENTRICITY_SQUARED) / math.pow(self._flattening, 1.5)

    @property
    def metres_east(self) -> float:
        """Per radian of longitude."""
        return EQUATOR / math.sqrt(self._flattening) * math.cos(self.latitude)

    @property
    def _flattening(self) -> float:
        return 1.0 - ECCENTRICITY_SQUARED * math.sin(self.latitude) ** 2

    def east(self, longitude: Floats) -> Floats:
        """x [m] of longitudes [deg], whichever way round they are counted."""
        turned = (longitude - math.degrees(self.longitude) + 180.0) % 360.0 - 180.0
        return np.asarray(self.metres_east * np.radians(turned))

    def north(self, latitude: Floats) -> Floats:
        """y [m] of latitudes [deg]."""
        return np.asarray(self.metres_north * np.radians(latitude - math.degrees(self.latitude)))
