"""Thresholds of the catalogue: amplitudes that are too small to be an effect."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CatalogueCriteria:
    """Sizes below which an amplitude is none, and above which it is large (`catalogue`)."""

    crossed: float = 0.1
    """[m] above and below a layer of water that have to be visited. Chosen, not measured."""
    pump_tick: float = 0.04
    """[s] a pump that is late by less answers at once; the rest is timing of its commands. Chosen, not measured."""
    thrust_tick: float = 0.02
    """[s] the same of thrusters, which move the robot more sharply. Chosen, not measured."""
    play: float = 0.002
    """[of a full command] a linkage with less has no play. Chosen, not measured."""
    clock_tick: float = 0.01
    """[s] smaller delays are none, nor are skews that make less on average: a tenth of the filter's step. Chosen, not
    measured."""
    large_share: float = 0.1
    """[of the full force of an equation] a law of this size is large. Chosen, not measured."""
    turning: float = 0.01
    """[of the mass] the filter's steps follow turning axes no better. Chosen, not measured."""
    least_force: float = 0.002
    """[of the full force] a smaller law may come from the filter's steps. Measured: one sealed recording named a law
    below it that was not there."""


CATALOGUE = CatalogueCriteria()
