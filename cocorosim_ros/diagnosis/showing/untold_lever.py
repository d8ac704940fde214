"""A lever of poses that is not looked for, and would explain more than all that is named.

Of what one stream of poses alone shows, the model alone tells a lever of the poses from the way in which a vehicle
drifts, so that no such lever is named (`catalogue.shown_by`). But a marker off the origin is the commonest fault of
motion capture. Left out, it becomes laws of the turn rate, each of which has much evidence. So it is asked at last, and
where it would explain more, what is named is suspected at most, and the lever is told in the reason.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.naming.contest import Refined, log_evidence
from cocorosim_ros.diagnosis.showing.asked_at_last import asked_at_last
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.foundation.units.quantity_text import said_quantity

LEVER = next(entry for entry in ENTRIES if entry.id == "pose_lever")


def untold_lever(case: Case) -> Iterator[Objection]:
    """Object to effects of motion of robots whose poses a lever would explain better than all that is named."""
    if case.base is None or not any(moves(named.candidate) for _, named in effects_of(case)):
        return
    explained = log_evidence(case.final) - log_evidence(case.base)
    for candidate in _untold(case.base):
        tried = asked_at_last(case.base, candidate)
        if tried.nats > explained:
            yield Objection(
                f"A marker or an antenna {_place(tried)} the body's origin would explain these poses better than all "
                f"that is named, by {tried.nats - explained:.0f} nats. Whether it is that, or how the vehicle drifts, "
                "poses of one stream cannot tell: measure where it sits on the hull, and give places of the origin.",
                candidate.robots,
            )


def _untold(base: Fit) -> list[Candidate]:
    """List the lever for all robots, if it is not looked for since no other instrument shows the heading."""
    told = {each.key for each in expand([LEVER], base.tracks, base.rows)}
    every = expand([LEVER], base.tracks, base.rows, known=("yaw",))
    return [each for each in every if each.key not in told and not each.known][:1]


def _place(tried: Refined) -> str:
    """Words for where a lever of a fit puts the point, of the first robot."""
    ahead, left = (
        tried.fit.unknowns[place].value(float(tried.fit.q[place]))
        for place in tried.candidate.places_among(tried.fit.unknowns)[:2]
    )
    return (
        f"{said_quantity(abs(ahead), 'm')} {'before' if ahead > 0.0 else 'behind'} and "
        f"{said_quantity(abs(left), 'm')} to the {'left' if left > 0.0 else 'right'} of"
    )
