"""Thresholds of the filter, apart from all others because a change of one compiles the filter anew."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class FilterCriteria:
    """The gate of the filter, beyond which a reading is doubted (`filter`, `tracks.track_filter`)."""

    gate: float = 6.0
    """[standard deviations] a reading beyond pulls no harder than one there, and makes nothing surer. Chosen, not
    measured."""
    near: float = 5.5
    """[steps] to the reading of the same kind before, from which on coloured errors are taken as white: the Taylor
    series back to it errs by (1/11)^3 / 6 of what a vehicle that coasts for 60 steps does. Reckoned from that."""
    forgotten: float = 700.0
    """[memories of errors] after which nothing is left of one. Reckoned from the least number that there is."""
    rounding: float = 1e-9
    """[of the squared gate] by which a reading at the gate may miss it through rounding. Reckoned from the digits of
    floating numbers."""


FILTER = FilterCriteria()
