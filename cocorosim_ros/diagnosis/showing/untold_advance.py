"""A stream that comes earlier than all others, which a clock that runs wrong stands for.

Nothing comes before it happens, so no entry that is looked for is an early stream; but where a compass and a gyroscope
are filtered, and poses are not, these are early beside all the rest. Over a short recording a skew of their clock makes
much the same. So where a skew is named, a constant time of either sign is asked in its stead.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.against.numbers import of_either_sign
from cocorosim_ros.diagnosis.against.stamps import latency_entry
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.candidate import expand
from cocorosim_ros.diagnosis.naming.contest import Refined, log_evidence
from cocorosim_ros.diagnosis.naming.pruning import without
from cocorosim_ros.diagnosis.showing.asked_at_last import asked_at_last
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.foundation.units.quantity_text import said_quantity

WRONG_CLOCK = "clock_skew"


def untold_advance(case: Case) -> Iterator[Objection]:
    """Object to the skew of a clock where a constant time of that stream explains more, or as good as that."""
    for found, named in effects_of(case):
        if found.id != WRONG_CLOCK or found.topic is None or case.base is None:
            continue
        smaller = without(case.final, named.candidate, case.base)
        every = expand([of_either_sign(latency_entry(found.topic))], smaller.tracks, smaller.rows)
        for candidate in (each for each in every if each.robots == named.candidate.robots):
            tried = asked_at_last(smaller, candidate)
            if log_evidence(smaller) + tried.nats - log_evidence(case.final) > -NAMING.ambiguity:
                yield Objection(
                    f"Readings of {found.topic} that all come {_when(tried)} explain these recordings as well: filters "
                    "of the other instruments, or buffers of this one, do so.",
                    effect=found,
                )


def _when(tried: Refined) -> str:
    """Words for the time of a fit, of the first robot."""
    place, *_ = tried.candidate.places_among(tried.fit.unknowns)
    time = tried.fit.unknowns[place].value(float(tried.fit.q[place]))
    return f"{said_quantity(abs(time), 's')} {'late' if time > 0.0 else 'early'}"
