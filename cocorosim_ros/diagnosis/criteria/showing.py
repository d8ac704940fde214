"""Thresholds of what is shown: intervals, places, free runs, and the verdict."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class VerdictCriteria:
    """Tests that take an effect back, or call for a recalibration of the platform (`diagnose`)."""

    worse: float = 1.1
    """[of the error without the effects] a model with them that errs more is taken back. Chosen, not measured."""
    sure: float = 0.01
    """[probability] of a shift of all numbers together where none has moved. Chosen, not measured."""


@dataclass(frozen=True)
class EstimateCriteria:
    """Tests of a number that has moved, and of an effect that is confirmed (`showing.estimates`)."""

    sure: float = 0.05
    """[probability] of any clear number among all recalibrated ones where none has moved. Chosen, not measured."""
    beyond_threshold: float = 4.0
    """[nats] of a confirmed effect above the threshold of naming. Chosen, not measured."""
    held_out_p: float = 0.05
    """[probability] of a held-out gain by chance, below which an effect may be confirmed. Chosen, not measured."""


@dataclass(frozen=True)
class HardStopCriteria:
    """Signs of a fit that has gone wrong, under which nothing is more than suspected (`showing.hard_stops`)."""

    at_bound: float = 1e-3
    """[of q] nearer to its bound a number stands at it: steps are cut there exactly. Chosen, not measured."""
    worse: float = 1.1
    """[of the error of the platform as given] a recalibrated model that errs more has collapsed. Chosen, as
    VERDICT.worse is, not measured."""
    strayed: float = 3.0
    """[noise of the readings] by which a smoothed course may leave most of its readings: normal noise leaves it by one.
    Chosen, not measured."""
    most: float = 0.6826894921370859
    """[share of the readings] that normal noise leaves within one standard deviation. Known of the distribution."""
    correlated: float = 0.5
    """[1] correlation of an innovation with the next of its kind: half of what is foretold wrongly is foretold wrongly
    again. Chosen, not measured."""
    scale: float = 2.0
    """[of what the filter expects] of the standard deviation of innovations, beyond which its intervals are none.
    Chosen, not measured."""
    fewest: int = 30
    """[readings] fewer show no correlation. Chosen, not measured."""


@dataclass(frozen=True)
class LocationCriteria:
    """Limits from which a difference of model and recording stands out, in all or in a regime (`showing.location`)."""

    clear: float = 5.0
    """[standard deviations] from which a law stands out. Measured: no clean recording of the study passed 3.7."""
    most: int = 6
    """[differences] that are listed. Chosen, not measured."""
    concentrated: float = 0.7
    """[of the evidence] in one regime, for the regime to be named. Chosen, not measured."""
    everywhere: float = 0.9
    """[of the moments] a regime that holds so many is none. Chosen, not measured."""


@dataclass(frozen=True)
class FreeRunCriteria:
    """Parts of a recording through which models run freely (`showing.free_runs`)."""

    seen: float = 0.6
    """[of each recording] is fitted; the rest is held out. Chosen, not measured."""
    most_turned: float = 30.0
    """[rad] in a window at the usual turn rate: after five turns no model foretells a heading. Chosen, not measured."""
    fewest_points: int = 10
    """[grid points] of a window. Chosen, not measured."""


VERDICT = VerdictCriteria()
ESTIMATES = EstimateCriteria()
HARD_STOPS = HardStopCriteria()
LOCATION = LocationCriteria()
FREE_RUNS = FreeRunCriteria()
