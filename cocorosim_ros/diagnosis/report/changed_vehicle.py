"""A vehicle that was compared with itself, as far as a platform file can hold it: its numbers with what has changed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.against.numbers import DELAY
from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis, Estimate, FoundEffect, Recalibrated
from cocorosim_ros.diagnosis.naming.single_thrusters import ONE_THRUSTER
from cocorosim_ros.diagnosis.naming.steering_trims import STEERING_TRIM
from cocorosim_ros.diagnosis.tracks.own_numbers import gain_key, own_numbers, trim_key
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS

ASYMMETRY = "thruster_asymmetry"
GAINS = ("thrust_gain", "yaw_torque_gain")


def as_platform(diagnosis: Diagnosis, platform: Platform) -> Diagnosis:
    """Make the diagnosis that a platform file is written from: gains of thrusters and trims are numbers in it.

    Where other recordings were compared with, the numbers are those that were learned, with the changes in them;
    effects of the platform's file stay in a number that has changed, with the change added. platform: the one that was
    given. Commands that act before they are logged are left out, as no vehicle has them; so are effects that were
    learned without a name.
    """
    of_one = [effect for effect in diagnosis.effects if effect.id in (ONE_THRUSTER, STEERING_TRIM)]
    others = tuple(effect for effect in diagnosis.effects if effect not in of_one)
    numbers = diagnosis.all_recalibrated or diagnosis.recalibrated
    if diagnosis.against is not None:
        learned = diagnosis.against.before
        others = tuple(_with_known(_plain(each), learned, platform) for each in others if _is_known(each))
        numbers = _numbers(diagnosis.against, diagnosis)
    return replace(diagnosis, all_recalibrated=_with_numbers(numbers, of_one, platform), effects=others)


def _with_numbers(
    numbers: Sequence[Recalibrated], of_one: Sequence[FoundEffect], platform: Platform
) -> tuple[Recalibrated, ...]:
    """Add gains of thrusters and trims to fitted numbers: as a factor of the number that is there, or added to it.

    Where none is fitted it is that of the file. of_one: the effects that are such gains and trims.
    """
    found = {(each.parameter, each.robots): each for each in numbers}
    for effect in of_one:
        given = own_numbers(platform.of_robot(effect.robots[0]))
        for name, change in effect.parameters.items():
            key = gain_key(name) if effect.id == ONE_THRUSTER else trim_key(name)
            before = found.get((key, effect.robots))
            value = before.estimate.value if before is not None else given[key].value
            now = _times(change, value) if effect.id == ONE_THRUSTER else _plus(change, value)
            found[key, effect.robots] = Recalibrated(key, given[key].value, now, effect.robots)
    return tuple(found.values())


def _is_known(effect: FoundEffect) -> bool:
    if effect.id == DELAY and effect.parameters["delay"].value < 0.0:
        return False
    return effect.id in EFFECTS or effect.id in ERRORS or effect.law is not None or effect.correction is not None


def _plain(effect: FoundEffect) -> FoundEffect:
    """Leave an asymmetry with the number that a platform file has of it."""
    if effect.id != ASYMMETRY:
        return effect
    return replace(effect, parameters={"difference": effect.parameters["difference"]})


def _with_known(effect: FoundEffect, learned: Sequence[Recalibrated], platform: Platform) -> FoundEffect:
    """Add what the vehicle had of an effect before to what has changed in it, number by number.

    learned: numbers of the learned vehicle; what is not among them is as the platform's file has it.
    """
    before = dict(platform.of_robot(effect.robots[0] if effect.robots else "").effects.get(effect.id, {}))
    for number in learned:
        if number.parameter.startswith(f"{effect.id}.") and number.robots == effect.robots:
            before[number.parameter.removeprefix(f"{effect.id}.")] = number.estimate.value
    neutral = {part.name: part.neutral for part in EFFECTS[effect.id].parameters} if effect.id in EFFECTS else {}

    def whole(name: str, change: Estimate) -> Estimate:
        if name not in before or name not in neutral:
            return change
        more = before[name] - neutral[name]
        return replace(change, value=change.value + more, low=change.low + more, high=change.high + more)

    return replace(effect, parameters={name: whole(name, each) for name, each in effect.parameters.items()})


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


def _plus(estimate: Estimate, more: float) -> Estimate:
    return Estimate(estimate.value + more, estimate.low + more, estimate.high + more, estimate.unit)


def _times(estimate: Estimate, factor: float) -> Estimate:
    return Estimate(estimate.value * factor, estimate.low * factor, estimate.high * factor, estimate.unit)
