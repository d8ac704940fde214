"""Agitation of the water: speed and thrust of a robot over time, with which its random force may grow."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.tracks.columns import COLUMN, WATER_GROWTH
from cocorosim_ros.foundation.arrays import Floats

_COLUMNS = [COLUMN[column] for column in WATER_GROWTH]


class Agitation(NamedTuple):
    """Speed and thrust of a robot over time as a fit saw them, by which its random force grows from then on."""

    time: Floats  # (n,) [s]
    shares: Floats  # (n, quantities) [of the highest], in the order of WATER_GROWTH

    def variance(self, row: Floats, moments: Floats) -> Floats:
        """Factors (points,) of the random force's variance at moments (points,) [s], under a row of numbers (columns,).

        1 + sum (growth share)^2; empty where it grows with nothing.
        """
        growth = np.exp(row[_COLUMNS])
        if (1.0 + growth**2 == 1.0).all():
            return np.zeros(0)
        shares = np.column_stack([np.interp(moments, self.time, each) for each in self.shares.T])
        return np.asarray(1.0 + ((growth * shares) ** 2).sum(axis=1))
