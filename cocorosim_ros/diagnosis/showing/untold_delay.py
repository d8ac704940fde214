"""Commands that act later than they are logged, which a lag of the thrusters stands for.

A dead time, or a clock of the computer that logs commands, delays all that a command does; no entry that is looked for
is such a delay, since beside one stream of readings it is that stream's. A lag of the same time explains most of it.
So where a lag of thrusters is named, the delay is asked in its stead.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.against.numbers import delay_entry
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.screening import Screen
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.naming.contest import Refined, begin, log_evidence, refine
from cocorosim_ros.diagnosis.naming.pruning import without
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.showing.actuator_names import LAG
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
            tried = _tried(smaller, candidate)
            ahead = log_evidence(smaller) + tried.nats - log_evidence(case.final)
            if ahead > -NAMING.ambiguity:
                yield Objection(
                    f"Commands that act {_delay(tried)} later than they are logged explain these recordings "
                    f"{_compared(ahead)}: compare the clocks of commands and readings, or measure how fast the "
                    "thrusters follow.",
                    effect=found,
                )


def _tried(fit: Fit, candidate: Candidate) -> Refined:
    """Fit a delay beside all numbers of a fit."""
    scene = scene_of(fit.tracks, smoothed_tracks(fit), drag_form_of(fit))
    screen = Screen(fit, scene)
    return refine(begin(fit, screen.searched(screen.test(candidate)), scene), log_evidence(fit))


def _delay(tried: Refined) -> str:
    (place,) = tried.candidate.places_among(tried.fit.unknowns)
    return said_quantity(tried.fit.unknowns[place].value(float(tried.fit.q[place])), "s")


def _compared(ahead: float) -> str:
    """Words for how well the delay does beside the lag."""
    return f"better than a lag does, by {ahead:.0f} nats" if ahead >= 1.0 else "as well as a lag does"
