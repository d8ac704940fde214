"""Force that is left over although effects are named: a law that it follows says that a name is not the whole cause.

A force that no entry of the catalogue is takes the name of the one that resembles it most, with much evidence and free
runs that gain. But where the name stands for another law, most of that law is left over, and a law of one or two
regressors finds it there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.catalogue.pair_laws import laws_of_open_set, pair_laws
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.criteria.showing import REMAINDER
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.screening import Screen
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.naming.promising_laws import law_candidates
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.laws.law import Law

HORIZONTAL = ("surge", "sway", "world_x", "world_y")
SAME_FORCE = {name: HORIZONTAL for name in HORIZONTAL}
"""Equations whose forces are one force in other axes, by each of them."""


class LeftOver(NamedTuple):
    """A law that the force left over follows, its evidence [nats], and on which robots."""

    law: Law
    nats: float
    robots: tuple[str, ...]


def left_over(fit: Fit, courses: Sequence[Smoothed]) -> tuple[LeftOver, ...]:
    """List the laws by which the force that a fit lacks goes, those with most evidence first; () where none is clear.

    courses: the smoothed course of each track under the fit.
    """
    scene = scene_of(fit.tracks, courses)
    screen = Screen(fit, scene)
    laws = [*pair_laws(scene), *laws_of_open_set(scene)]
    tested = [screen.test(each) for each in law_candidates(laws, screen, courses)]
    found = [
        LeftOver(each.candidate.entry.form, each.nats, each.candidate.robots)
        for each in tested
        if each.nats >= NAMING.nameless and each.candidate.entry.form is not None
    ]
    return tuple(sorted(found, key=lambda each: -each.nats))


def remainder(case: Case) -> Iterator[Objection]:
    """Object to effects of motion beside which nearly as much is left over in the same equation of the same robot."""
    moving = [(found, named) for found, named in effects_of(case) if moves(named.candidate)]
    if not moving:
        return
    every = left_over(case.final, case.courses)
    for found, named in moving:
        own = _equations_of(named.candidate.entry)
        rest = next((one for one in every if one.law.of in own and not set(one.robots).isdisjoint(found.robots)), None)
        if rest is not None and rest.nats > REMAINDER.share * found.nats:
            yield Objection(
                f"What is left of the force still follows {rest.law.product.text} ({rest.law.of}, {rest.nats:.0f} "
                "nats), so that another law may be the cause.",
                effect=found,
            )


def _equations_of(entry: Entry) -> tuple[str, ...]:
    """Equations in which the rest of an effect may be left: those of its force; what changes thrust turns, too."""
    effect = EFFECTS.get(entry.id)
    turns = effect is not None and effect.thrust is not None
    return (entry.channel, *SAME_FORCE.get(entry.channel, ()), *(("yaw",) if turns else ()))
