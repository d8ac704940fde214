"""Thresholds of the filter, apart from all others because a change of one compiles the filter anew."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class FilterCriteria:
    """The gate of the filter, beyond which a reading is doubted (`filter`, `tracks.track_filter`)."""

    gate: float = 6.0
    """[standard deviations] a reading beyond pulls no harder than one there, and makes nothing surer. Chosen, not
    measured."""
    rounding: float = 1e-9
    """[of the squared gate] by which a reading at the gate may miss it through rounding. Reckoned from the digits of
    floating numbers."""


FILTER = FilterCriteria()
