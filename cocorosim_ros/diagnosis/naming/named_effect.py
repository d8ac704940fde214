"""Results of the contest: the effects that it named, and the fits before and after."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.entry import SENSOR_CHANNELS
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.fitting.screening import Screened
from cocorosim_ros.diagnosis.foretelling.gains import Gain


class NearRival(NamedTuple):
    """A candidate that explains nearly as much as the named one; `behind`: nats less than that."""

    candidate: Candidate
    behind: float  # nats


@dataclass(frozen=True)
class NamedEffect:
    """An effect that was added to the model, with its evidence [nats], its rivals and its held-out gain.

    The unknowns of a fit that belong to the effect are those that `candidate` owns. foretold: gain of free runs on
    unseen data by the effect, beside all others; None for an error of readings, and where no model ran freely.
    found_before: the base model has it from a diagnosis, whose model is asked once more.
    """

    candidate: Candidate
    nats: float
    rivals: tuple[NearRival, ...]
    held_out: HeldOutGain
    foretold: Gain | None = None
    found_before: bool = False


def onsets_of(named: Sequence[NamedEffect]) -> frozenset[str]:
    """Columns of the moments at which events happen once, of all named effects."""
    return frozenset(column for effect in named for column in effect.candidate.onset_columns)


class Refused(NamedTuple):
    """A candidate with evidence enough that free runs were against, and the fit with it."""

    fit: Fit
    effect: NamedEffect


class Stage(NamedTuple):
    """A fit of a contest, and the effects that it has been named with or had before.

    harmful: effects with evidence enough that were named, and taken back for free runs that became worse.
    """

    fit: Fit
    named: tuple[NamedEffect, ...]
    harmful: tuple[Refused, ...] = ()


@dataclass(frozen=True)
class Naming:
    """Result of the contest.

    base: the recalibrated fit; fit: the one with all named effects; screened, laws: the first screening, best first.
    known: effects that the base has already, with their evidence. refused: candidates with evidence enough that free
    runs were against when nothing more could be named; traces: errors of readings that may be what these leave there;
    unsettled: one that could be named, and those for which the readings speak louder, though alike recordings differ;
    harmful: effects that were named, and taken back for free runs that became worse.
    """

    base: Fit
    fit: Fit
    named: tuple[NamedEffect, ...]
    screened: tuple[Screened, ...]
    laws: tuple[Screened, ...]  # outside the catalogue
    nameless: str = ""  # law that explains what is left over, where laws are not named
    known: tuple[NamedEffect, ...] = ()
    refused: tuple[Refused, ...] = ()
    traces: tuple[Candidate, ...] = ()
    unsettled: tuple[Candidate, ...] = ()
    harmful: tuple[Refused, ...] = ()

    def may_be_rest(self, effect: NamedEffect) -> bool:
        """Tell whether the base has an effect that a diagnosis found, of whose form another one may be a rest.

        What found effects of motion leave shows in motion, what found errors of a sensor leave in that sensor.
        """
        kind = _kind(effect.candidate)
        return any(each.found_before and _kind(each.candidate) == kind for each in self.known)


def _kind(candidate: Candidate) -> str:
    """Channel of the sensor that a candidate acts on; 'motion' for all others."""
    channel = candidate.entry.channel
    return channel if channel in SENSOR_CHANNELS else "motion"
