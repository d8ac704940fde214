"""Differences between two sets of recordings with 95 % intervals: numbers of the platform, and effects."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.against.between_recordings import added_variances
from cocorosim_ros.diagnosis.against.control import Alike
from cocorosim_ros.diagnosis.against.numbers import THRUST
from cocorosim_ros.diagnosis.catalogue.meaning import between
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, Recalibrated
from cocorosim_ros.diagnosis.fitting.base_model import RECALIBRATED
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming
from cocorosim_ros.diagnosis.naming.single_thrusters import ONE_THRUSTER, SIDES, thruster_of
from cocorosim_ros.diagnosis.naming.steering_trims import STEERING_TRIM, trimmed
from cocorosim_ros.diagnosis.showing.estimates import Fitted, found_effects
from cocorosim_ros.diagnosis.tracks.columns import COLUMN

_COLUMN_OF = {name: (column, unit) for column, (name, unit) in RECALIBRATED.items()}


def with_spread_between(numbers: Sequence[Fitted], naming: Naming, alike: Alike) -> tuple[Fitted, ...]:
    """Copy fitted numbers, those of differences with the spread between recordings that are alike.

    alike: recordings of the sound vehicle.
    """
    variances = np.zeros(len(numbers))
    for effect in naming.named:
        added = added_variances(effect.candidate, naming.fit, alike)
        for place, number in enumerate(numbers):
            if effect.candidate.owns(number.unknown):
                variances[place] = added.get(number.unknown.column, 0.0)
    spread = np.hypot([number.spread for number in numbers], np.sqrt(variances)).tolist()
    return tuple(replace(number, spread=wider) for number, wider in zip(numbers, spread, strict=True))


def differing_numbers(naming: Naming, numbers: Sequence[Fitted]) -> tuple[Recalibrated, ...]:
    """Numbers of the platform that differ: the value before as nominal one, and the value now.

    numbers: those of the fit.
    """
    rows = naming.fit.filled
    found = []
    for effect in naming.named:
        if not _is_number(effect):
            continue
        for each in numbers:
            if effect.candidate.owns(each.unknown):
                column, unit = _COLUMN_OF.get(effect.candidate.entry.id, ("", "1"))
                factor = each.unknown.value(each.q)
                now = (
                    float(rows[each.unknown.tracks[0], COLUMN[column]])
                    if effect.candidate.entry.id != THRUST
                    else factor
                )
                found.append(
                    Recalibrated(
                        effect.candidate.entry.id, now / factor, _times(each.estimate, now / factor, unit),
                        each.unknown.owner.robots,
                    )
                )  # fmt: skip
    return tuple(found)


def differing_effects(naming: Naming, numbers: Sequence[Fitted]) -> tuple[FoundEffect, ...]:
    """All other differences, the one with most evidence first; numbers: those of the fit."""
    named = [effect for effect in naming.named if not _is_number(effect)]
    return found_effects(naming.fit, named, numbers)


def as_asymmetries(effects: Sequence[FoundEffect], thrusters: Sequence[str]) -> tuple[FoundEffect, ...]:
    """Call one weak thruster of two an asymmetry: its own gain is given beside the `difference` of the contract.

    One of more has its name as that of its number alone, and so has the trim of a rudder or fin.
    thrusters: names, in order.
    """
    return tuple(_as_asymmetry(effect, thrusters) for effect in effects)


def _is_number(effect: NamedEffect) -> bool:
    return effect.candidate.entry.id in (THRUST, *_COLUMN_OF)


def _times(estimate: Estimate, before: float, unit: str) -> Estimate:
    least, most = estimate.limits
    return replace(
        estimate, value=estimate.value * before, low=estimate.low * before, high=estimate.high * before, unit=unit,
        limits=(least * before, most * before),
    )  # fmt: skip


def _as_asymmetry(effect: FoundEffect, thrusters: Sequence[str]) -> FoundEffect:
    if trimmed(effect.id):
        return replace(effect, id=STEERING_TRIM)
    if not thruster_of(effect.id):
        return effect
    if len(thrusters) != SIDES:
        return replace(effect, id=ONE_THRUSTER)
    ((name, gain),) = effect.parameters.items()
    sign = 1.0 if name == thrusters[1] else -1.0
    value, *ends = (sign * 2.0 * (each - 1.0) / (each + 1.0) for each in (gain.value, gain.low, gain.high))
    difference = Estimate(value, min(ends), max(ends), "1", between("thruster_asymmetry.difference"))
    return replace(effect, id="thruster_asymmetry", parameters={"difference": difference, name: gain})
