"""From a fit to numbers with 95 % intervals, by the names of the contract."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.stats import norm

from cocorosim_ros.diagnosis.catalogue.eddies import EDDY
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.criteria.showing import ESTIMATES
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, Recalibrated, Rival, Tier
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance
from cocorosim_ros.diagnosis.fitting.recalibration import RECALIBRATED
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.naming.naming import Accused
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Floats

Z95 = float(norm.ppf(0.975))
NUMERICAL = 1e-3
"""Of a value, how far midpoint steps h of 0.1 s may be off: (h l)^2 / 6 for a rate l of 0.77 / s, at which Lilys turn.

Where no water pushes, readings alone would tell numbers better than the filter can reckon.
"""


def _spreads(fit: Fit) -> Floats:
    """(laws,) standard deviation of each q."""
    values = np.array([law.value(float(q)) for law, q in zip(fit.laws, fit.q, strict=True)])
    slopes = np.array([law.slope(float(q)) for law, q in zip(fit.laws, fit.q, strict=True)])
    return np.asarray(np.hypot(np.sqrt(np.diag(covariance(fit))), NUMERICAL * np.abs(values / slopes)))


def estimate(unknown: Unknown, q: float, spread: float, unit: str) -> Estimate:
    """Value and interval of one unknown whose q has this standard deviation."""
    ends = sorted((unknown.value(q - Z95 * spread), unknown.value(q + Z95 * spread)))
    return Estimate(unknown.value(q), ends[0], ends[1], unit)


def recalibrated(fit: Fit) -> tuple[tuple[Recalibrated, ...], tuple[Recalibrated, ...]]:
    """All numbers of the platforms, and those that have clearly moved (Holm's procedure over all of them)."""
    spread = _spreads(fit)
    every, chances = [], []
    for index, law in enumerate(fit.laws):
        if law.column not in RECALIBRATED:
            continue
        name, unit = RECALIBRATED[law.column]
        robots = tuple(dict.fromkeys(fit.tracks[number].name for number in law.tracks))
        every.append(
            Recalibrated(name, law.value(0.0), estimate(law, float(fit.q[index]), float(spread[index]), unit), robots)
        )
        chances.append(2.0 * float(norm.sf(abs(fit.q[index]) / max(float(spread[index]), 1e-300))))
    order = np.argsort(chances)
    moved = set()
    for rank, index in enumerate(order):
        if chances[index] > ESTIMATES.sure / (len(order) - rank):
            break
        moved.add(int(index))
    return tuple(every), tuple(part for index, part in enumerate(every) if index in moved)


def found_effects(fit: Fit, accused: Sequence[Accused]) -> tuple[FoundEffect, ...]:
    """The accusations, strongest first; one for each robot where the numbers are the robot's own."""
    spread = _spreads(fit)
    found = []
    for part in accused:
        groups = [part.candidate.robots] if part.candidate.entry.water else [(name,) for name in part.candidate.robots]
        for number, robots in enumerate(groups):
            found.append(_found(fit, part, robots, number, spread))
    return tuple(sorted(found, key=lambda effect: -effect.nats))


def _found(fit: Fit, part: Accused, robots: tuple[str, ...], number: int, spread: Floats) -> FoundEffect:
    entry = part.candidate.entry
    per = len(entry.amplitudes)
    shapes = part.first + part.count - sum(not shape.fixed for shape in entry.shapes)
    parameters = {}
    for offset, amplitude in enumerate(entry.amplitudes):
        index = part.first + number * per + offset
        parameters[amplitude.name] = estimate(
            fit.laws[index], float(fit.q[index]), float(spread[index]), amplitude.unit
        )
    for offset, shape in enumerate(shape for shape in entry.shapes if not shape.fixed):
        index = shapes + offset
        parameters[shape.name] = estimate(fit.laws[index], float(fit.q[index]), float(spread[index]), shape.unit)
    rivals = tuple(
        Rival(candidate.entry.id, round(behind, 2))
        for candidate, behind in part.rivals
        if candidate.entry.id != entry.id
    )
    clear = part.nats >= NAMING.threshold + ESTIMATES.beyond_threshold and part.held_out.p < ESTIMATES.held_out_p
    tier: Tier = "confirmed" if clear and not rivals else "suspected"
    return FoundEffect(
        entry.id, entry.name, entry.equation, robots, tier, parameters, part.nats, rivals, entry.topic,
        held_out_nats=part.held_out.total,
        settings=_settings(fit, part),
        simulated_as=entry.law if entry.law and (entry.law == EDDY or part.candidate.known) else "",
    )  # fmt: skip


def _settings(fit: Fit, part: Accused) -> dict[str, float]:
    """What was given or found on a grid alone, by the names of the simulator's effect."""
    columns = [*part.candidate.entry.fixed, *(shape.column for shape in part.candidate.entry.shapes if shape.fixed)]
    row = fit.rows[part.candidate.everybody[0]]
    return {column.partition(".")[2]: float(row[COLUMN[column]]) for column in columns}
