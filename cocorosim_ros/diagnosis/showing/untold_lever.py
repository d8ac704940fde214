"""A lever of poses that is not looked for, and would explain more than all that is named.

Of what one stream of poses alone shows, the model alone tells a lever of the poses from the way in which a vehicle
drifts, so that no such lever is named (`catalogue.shown_by`). But a marker off the origin is the commonest fault of
motion capture. Left out, it becomes laws of the turn rate, each of which has much evidence. So it is asked at last, and
where it would explain more, what is named is suspected at most, and the lever is told in the reason.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.naming.contest import Refined
from cocorosim_ros.diagnosis.showing.asked_at_last import better_than_named, value_of
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.foundation.units.quantity_text import said_quantity

LEVER = next(entry for entry in ENTRIES if entry.id == "pose_lever")


def untold_lever(case: Case) -> Iterator[Objection]:
    """Object to effects of motion of robots whose poses a lever would explain better than all that is named."""
    for better in better_than_named(case, LEVER, ("yaw",)):
        yield Objection(
            f"A marker or an antenna {_place(better.tried)} the body's origin would explain these poses better than "
            f"all that is named, by {better.nats:.0f} nats. Whether it is that, or how the vehicle drifts, poses of "
            "one stream cannot tell: measure where it sits on the hull, and give places of the origin.",
            better.tried.candidate.robots,
        )


def _place(tried: Refined) -> str:
    """Words for where a lever of a fit puts the point, of the first robot."""
    ahead, left = value_of(tried, "ahead"), value_of(tried, "left")
    return (
        f"{said_quantity(abs(ahead), 'm')} {'before' if ahead > 0.0 else 'behind'} and "
        f"{said_quantity(abs(left), 'm')} to the {'left' if left > 0.0 else 'right'} of"
    )
