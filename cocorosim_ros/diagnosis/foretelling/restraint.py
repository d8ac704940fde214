"""Numbers of the platform that are held as its file gives them, since fitted ones foretell unseen data worse.

A model that lacks a cause gives its own numbers the task of that cause. They then explain what was fitted and foretell
nothing else: the fit has collapsed. Free runs say in which channel. The numbers that turn the vehicle are held first
where the heading is foretold worse, those that move it where its place is, and all if that is not enough; what is
fitted beside them is fitted anew. Nothing found on such a base is more than suspected.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import climbed
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.foretelling.collapse import collapsed_channels
from cocorosim_ros.diagnosis.foretelling.free_runs import held_out_free_runs
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen, unseen_parts

_TURNED = "heading"  # channel of free runs
_OF_TURNS = "yaw"  # with which the names of numbers that turn a vehicle begin: yaw_drag, linear_drag.yaw


class Restrained(NamedTuple):
    """A base whose free runs have not collapsed, or which holding numbers does not help; held: their names.

    worse: the channels that the fit without held numbers foretold worse, each with its errors there.
    """

    base: Fit
    unseen: Unseen
    held: tuple[str, ...] = ()
    worse: tuple[tuple[str, HeldOut], ...] = ()

    @property
    def sentences(self) -> tuple[str, ...]:
        """What is said of it: a sentence for each channel that was foretold worse; () where nothing is held."""
        names = ", ".join(self.held)
        return tuple(
            f"With {names} fitted, the {channel} of unseen data was foretold worse than by the platform as given: by "
            f"{row.recalibrated:.3g} for {row.nominal:.3g} {row.unit}; they are kept as the file gives them."
            for channel, row in self.worse
            if self.held
        )


def restrained(base: Fit) -> Restrained:
    """Hold numbers of a base whose free runs have collapsed, as few kinds of them as stop the collapse."""
    unseen = unseen_parts(base)
    table = held_out_free_runs(unseen, base).table
    worse = tuple((channel, table[channel]) for channel in collapsed_channels(table))
    if not worse:
        return Restrained(base, unseen)
    for held in _choices(base.unknowns, [channel for channel, _ in worse]):
        kept = [place for place, unknown in enumerate(base.unknowns) if unknown not in held]
        fit = climbed(evaluated(replace(base, unknowns=tuple(base.unknowns[k] for k in kept), q=base.q[kept])))
        own = unseen_parts(fit)
        if not collapsed_channels(held_out_free_runs(own, fit).table):
            return Restrained(fit, own, tuple(dict.fromkeys(each.owner.parameter for each in held)), worse)
    return Restrained(base, unseen)


def _choices(unknowns: Sequence[Unknown], worse: Sequence[str]) -> Iterator[list[Unknown]]:
    """Numbers to hold, fewest kinds first; worse: channels that have collapsed."""
    turning = [each for each in unknowns if _turns(each)]
    moving = [each for each in unknowns if not _turns(each)]
    if _TURNED in worse and turning:
        yield turning
    if set(worse) - {_TURNED} and moving:
        yield moving
    if turning and moving:
        yield [*turning, *moving]


def _turns(unknown: Unknown) -> bool:
    return unknown.column.rpartition(".")[2].startswith(_OF_TURNS)
