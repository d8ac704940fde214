"""Thresholds of the fits and of their tracks: when a fit has ended, what random force may be, where water ends."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class ConvergenceCriteria:
    """Gains at which a fit has ended (`fitting.fit`, `fitting.leaps`)."""

    least_gain: float = 0.02
    """[nats] an iteration that gains less has converged. Chosen, not measured."""
    settled: float = 0.1
    """[nats] a turn of noise and laws that gains less ends the fit. Chosen, not measured."""
    worth: float = 1.0
    """[nats] a leap of the noise has to gain more. Chosen, not measured."""


@dataclass(frozen=True)
class RandomForceCriteria:
    """Bounds between which a force of the water is random (`fitting.recalibration`)."""

    most_correlation: float = 60.0
    """[s] a push that lasts longer is a force that an effect has to explain. Measured: without the
    bound, one sealed recording took a constant torque and trim for a random force of 45 minutes; 33 others without
    random force, and 22 with nothing hidden, give the same with and without the bound, to 0.2 nats."""
    least_smoothness: float = 0.04
    """[1] one rate of the process is a hundred times the other. Chosen, not measured."""


@dataclass(frozen=True)
class RecalibrationCriteria:
    """Widths of priors, and when the first guess of the noise is wrong (`fitting.recalibration`)."""

    prior: float = 0.2
    """[1] standard deviation of the logarithm of a number that the platform gives without a range. Chosen, not
    measured."""
    farthest: float = 4.0
    """[1] logarithm of a number over the platform's, where the file gives no range: a factor of 55. Chosen, not
    measured."""
    shut: float = 0.2
    """[share of the readings of a kind] beyond the gate, from which their noise is taken as wrong. Chosen, not
    measured."""
    doubt: float = math.log(20.0)
    """[logarithm] by which noise of inertial sensors is raised for a further start. Chosen, not measured."""
    coarse: float = math.log(10.0)
    """[logarithm] by which noise of readings beyond the gate is raised for a further start. Chosen, not measured."""


@dataclass(frozen=True)
class SurroundingsCriteria:
    """Assumptions on the tank, which no recording shows (`tracks.surroundings`)."""

    shore: float = 0.1
    """[m] between the farthest place of any robot and the wall. Chosen, not measured."""
    alike: float = 1.25
    """[1] quotient of two sides of a tank, below which they are taken as equal. Chosen, not measured."""


CONVERGENCE = ConvergenceCriteria()
RANDOMNESS = RandomForceCriteria()
RECALIBRATION = RecalibrationCriteria()
SURROUNDINGS = SurroundingsCriteria()
