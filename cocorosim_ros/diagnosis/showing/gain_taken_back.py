"""Thrust lost against the motion that only takes back what the law of thrust that falls with speed adds there."""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of

FALLS_WITH_SPEED, AGAINST_MOTION = "advance_loss", "crashback_loss"


def gain_taken_back(case: Case) -> Iterator[Objection]:
    """Object to a loss against the motion that is, within both intervals, as large as the slope of the thrust.

    A thrust F (1 - slope u) is larger than at rest where the vehicle moves against it. A loss of the same slope there
    leaves F: what is missing is a thrust that falls along the motion alone, and nothing is lost against it.
    """
    felt = [found for found, _ in effects_of(case) if "slope" in found.parameters]
    falling = [found for found in felt if found.id == FALLS_WITH_SPEED]
    for found in (each for each in felt if each.id == AGAINST_MOTION):
        loss = found.parameters["slope"]
        slopes = [each.parameters["slope"] for each in falling if not set(each.robots).isdisjoint(found.robots)]
        if any(slope.low <= loss.high and loss.low <= slope.high for slope in slopes):
            yield Objection(
                "It takes back what a thrust that falls with speed would add against the motion, and no more: most "
                "likely thrust is lost along the motion alone.",
                effect=found,
            )
