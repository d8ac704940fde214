"""Findings about a fleet as plain values: for `--json`, never NaN."""

from __future__ import annotations

import math
from typing import Any

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fleet.alike import Groups
from cocorosim_ros.diagnosis.fleet.drift import Drift
from cocorosim_ros.diagnosis.fleet.findings import FleetFindings
from cocorosim_ros.diagnosis.fleet.in_common import InCommon


def fleet_tree(found: FleetFindings) -> dict[str, Any]:
    """Counts, drifts of every robot and number, groups, what is common, and problems."""
    verdicts = [row.verdict for row in found.rows if row.verdict is not None]
    return {
        "recordings": found.recordings,
        "missing": found.missing,
        "robots": list(found.robots),
        "verdicts": {verdict: verdicts.count(verdict) for verdict in sorted(set(verdicts))},
        "drifts": [_drift(each) for each in found.drifts],
        "alike": _alike(found.groups),
        "in_common": _common(found.common),
        "problems": [{"recording": row.recording, "problem": row.problem} for row in found.problems],
    }


def _drift(drift: Drift) -> dict[str, Any]:
    return {
        "robot": drift.series.robot,
        "parameter": drift.series.parameter,
        "drifts": drift.clear,
        "per_week": _estimate(drift.per_week),
        "relative": drift.series.relative,
        "scatter": drift.scatter,
        "p": drift.chance,
        "p_of_all": drift.adjusted,
        "recordings": len(drift.series.recordings),
        "weeks": drift.span,
    }


def _alike(groups: Groups) -> dict[str, Any]:
    return {
        "limit": _finite(groups.limit),
        "not_compared": groups.not_compared,
        "groups": [
            {
                "effects": list(group.effects),
                "members": [{"recording": row.recording, "robot": row.robot} for row in group.rows],
            }
            for group in groups.groups
        ],
    }


def _common(common: InCommon) -> dict[str, Any]:
    return {
        "effects": [
            {
                "id": each.id,
                "found": each.found,
                "could_show_it": each.able,
                "confirmed": each.confirmed,
                "parameters": {name: _estimate(estimate) for name, estimate in each.parameters.items()},
            }
            for each in common.effects
        ],
        "shifts": [
            {
                "parameter": each.parameter,
                "nominal": each.nominal,
                **_estimate(each.pooled),
                "scatter": each.scatter,
                "robots": each.robots,
                "same_side": each.same_side,
            }
            for each in common.shifts
        ],
    }


def _estimate(found: Estimate) -> dict[str, Any]:
    return {"value": _finite(found.value), "ci95": [_finite(found.low), _finite(found.high)], "unit": found.unit}


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
