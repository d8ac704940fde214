"""Thresholds of the catalogue: amplitudes that are too small to be an effect."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CatalogueCriteria:
    """Sizes below which an amplitude is none, and above which it is large (`catalogue`)."""

    large_share: float = 0.1
    """[of the full force of an equation] a law of this size is large. Chosen, not measured."""
    turning: float = 0.01
    """[of the mass] the filter's steps follow turning axes no better. Chosen, not measured."""
    least_force: float = 0.002
    """[of the full force] a smaller law may come from the filter's steps. Measured: one sealed recording named a law
    below it that was not there."""


CATALOGUE = CatalogueCriteria()
