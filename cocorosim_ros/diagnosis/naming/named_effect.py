"""What the contest hands on: the effects that it named, and the fits before and after."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.fitting.screening import Screened


class NearRival(NamedTuple):
    """A candidate that explains nearly as much as the one that was named."""

    candidate: Candidate
    behind: float  # nats


@dataclass(frozen=True)
class NamedEffect:
    """An effect that was added to the model: its evidence and its rivals; its unknowns are those that it owns."""

    candidate: Candidate
    nats: float
    rivals: tuple[NearRival, ...]
    held_out: HeldOutGain


@dataclass(frozen=True)
class Naming:
    """The recalibrated fit, the fit with all effects that were named, and what the first screening saw."""

    base: Fit
    fit: Fit
    named: tuple[NamedEffect, ...]
    screened: tuple[Screened, ...]
    laws: tuple[Screened, ...]  # outside the catalogue
