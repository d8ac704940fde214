"""Differences that undo what was learned from the recordings of --against.

Where a number of the learned vehicle is not that of the platform's file, and the judged recordings have it as the file
does, the odd ones out are the recordings that are taken for those of a well vehicle.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.diagnosis.showing.estimates import fitted
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Floats

_DIFFERENCE = COLUMN["thruster_asymmetry.difference"]
_LEFT, _RIGHT = COLUMN["own_gain.1"], COLUMN["own_gain.2"]
_OF_SIDES = (_DIFFERENCE, _LEFT, _RIGHT)
_SIDES = 2  # thrusters


class _Told(NamedTuple):
    """A number in the learned vehicle, in the judged recordings and in the platform's file, and half its interval."""

    learned: float
    judged: float
    given: float
    half: float

    @property
    def is_undone(self) -> bool:
        return abs(self.learned - self.given) > self.half >= abs(self.judged - self.given)


def undone(case: Case, learned: Fit) -> Iterator[Objection]:
    """Object to differences by which the judged recordings are as the platform's file says; learned: without any.

    case: of the judged recordings alone, whose tracks `learned` has too.
    """
    numbers = {(each.unknown.owner, each.unknown.column): each for each in fitted(case.final)}
    for found, named in effects_of(case):
        amplitudes = {each.column for each in named.candidate.entry.amplitudes}
        told = [
            _told(case.final, learned, each.unknown, 0.5 * (each.estimate.high - each.estimate.low))
            for each in numbers.values()
            if named.candidate.owns(each.unknown) and each.unknown.column in amplitudes
        ]
        if told and all(each.is_undone for each in told):
            yield Objection(
                "Here it is as the platform's file has it, and in the recordings of --against it is not: these may be "
                "the ones that are not of a well vehicle. Diagnose them by themselves.",
                effect=found,
            )


def _told(judged: Fit, learned: Fit, unknown: Unknown, half: float) -> _Told:
    """half: of the interval of the unknown, a factor where it is a logarithm."""
    track, column = unknown.tracks[0], COLUMN[unknown.column]
    vehicle = judged.tracks[track].vehicle
    rows = (learned.filled[track], judged.filled[track], vehicle.row)
    if column in _OF_SIDES and np.count_nonzero(vehicle.is_thruster) == _SIDES:
        before, now, given = map(_right_over_left, rows)
        return _Told(before, now, given, half)
    before, now, given = (float(row[column]) for row in rows)
    return _Told(before, now, given, abs(before) * half if unknown.logarithmic else half)


def _right_over_left(row: Floats) -> float:
    """Logarithm of the quotient of both thrusters' gains in a row (columns,)."""
    right, left = row[_RIGHT] * (1.0 + 0.5 * row[_DIFFERENCE]), row[_LEFT] * (1.0 - 0.5 * row[_DIFFERENCE])
    return math.log(right / left) if right > 0.0 < left else math.inf
