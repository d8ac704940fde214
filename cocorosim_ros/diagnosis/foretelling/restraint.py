"""Numbers of the platform that are held as its file gives them, since fitted ones foretell unseen data worse.

Numbers of a model that lacks a cause may stand for that cause. They then explain what was fitted and foretell nothing
else, also with all the effects that were found beside them: the fit has collapsed. Free runs say in which channel.
The numbers that turn the vehicle are held first where the heading is foretold worse, those that move it where its place
is, and all if that is not enough; what is fitted beside them is fitted anew. Nothing found on such a base is more than
suspected.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.criteria.fitting import CONVERGENCE
from cocorosim_ros.diagnosis.criteria.foretelling import RESTRAINT
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import climbed
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.foretelling.collapse import collapsed_channels
from cocorosim_ros.diagnosis.foretelling.exactness import EXACT
from cocorosim_ros.diagnosis.foretelling.foreseeable import foreseeable_parts
from cocorosim_ros.diagnosis.foretelling.free_runs import HeldOutFreeRuns, held_out_free_runs
from cocorosim_ros.foundation.units.quantity_text import said_quantity

_TURNED = "heading"  # channel of free runs
_OF_TURNS = "yaw"  # with which the names of numbers that turn a vehicle begin: yaw_drag, linear_drag.yaw


class Restrained(NamedTuple):
    """A base some of whose numbers are held, `held` by their names; () for one that is as it was fitted.

    worse: the channels that the model without held numbers foretold worse, each with its errors there.
    """

    base: Fit
    held: tuple[str, ...] = ()
    worse: tuple[tuple[str, HeldOut], ...] = ()

    @property
    def sentences(self) -> tuple[str, ...]:
        """Sentences on it, one for each channel that was foretold worse; () where nothing is held."""
        names = ", ".join(map(parameter_words, self.held))
        return tuple(
            f"With {names} fitted, the {channel} of unseen data was foretold worse than by the platform as given: it "
            f"erred by {said_quantity(row.augmented, row.unit)} instead of {said_quantity(row.nominal, row.unit)}; "
            "they are kept as the file gives them."
            for channel, row in self.worse
        )


def restrained(base: Fit, free: HeldOutFreeRuns) -> Restrained:
    """Hold numbers of a base whose found model has collapsed, as few kinds of them as stop the collapse.

    free: free runs with all that was found on this base. The base comes back as it is where its model has not
    collapsed, where too few runs tell it, or where holding numbers does not help. Where a model with held numbers is
    likelier than one with more, the climb of that one has ended at a local optimum: it goes on from there, with all
    numbers fitted, and nothing is held if that stops the collapse.
    """
    if len(free.runs) < RESTRAINT.fewest:
        return Restrained(base)
    worse = tuple((channel, free.table[channel]) for channel in _worse(free.table))
    for held in _choices(base.unknowns, [channel for channel, _ in worse]):
        kept = [place for place, unknown in enumerate(base.unknowns) if unknown not in held]
        fit = climbed(evaluated(replace(base, unknowns=tuple(base.unknowns[k] for k in kept), q=base.q[kept])))
        if fit.objective > base.objective + CONVERGENCE.worth and _foretells(freed := _freed(base, fit, kept)):
            return Restrained(freed)
        if _foretells(fit):
            return Restrained(fit, tuple(dict.fromkeys(each.owner.parameter for each in held)), worse)
    return Restrained(base)


def _freed(base: Fit, held: Fit, kept: Sequence[int]) -> Fit:
    """Climb with all numbers of a base from a fit with held ones; kept: places of those that it has."""
    q = np.zeros(len(base.unknowns))
    q[list(kept)] = held.q
    return climbed(evaluated(replace(base, q=q, noise=held.noise, q_noise=held.q_noise)))


def _foretells(fit: Fit) -> bool:
    """Tell whether a fit without any effects has not collapsed."""
    return not collapsed_channels(held_out_free_runs(foreseeable_parts(fit), fit).table)


def mends(table: Mapping[str, HeldOut], before: Mapping[str, HeldOut]) -> bool:
    """Tell whether what was found with held numbers foretells better than what was found before.

    It has to in the mean of the logarithms of errors in multiples of those of the platform as given, over the channels;
    and those in which the one before had collapsed, and all others, must not be worse than the platform as given.
    """
    again = [table[channel] for channel in _worse(before) if channel in table]
    mended = all(row.augmented <= RESTRAINT.worse * row.nominal for row in again)
    return mended and not _worse(table) and _mean_error(table, before) < _mean_error(before, table)


def _worse(table: Mapping[str, HeldOut]) -> tuple[str, ...]:
    """Channels that readings show and that are foretold worse; a course is bent by the very errors that were found."""
    read = {channel: row for channel, row in table.items() if row.against == "readings"}
    return collapsed_channels(read, "augmented", RESTRAINT.worse)


def _mean_error(table: Mapping[str, HeldOut], other: Mapping[str, HeldOut]) -> float:
    rows = [table[channel] for channel in EXACT if channel in table and channel in other]
    return sum(math.log(row.augmented / row.nominal) for row in rows if row.augmented > 0.0 and row.nominal > 0.0)


def _choices(unknowns: Sequence[Unknown], worse: Sequence[str]) -> list[list[Unknown]]:
    """Numbers to hold, fewest kinds first and all at last; worse: channels that have collapsed."""
    turning = [each for each in unknowns if _turns(each)]
    moving = [each for each in unknowns if not _turns(each)]
    kinds = [turning if _TURNED in worse else [], moving if set(worse) - {_TURNED} else []]
    whole = [*turning, *moving] if worse else []
    chosen = [kind for kind in (*kinds, whole) if kind]
    return [held for place, held in enumerate(chosen) if held not in chosen[:place]]


def _turns(unknown: Unknown) -> bool:
    return unknown.column.rpartition(".")[2].startswith(_OF_TURNS)
