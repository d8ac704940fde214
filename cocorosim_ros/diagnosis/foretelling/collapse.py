"""Collapse of a fit: its recalibrated model foretells unseen data worse than the platform as given."""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.exactness import EXACT, is_beyond_steps


def collapsed_channels(table: Mapping[str, HeldOut]) -> tuple[str, ...]:
    """Name the channels of free runs by which a fit has collapsed: those that clearly err more, and not by steps."""
    return tuple(channel for channel in EXACT if channel in table and _is_worse(channel, table[channel]))


def _is_worse(channel: str, row: HeldOut) -> bool:
    if not row.recalibrated > HARD_STOPS.worse * row.nominal:
        return False
    low, _ = row.intervals.get("recalibrated", (row.recalibrated, row.recalibrated))
    return low > row.nominal and is_beyond_steps(channel, row.recalibrated)
