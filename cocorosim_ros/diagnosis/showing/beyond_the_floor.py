"""Free runs that err far more than the noise floor, whatever is named.

The floor is that of a model with a smooth force without a name, learnt from state, commands and place. What it gains
beyond all that was fitted and named is thus repeatable, and missing: as where the range of a number in the platform's
file leaves the true one out, or where a law has no name here.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.criteria.showing import BEYOND_FLOOR
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.exactness import is_beyond_steps, is_exact
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.foundation.units.quantity_text import plain_number, quantity_words


def beyond_the_floor(case: Case) -> Iterator[Objection]:
    """Object to effects beside which free runs err far more than the floor: they explain a part of something else."""
    for channel in channels_beyond_the_floor(case):
        row = case.table[channel]
        yield Objection(
            f"Free runs err by {quantity_words(row.augmented, row.unit)} in {channel}, "
            f"{plain_number(row.augmented / row.noise_floor)} times the noise floor: something that follows from "
            "motion, commands or place is still missing there, which neither a name nor the platform's numbers stand "
            "for."
        )


def channels_beyond_the_floor(case: Case) -> tuple[str, ...]:
    """Channels of the free runs, against readings, in which the model with its effects errs far more than the floor."""
    rows = rows_of_motion(case)
    return tuple(channel for channel, row in rows.items() if row.augmented > BEYOND_FLOOR.clear * row.noise_floor)


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
