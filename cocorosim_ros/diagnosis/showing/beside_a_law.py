"""Names beside far stronger ones of the same force, or of the same reading: they may be pieces of another form."""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.catalogue.shown_by import own_state
from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.diagnosis.showing.remainder import HORIZONTAL
from cocorosim_ros.world.laws.law import subject_and_product
from cocorosim_ros.world.sensors.errors import ERRORS


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


def beside_an_error(case: Case) -> Iterator[Objection]:
    """Object to a law of readings beside an error of the catalogue that explains far more of what shows the same state.

    An error that drifts by another form than its law leaves a rest that follows whatever changes as slowly.
    """
    of_readings = [(found, named) for found, named in effects_of(case) if not moves(named.candidate)]
    errors = [(found, named) for found, named in of_readings if named.candidate.entry.id in ERRORS]
    for found, named in of_readings:
        form = named.candidate.entry.form
        if form is not None and any(
            found.nats < HARD_STOPS.beside_law * error.nats
            and set(own_state(form.of)) & _states_of(error.id)
            and not set(found.robots).isdisjoint(error.robots)
            for error, _ in errors
        ):
            yield Objection(
                "An error of an instrument that shows the same explains far more: this may be what that error leaves "
                "where it has another form.",
                effect=found,
            )


def _states_of(error: str) -> set[str]:
    """States that the readings show which an error of the catalogue changes."""
    return {state for change in ERRORS[error].changes for state in own_state(change.kind)}


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
