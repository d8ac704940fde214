"""A speed log that is turned against the hull, is not looked for, and would explain more than all that is named.

Where a log alone shows which way a vehicle goes, that it is turned is told only by the way in which thrusters push and
the hull drags against it. So no such angle is named (`catalogue.shown_by`). But a log that is put in askew is common,
and left out it bends the ratio of drags. So it is asked at last, where nothing is named too, and told in a sentence.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.showing.asked_at_last import better_than_named, value_of
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.foundation.units.quantity_text import said_quantity

TURNED = tuple(entry for entry in ENTRIES if entry.id in ("ground_log_misalignment", "speed_log_misalignment"))


def untold_turn(case: Case) -> Iterator[Objection]:
    """Object to effects of motion, or to none, where a log that is turned would explain more."""
    for entry in TURNED:
        for better in better_than_named(case, entry, ("u", "v"), HARD_STOPS.untold_alone):
            angle = value_of(better.tried, "angle")
            yield Objection(
                f"A {entry.topic} log that is turned by {said_quantity(abs(angle), 'rad')} to the "
                f"{'left' if angle > 0.0 else 'right'} would explain these recordings better"
                f"{' than all that is named' if case.named else ''}, by {better.nats:.0f} nats. Whether it is that, or "
                "how thrusters push and the hull drags, nothing tells beside one log: measure how it is mounted.",
                better.tried.candidate.robots,
            )
