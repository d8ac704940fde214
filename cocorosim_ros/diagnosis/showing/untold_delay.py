"""Commands that act later than they are logged, which a lag of the thrusters stands for.

A dead time, or a clock of the computer that logs commands, delays all that a command does; no entry that is looked for
is such a delay, since beside one stream of readings it is that stream's. A lag of the same time explains most of it.
So where a lag of thrusters is named, the delay is asked in its stead.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.against.numbers import delay_entry
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.candidate import expand
from cocorosim_ros.diagnosis.naming.contest import Refined, log_evidence
from cocorosim_ros.diagnosis.naming.pruning import without
from cocorosim_ros.diagnosis.showing.actuator_names import LAG
from cocorosim_ros.diagnosis.showing.asked_at_last import asked_at_last
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.foundation.units.quantity_text import said_quantity


def untold_delay(case: Case) -> Iterator[Objection]:
    """Object to a lag of thrusters where a delay of the commands explains more, or as good as that."""
    for found, named in effects_of(case):
        if named.candidate.entry.id != LAG or case.base is None:
            continue
        smaller = without(case.final, named.candidate, case.base)
        every = expand([delay_entry()], smaller.tracks, smaller.rows)
        for candidate in (each for each in every if each.robots == named.candidate.robots):
            tried = asked_at_last(smaller, candidate)
            ahead = log_evidence(smaller) + tried.nats - log_evidence(case.final)
            if ahead > -NAMING.ambiguity:
                yield Objection(
                    f"Commands that act {_delay(tried)} later than they are logged explain these recordings "
                    f"{_compared(ahead)}: compare the clocks of commands and readings, or measure how fast the "
                    "thrusters follow.",
                    effect=found,
                )


def _delay(tried: Refined) -> str:
    """Words for the delay of a fit, of the first robot."""
    place, *_ = tried.candidate.places_among(tried.fit.unknowns)
    return said_quantity(tried.fit.unknowns[place].value(float(tried.fit.q[place])), "s")


def _compared(ahead: float) -> str:
    """Words for how well the delay does beside the lag."""
    return f"better than a lag does, by {ahead:.0f} nats" if ahead >= 1.0 else "as well as a lag does"
