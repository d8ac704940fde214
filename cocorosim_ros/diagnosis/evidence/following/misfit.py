"""Misfit of a following: reports against gain times the response to commands, plus an offset, by least squares."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.evidence.following.response import response
from cocorosim_ros.diagnosis.evidence.following.stretches import Stretch
from cocorosim_ros.foundation.arrays import Floats, Integers


@dataclass(frozen=True)
class Line:
    """The line of reports (n,) over responses (n,) with the least squares, and what it leaves over (n,)."""

    shown: Floats
    gain: float
    left: Floats

    @property
    def misfit(self) -> float:
        """The sum of what is left over, squared."""
        return float(self.left @ self.left)


@dataclass(frozen=True)
class Following:
    """Reports of an actuator over all stretches, those that have settled, and the commands behind them.

    of_amount: whether reports follow the amount of the command, as a current does and a speed without sign.
    """

    stretches: tuple[Stretch, ...]
    of_amount: bool = False

    @property
    def reported(self) -> Floats:
        """(n,) in the unit of the report."""
        return np.concatenate([each.reported[each.settled] for each in self.stretches])

    @property
    def command(self) -> Floats:
        """(m,) all commands."""
        return np.concatenate([self._asked(each) for each in self.stretches])

    def response(self, lateness: Floats) -> Floats:
        """(n,) the response to the commands; lateness (3,): delay [s], time constant [s], largest rate."""
        return np.concatenate(
            [
                response(each.time[each.settled], each.command_time, self._asked(each), lateness)
                for each in self.stretches
            ]
        )

    def line(self, lateness: Floats) -> Line:
        """The line of the reports over the response."""
        shown, reported = self.response(lateness), self.reported
        away, felt = shown - shown.mean(), reported - reported.mean()
        spread = float(away @ away)
        gain = float(away @ felt) / spread if spread > 0.0 else 0.0
        return Line(shown, gain, felt - gain * away)

    def _asked(self, stretch: Stretch) -> Floats:
        return np.abs(stretch.command) if self.of_amount else stretch.command


def blocks_of(stretches: Sequence[Stretch], shortest: float) -> Integers:
    """(n,) number of the block of each settled report; blocks are as long as `shortest` [s] or a little longer."""
    numbers, first = [], 0
    for each in stretches:
        time = each.time[each.settled]
        if len(time):
            count = max(1, int((time[-1] - time[0]) / shortest))
            share = (time - time[0]) / max(float(time[-1] - time[0]), shortest)
            numbers.append(first + np.minimum((share * count).astype(np.int64), count - 1))
            first += count
    return np.concatenate(numbers) if numbers else np.zeros(0, np.int64)
