"""Collapse of a fit: its model foretells unseen data worse than the platform as given.

A base that lacks something may bend its numbers to stand for that, and then foretell worse than numbers that were never
fitted. If the effects that are named bring the errors clearly below those of the platform as given, that is what
happened, and no sign against them. Seven fits of made recordings, whose bases alone had collapsed, were cured so, all
with the right names; three of a ferry, with doubtful ones, were not.
"""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.exactness import EXACT, is_beyond_steps


def collapsed_channels(
    table: Mapping[str, HeldOut], model: str = "recalibrated", worse: float = HARD_STOPS.worse
) -> tuple[str, ...]:
    """Name the channels of free runs by which a fit has collapsed: those that clearly err more, and not by steps.

    model: 'recalibrated', or 'augmented' for the one with the effects. worse: error from which it is one, in multiples
    of that of the platform as given. A recalibrated model has not collapsed where effects cure it.
    """
    found = [channel for channel in EXACT if channel in table and _is_worse(channel, table[channel], model, worse)]
    return tuple(channel for channel in found if model == "augmented" or not _is_cured(table[channel], worse))


def _is_worse(channel: str, row: HeldOut, model: str, worse: float) -> bool:
    error: float = getattr(row, model)
    if not error > worse * row.nominal:
        return False
    low, _ = row.intervals.get(model, (error, error))
    return low > row.nominal and is_beyond_steps(channel, error)


def _is_cured(row: HeldOut, worse: float) -> bool:
    """Tell whether the model with the effects errs clearly less than the platform as given."""
    _, high = row.intervals.get("augmented", (row.augmented, row.augmented))
    return worse * row.augmented < row.nominal and high < row.nominal
