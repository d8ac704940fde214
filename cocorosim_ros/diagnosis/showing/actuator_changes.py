"""Sentences on actuators that follow otherwise than in the recordings that these are compared with."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from cocorosim_ros.diagnosis.criteria.following import TOLD_BY_ACTUATORS
from cocorosim_ros.diagnosis.findings import ActuatorReport, Estimate
from cocorosim_ros.diagnosis.showing.actuator_sentences import degrees, with_interval

_BEFORE = "in the recordings of --against"


def change_sentences(reports: Sequence[ActuatorReport]) -> Iterator[str]:
    """Sentences on actuators that follow later, less far or more slowly than before, or the other way round."""
    for each in reports:
        name = f"{each.robot}: {each.actuator} ({each.quantity} as reported)"
        if not each.before:
            continue
        if not each.numbers:
            late = with_interval(each.before["lateness"])
            yield f"{name} followed its command by {late} {_BEFORE}, and now it does not tell, since {each.because}."
            continue
        now, before = each.numbers, each.before
        if has_changed(now["lateness"], before["lateness"], TOLD_BY_ACTUATORS.later):
            word = "later" if now["lateness"].value > before["lateness"].value else "sooner"
            yield (
                f"{name} follows its command {word} than {_BEFORE}: by {with_interval(now['lateness'])}, and there by "
                f"{with_interval(before['lateness'])}."
            )
        if has_changed(now["gain"], before["gain"], TOLD_BY_ACTUATORS.weaker * abs(before["gain"].value)):
            word = "less" if abs(now["gain"].value) < abs(before["gain"].value) else "more"
            yield (
                f"{name} follows its command {word} than {_BEFORE}: {with_interval(now['gain'])} of what is commanded, "
                f"and there {with_interval(before['gain'])}."
            )
        if {"rate_limit"} <= now.keys() & before.keys():
            least = TOLD_BY_ACTUATORS.weaker * before["rate_limit"].value
            if has_changed(now["rate_limit"], before["rate_limit"], least):
                yield (
                    f"{name} turns at another rate than {_BEFORE}: at most {degrees(now['rate_limit'])}, and there "
                    f"{degrees(before['rate_limit'])}."
                )


def has_changed(now: Estimate, before: Estimate, least: float) -> bool:
    """Tell whether two numbers differ by more than both intervals together, and by so much that it matters."""
    both = math.hypot(now.high - now.value, before.high - before.value)
    return abs(now.value - before.value) > max(both, least)
