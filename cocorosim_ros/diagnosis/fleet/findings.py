"""Findings about a fleet, typed: the content of fleet.html."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from cocorosim_ros.diagnosis.fleet.alike import Groups, alike
from cocorosim_ros.diagnosis.fleet.drift import Drift, drifts_of
from cocorosim_ros.diagnosis.fleet.in_common import InCommon, in_common
from cocorosim_ros.diagnosis.fleet.rows import Row
from cocorosim_ros.diagnosis.fleet.series import Series, series_of


@dataclass(frozen=True)
class FleetFindings:
    """Rows of a fleet, and what they show together. missing: recordings that are not diagnosed yet."""

    rows: tuple[Row, ...]
    series: tuple[Series, ...]
    drifts: tuple[Drift, ...]
    groups: Groups
    common: InCommon
    missing: int = 0

    @property
    def recordings(self) -> int:
        """Number of recordings that have rows."""
        return len({row.recording for row in self.rows})

    @property
    def problems(self) -> tuple[Row, ...]:
        """Rows of recordings that could not be diagnosed."""
        return tuple(row for row in self.rows if not row.diagnosed)

    @property
    def robots(self) -> tuple[str, ...]:
        """Names of all robots."""
        return tuple(sorted({row.robot for row in self.rows if row.robot}))

    @property
    def tested(self) -> tuple[str, ...]:
        """Names of the robots whose drift could be tested."""
        return tuple(sorted({each.series.robot for each in self.drifts}))

    @property
    def drifting(self) -> tuple[Drift, ...]:
        """Numbers that clearly drift, the clearest first."""
        return tuple(each for each in self.drifts if each.clear)


def fleet_findings(rows: Sequence[Row], missing: int = 0) -> FleetFindings:
    """Find what the rows of a fleet show together."""
    every = series_of(rows)
    drifts = drifts_of(every)
    diagnosed = [row for row in rows if row.diagnosed]
    groups = alike(diagnosed, every, drifts)
    return FleetFindings(tuple(rows), every, drifts, groups, in_common(diagnosed, every), missing)
