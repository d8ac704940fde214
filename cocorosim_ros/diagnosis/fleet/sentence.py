"""The headline of a fleet, and words for drifts."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.criteria.fleet import DRIFT
from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fleet.drift import Drift
from cocorosim_ros.diagnosis.fleet.findings import FleetFindings
from cocorosim_ros.diagnosis.report.number_text import estimate_words

THRUST = "thrust_gain"
_WORDS = {THRUST: "thrust", "yaw_torque_gain": "yaw torque", "buoyancy_gain": "buoyancy"}


def fleet_sentence(found: FleetFindings) -> str:
    """The headline: one sentence of at most 25 words."""
    diagnosed = found.recordings - len(found.problems)
    if not diagnosed:
        return f"None of {_counted(found.recordings, 'recording')} could be diagnosed; the reasons stand below."
    if not found.tested:
        return (
            f"Drift cannot be told: no robot has {DRIFT.fewest_recordings} dated recordings or more among the "
            f"{diagnosed} that were diagnosed."
        )
    robots = list(dict.fromkeys(each.series.robot for each in found.drifting))
    of_all = f"of {_counted(len(found.tested), 'robot')}"
    if not robots:
        return (
            f"No number of the platform drifts by more than chance in any {of_all}, in "
            f"{_counted(diagnosed, 'diagnosed recording')}."
        )
    of_first = [each for each in found.drifting if each.series.robot == robots[0]]
    first = next((each for each in of_first if each.series.parameter == THRUST), of_first[0])
    if len(robots) == 1:
        return f"One {of_all} drifts: {first.series.robot} {drift_words(first)}."
    return f"{len(robots)} {of_all} drift, most clearly {first.series.robot}: it {drift_words(first)}."


def drift_words(drift: Drift) -> str:
    """Words for a drift, such as 'loses 1.02 % of its thrust a week'."""
    value, _ = rate_words(drift.per_week)
    name = number_words(drift.series.parameter)
    verb = "loses" if drift.per_week.value < 0.0 else "gains"
    amount = value.lstrip("\u2212+")
    return f"{verb} {amount} of its {name} a week" if drift.series.relative else f"{verb} {amount} in {name} a week"


def rate_words(per_week: Estimate) -> tuple[str, str]:
    """A drift and its 95 % interval as people read them: shares in percent."""
    if per_week.unit != "1":
        return estimate_words(per_week)
    return estimate_words(Estimate(100.0 * per_week.value, 100.0 * per_week.low, 100.0 * per_week.high, "%"))


def number_words(parameter: str) -> str:
    """A number of a platform as words."""
    return _WORDS.get(parameter, parameter.replace("_", " "))


def few(names: Sequence[str], most: int) -> str:
    """Some names, and how many more there are."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def _counted(count: int, thing: str) -> str:
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"
