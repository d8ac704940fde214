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
    numerical: float = 1e-3
    """[of a number] its least standard deviation: the error of the filter's midpoint steps. Reckoned from that error,
    (h l)^2 / 6, for steps h of 0.1 s and a rate l of 0.77 / s, at which Lilys turn. In still water, readings alone
    would give narrower intervals than the steps of the filter are exact."""
    held_out_p: float = 0.05
    """[probability] of a held-out gain by chance, below which an effect may be confirmed. Chosen, not measured."""


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
class FramingCriteria:
    """Stand-in for evidence without doubt (`showing.framing`)."""

    certain: float = 1e4
    """[nats] of a correction that is certain, in place of infinity, which files cannot hold. Chosen, not measured."""


@dataclass(frozen=True)
class FreeRunCriteria:
    """Parts of a recording through which models run freely (`showing.free_runs`)."""

    seen: float = 0.6
    """[of each recording] is fitted; the rest is held out. Chosen, not measured."""
    most_turned: float = 30.0
    """[rad] in a window at the usual turn rate: after five turns no model foretells a heading. Chosen, not measured."""
    fewest_points: int = 10
    """[grid points] of a window. Chosen, not measured."""
    windows: tuple[float, ...] = (20.0, 10.0, 5.0, 2.0)
    """[s] lengths of a window, of which the longest is taken that can be foretold. Chosen, not measured."""


VERDICT = VerdictCriteria()
ESTIMATES = EstimateCriteria()
LOCATION = LocationCriteria()
FRAMING = FramingCriteria()
FREE_RUNS = FreeRunCriteria()
