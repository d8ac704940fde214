"""Sentences on how actuators follow their commands, by what they report."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from cocorosim_ros.diagnosis.criteria.following import TOLD_BY_ACTUATORS
from cocorosim_ros.diagnosis.findings import ActuatorReport, Estimate
from cocorosim_ros.wire.topics.actuator_feedback import OF_COMMAND

MEANT_TO_FOLLOW = (*OF_COMMAND, "rotation")
"""Quantities that follow a command in a sound actuator; a current does at best, a battery's voltage hardly."""


_FINEST = 4  # decimals, at most


def report_sentences(reports: Sequence[ActuatorReport]) -> Iterator[str]:
    """Sentences, one for each robot and quantity that tells something, and one for all that does not tell why not."""
    for robot, quantity in dict.fromkeys((each.robot, each.quantity) for each in reports):
        mine = [each for each in reports if (each.robot, each.quantity) == (robot, quantity)]
        told = [each for each in mine if each.numbers]
        if told:
            first, *others = told
            words = [f"{first.actuator} follows its command {_following(first)}"]
            words += [f"{each.actuator} {_following(each)}" for each in others]
            yield f"{robot}, {quantity} as reported: {'; '.join(words)}."
        if quantity in MEANT_TO_FOLLOW:
            for because in dict.fromkeys(each.because for each in mine if each.because):
                names = ", ".join(each.actuator for each in mine if each.because == because)
                yield f"{robot}, {quantity} as reported: {names} does not tell how it follows, since {because}."


def _following(report: ActuatorReport) -> str:
    """Words like 'by 0.66 s (0.64 to 0.69), at most 40 deg/s, and comes to 0.90 (0.88 to 0.92) of it'."""
    words = f"by {with_interval(report.numbers['lateness'])}"
    if "rate_limit" in report.numbers:
        words += f", at most {degrees(report.numbers['rate_limit'])}"
    gain = report.numbers["gain"]
    if gain.unit == "1" and not gain.holds(1.0) and abs(gain.value - 1.0) > TOLD_BY_ACTUATORS.weaker:
        words += f", and comes to {with_interval(gain)} of it"
    return words


def with_interval(estimate: Estimate) -> str:
    """A number with its interval and its unit: '0.66 s (0.64 to 0.69)'."""
    width = 0.5 * (estimate.high - estimate.low)
    decimals = _decimals(width if width > 0.0 else abs(estimate.value) / 10)
    value, low, high = (f"{each:.{decimals}f}" for each in (estimate.value, estimate.low, estimate.high))
    unit = "" if estimate.unit == "1" else f" {estimate.unit}"
    return f"{value}{unit} ({low} to {high})"


def degrees(rate: Estimate) -> str:
    """A rate [rad/s] in degrees."""
    return f"{math.degrees(rate.value):.3g} deg/s"


def _decimals(width: float) -> int:
    """Decimals that show a width to one digit, to two where the first is a one."""
    return min(max(-math.floor(math.log10(0.5 * width)), 0), _FINEST) if width > 0.0 else 0
