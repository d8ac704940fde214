"""Names beside a law outside the catalogue of the same force: they may be pieces of a force of another form."""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.diagnosis.showing.remainder import HORIZONTAL
from cocorosim_ros.world.laws.law import subject_and_product


def beside_a_law(case: Case) -> Iterator[Objection]:
    """Object to an entry of motion beside a law outside the catalogue of the same channels that explains far more.

    What a law of two regressors leaves of a force of another form resembles one entry or another.
    """
    moving = [(found, named) for found, named in effects_of(case) if moves(named.candidate)]
    laws = [(found, named) for found, named in moving if named.candidate.entry.law is not None]
    for found, named in moving:
        if named.candidate.entry.law is None and any(
            found.nats < HARD_STOPS.beside_law * law.nats
            and _is_one_force(named.candidate.entry.channel, of_law.candidate.entry.channel)
            for law, of_law in laws
        ):
            yield Objection(
                "A law outside the catalogue explains far more of the same force: this may be what that law leaves of "
                "a force of another form.",
                effect=found,
            )


def beside_nameless(case: Case, law: str) -> Iterator[Objection]:
    """Object to effects of motion of the same channels as a law that is left over without a name; law: its text, or ''.

    The entry that resembles a force of another form most is named, and the rest of that force is left over.
    """
    if not law:
        return
    channel, _ = subject_and_product(law)
    for found, named in effects_of(case):
        if moves(named.candidate) and _is_one_force(named.candidate.entry.channel, channel):
            yield Objection(
                "A force of the same axes is left over that no entry of the catalogue explains: this may be a piece of "
                "a force of another form.",
                effect=found,
            )


def _is_one_force(channel: str, other: str) -> bool:
    """Tell whether forces of two channels act along the same axes, those of the level plane taken together."""
    return channel == other or {channel, other} <= set(HORIZONTAL)
