"""Thresholds of the catalogue: amplitudes that are too small to be an effect, and sizes of a bad case."""

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


@dataclass(frozen=True)
class LawCriteria:
    """Shapes of laws of motion that are tried (`catalogue.laws`)."""

    roundings: tuple[float, ...] = (0.03, 0.1, 0.3)
    """[of the typical size of a regressor] within which a law that is steep at zero is rounded. Chosen, not
    measured."""


@dataclass(frozen=True)
class EddyCriteria:
    """Eddies that are tried, and how strong a bad case is (`catalogue.eddies`)."""

    places: int = 6
    """[grid points] of the centre along each axis: each costs a slope. Chosen, not measured."""
    beside: float = 0.25
    """[of the robots' range along an axis] by which the centre may lie outside of the range. Chosen, not measured."""
    cores: tuple[float, ...] = (0.2, 0.6)
    """[of the robots' greater range] radii of the core. Chosen, not measured."""
    fast: float = 0.005
    """[m/s] at the edge of the core in a bad case. Chosen, not measured."""


CATALOGUE = CatalogueCriteria()
LAWS = LawCriteria()
EDDIES = EddyCriteria()
