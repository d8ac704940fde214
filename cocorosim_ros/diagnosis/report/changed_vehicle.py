"""A vehicle that was compared with itself, as far as a platform file can hold it: its numbers with what has changed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis, Estimate, FoundEffect, Recalibrated
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS

ASYMMETRY = "thruster_asymmetry"
GAINS = ("thrust_gain", "yaw_torque_gain")


def as_platform(diagnosis: Diagnosis) -> Diagnosis:
    """Make the diagnosis that a platform file is written from: the one itself where nothing else was compared with.

    The numbers are those that were learned, with the changes in them. A delay of the commands, and one of many
    thrusters that is weak, are left out, as no platform file has them; so are effects that were learned without a name.
    """
    if diagnosis.against is None:
        return diagnosis
    effects = tuple(_plain(effect) for effect in diagnosis.effects if _is_known(effect))
    return replace(diagnosis, all_recalibrated=_numbers(diagnosis.against, diagnosis), effects=effects)


def _is_known(effect: FoundEffect) -> bool:
    return effect.id in EFFECTS or effect.id in ERRORS or effect.law is not None or effect.correction is not None


def _plain(effect: FoundEffect) -> FoundEffect:
    """Leave an asymmetry with the number that a platform file has of it."""
    if effect.id != ASYMMETRY:
        return effect
    return replace(effect, parameters={"difference": effect.parameters["difference"]})


def _numbers(against: Comparison, diagnosis: Diagnosis) -> tuple[Recalibrated, ...]:
    """Numbers of the learned vehicle, times what has changed in them."""
    changed = {(each.parameter, each.robots): each for each in diagnosis.recalibrated}
    found = []
    for before in against.before:
        factor = _of_one_side(diagnosis.effects, before)
        own = changed.get((before.parameter, before.robots))
        both = changed.get(("thrust_gain", before.robots)) if before.parameter in GAINS else None
        if both is not None:
            factor *= both.estimate.value
        estimate = before.estimate if own is None or both is not None else own.estimate
        found.append(replace(before, estimate=_times(estimate, factor)))
    return tuple(found)


def _of_one_side(effects: Sequence[FoundEffect], number: Recalibrated) -> float:
    """Mean gain of two thrusters of which one has a gain of its own."""
    factor = 1.0
    for effect in effects:
        if effect.id == ASYMMETRY and number.parameter in GAINS and set(number.robots) <= set(effect.robots):
            for name, gain in effect.parameters.items():
                factor *= 1.0 if name == "difference" else 0.5 * (1.0 + gain.value)
    return factor


def _times(estimate: Estimate, factor: float) -> Estimate:
    return Estimate(estimate.value * factor, estimate.low * factor, estimate.high * factor, estimate.unit)
