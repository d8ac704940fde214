"""Free runs that err far more than another model shows to be possible, whatever is named.

The noise floor is the error of a model with a smooth force without a name, learnt from state, commands and place. What
it gains beyond all that was fitted and named is thus repeatable, and missing: as where the range of a number in the
platform's file leaves the true one out, or where a law has no name here.
It is no bound, though: such a force stands for no delay, stamp or centre of mass, and a model with these may err less.
So the least error of all models without the effects is what counts as possible: a floor that is too high excuses none
that errs far more than the platform's own numbers do. Where the model with the effects errs less than all of these,
the floor is known to be too high there, but not by how much: nothing is stopped here then.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from cocorosim_ros.diagnosis.criteria.showing import BEYOND_FLOOR
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.exactness import is_beyond_steps, is_exact
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.foundation.units.quantity_text import plain_number, quantity_words


def beyond_the_floor(case: Case) -> Iterator[Objection]:
    """Object to effects beside which free runs err far more than others: they explain a part of something else."""
    for channel in channels_beyond_the_floor(case):
        row = case.table[channel]
        best = _best_of_others(row)
        yield Objection(
            f"Free runs err by {quantity_words(row.augmented, row.unit)} in {channel}, "
            f"{plain_number(row.augmented / best.error)} times as much as with {best.model}: something that follows "
            "from motion, commands or place is still missing there, or stands wrongly in the model."
        )


def channels_beyond_the_floor(case: Case) -> tuple[str, ...]:
    """Channels of the free runs, against readings, in which the model with its effects errs far more than another."""
    rows = rows_of_motion(case)
    return tuple(
        channel for channel, row in rows.items() if row.augmented > BEYOND_FLOOR.clear * _best_of_others(row).error
    )


class _Best(NamedTuple):
    """The least error of a row, and the model that makes it, in words."""

    error: float
    model: str


def _best_of_others(row: HeldOut) -> _Best:
    """The best of the models without the effects."""
    others = (
        _Best(row.noise_floor, "a force without a name"),
        _Best(row.recalibrated, "the fitted numbers alone"),
        _Best(row.nominal, "the platform as given"),
    )
    return min(others, key=lambda each: each.error)


def rows_of_motion(case: Case) -> dict[str, HeldOut]:
    """Select the channels of free runs that judge named effects of motion: against readings, beyond the filter's steps.

    None beside a named error of readings: free runs begin with it, unless other readings show the same.
    """
    if is_exact(case.table) or not all(moves(effect.candidate) for effect in case.named):
        return {}
    return {
        channel: row
        for channel, row in case.table.items()
        if channel in CHANNELS and row.against == "readings" and is_beyond_steps(channel, row.augmented)
    }
