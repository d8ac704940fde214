"""Thresholds of the report: what a sentence, a table or a picture leaves out."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ReportCriteria:
    """Limits from which a number is worth a bar, an interval, a mark or a clause (`report`)."""

    least_nats: float = 0.1
    """[nats] of an effect alone; less gets no bar. Chosen, not measured."""
    fewest_visits: int = 3
    """[visits] of a class of a picture, below which its mean has no interval. Chosen, not measured."""
    clear_gain: float = 0.95
    """[of the error without the effects] an error below is a gain worth a clause. Chosen, not measured."""
    clearly_best: float = 0.9
    """[of the next smallest error] an error below is set in bold. Chosen, not measured."""
    along_axis: float = 0.3
    """[of a thruster's force] a share along an axis, from which a manoeuvre uses it there. Chosen, not measured."""
    fewest_samples: int = 8
    """[samples] of a cell of the map of places; cells with fewer stay empty. Chosen, not measured."""
    most_robots: int = 3
    """[robots] with pictures of their own. Chosen, not measured."""
    most_located: int = 3
    """[findings] of a robot with a picture of the residual against the regressor. Chosen, not measured."""
    most_free_runs: int = 3
    """[stretches] that are drawn. Chosen, not measured."""
    most_readings: int = 4
    """[streams] that are drawn. Chosen, not measured."""


REPORT = ReportCriteria()
