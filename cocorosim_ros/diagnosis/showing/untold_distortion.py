"""A distortion of a compass that is not looked for, and would explain more than all that is named.

Where a compass alone shows the heading, how it errs from heading to heading is told only by the way in which places
move on against it, which is what moving water changes too. So no such distortion is named (`catalogue.shown_by`). But
iron near a compass is common, and left out it becomes a current. So it is asked at last, and where it would explain
more, what is named is suspected at most, and the distortion is told in the reason.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.showing.asked_at_last import better_than_named, value_of
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.foundation.units.quantity_text import said_quantity

DISTORTION = next(entry for entry in ENTRIES if entry.id == "compass_distortion")


def untold_distortion(case: Case) -> Iterator[Objection]:
    """Object to effects of motion of robots whose compass, if distorted, would explain more than all that is named."""
    for better in better_than_named(case, DISTORTION, ("yaw",)):
        most = math.hypot(value_of(better.tried, "sin"), value_of(better.tried, "cos"))
        yield Objection(
            f"A compass that is off by up to {said_quantity(most, 'rad')} from heading to heading would explain these "
            f"recordings better than all that is named, by {better.nats:.0f} nats. Whether it is that, or water or air "
            "that moves, nothing tells beside one compass: turn the vehicle slowly through full circles at one place.",
            better.tried.candidate.robots,
        )
