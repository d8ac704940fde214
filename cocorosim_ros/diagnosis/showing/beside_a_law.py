"""Names beside far stronger ones of the same force, or of the same reading: they may be pieces of another form."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from cocorosim_ros.diagnosis.catalogue.shown_by import own_state
from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.diagnosis.showing.remainder import HORIZONTAL
from cocorosim_ros.world.laws.law import subject_and_product
from cocorosim_ros.world.sensors.errors import ERRORS

Named = tuple[FoundEffect, NamedEffect]
"""An effect as it is reported, and the named effect that it is of."""


def beside_a_law(case: Case) -> Iterator[Objection]:
    """Object to an entry of motion beside a law outside the catalogue of the same channels that explains far more.

    What a law of two regressors leaves of a force of another form resembles one entry or another.
    """
    moving = [pair for pair in effects_of(case) if moves(pair[1].candidate)]
    yield from _outweighed(
        [pair for pair in moving if pair[1].candidate.entry.law is None],
        [pair for pair in moving if pair[1].candidate.entry.law is not None],
        lambda entry, law: _is_one_force(entry[1].candidate.entry.channel, law[1].candidate.entry.channel),
        "A law outside the catalogue explains far more of the same force: this may be what that law leaves of a force "
        "of another form.",
    )


def beside_an_error(case: Case) -> Iterator[Objection]:
    """Object to a law of readings beside an error of the catalogue that explains far more of what shows the same state.

    An error that drifts by another form than its law leaves a rest that follows whatever changes as slowly.
    """
    of_readings = [pair for pair in effects_of(case) if not moves(pair[1].candidate)]
    yield from _outweighed(
        [pair for pair in of_readings if pair[1].candidate.entry.form is not None],
        [pair for pair in of_readings if pair[1].candidate.entry.id in ERRORS],
        lambda law, error: _shows_same(law[1], error[0].id) and not set(law[0].robots).isdisjoint(error[0].robots),
        "An error of an instrument that shows the same explains far more: this may be what that error leaves where it "
        "has another form.",
    )


def _outweighed(
    weak: Sequence[Named], strong: Sequence[Named], is_one: Callable[[Named, Named], bool], sentence: str
) -> Iterator[Objection]:
    """Object, by a sentence, to each of the weak beside a strong one of the same that explains far more."""
    for each in weak:
        if any(each[0].nats < HARD_STOPS.beside_law * other[0].nats and is_one(each, other) for other in strong):
            yield Objection(sentence, effect=each[0])


def _shows_same(law: NamedEffect, error: str) -> bool:
    """Tell whether the reading of a law shows a state that readings show which an error of the catalogue changes."""
    form = law.candidate.entry.form
    states = {state for change in ERRORS[error].changes for state in own_state(change.kind)}
    return form is not None and not states.isdisjoint(own_state(form.of))


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
