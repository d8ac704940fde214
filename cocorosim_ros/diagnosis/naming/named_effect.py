"""Results of the contest: the effects that it named, and the fits before and after."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.fitting.screening import Screened


class NearRival(NamedTuple):
    """A candidate that explains nearly as much as the named one; `behind`: nats less than that."""

    candidate: Candidate
    behind: float  # nats


@dataclass(frozen=True)
class NamedEffect:
    """An effect that was added to the model, with its evidence [nats], its rivals and its held-out gain.

    The unknowns of a fit that belong to the effect are those that `candidate` owns.
    """

    candidate: Candidate
    nats: float
    rivals: tuple[NearRival, ...]
    held_out: HeldOutGain


@dataclass(frozen=True)
class Naming:
    """Result of the contest.

    base: the recalibrated fit; fit: the one with all named effects; screened, laws: the first screening, best first.
    """

    base: Fit
    fit: Fit
    named: tuple[NamedEffect, ...]
    screened: tuple[Screened, ...]
    laws: tuple[Screened, ...]  # outside the catalogue
    nameless: str = ""  # law that explains what is left over, where laws are not named
