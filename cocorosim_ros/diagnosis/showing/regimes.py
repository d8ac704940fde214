"""Comparison of held-out parts with fitted ones, by the middle half of speeds, turns, thrusts and depths."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.showing import REGIMES
from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span
from cocorosim_ros.diagnosis.foretelling.regimes import DEPTH, QUANTITIES, Quantity, regimes_along
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.units.quantity_text import said_quantity

_DEPTH = QUANTITIES[DEPTH].name


def unlike_regimes(unseen: Unseen) -> dict[str, str]:
    """Say by what the held-out parts differ from the fitted ones: a sentence, by name of the quantity that does."""
    held = _values(unseen, [split.held for split in unseen.splits])
    seen = _values(unseen, [split.seen for split in unseen.splits])
    if not held.size or not seen.size:
        return {}
    remarks = {
        quantity: remark
        for quantity, unlike, fitted in zip(QUANTITIES, held.T, seen.T, strict=True)
        if (remark := _remark(quantity, unlike, fitted))
    }
    said = {quantity.name for quantity in remarks}
    return dict(remark for quantity, remark in remarks.items() if quantity.unless not in said)


def _remark(quantity: Quantity, held: Floats, seen: Floats) -> tuple[str, str] | None:
    """Name of a quantity whose median differs, and a sentence: held (n,), seen (m,); None if it does not differ."""
    low, high = np.quantile(seen, REGIMES.middle).tolist()
    least = REGIMES.steady * float(max(np.abs(seen).max(), np.abs(held).max()))
    wider = 0.5 * max(least - (high - low), 0.0)
    median = float(np.median(held))
    if low - wider <= median <= high + wider:
        return None
    name = quantity.name
    if name == _DEPTH and max(median, high) < 0.0:  # a vehicle in the air, or above where its map has the surface
        name = "height"
        median, low, high = -median, -high, -low
    middle, lowest, highest = (said_quantity(each, quantity.unit) for each in (median, low, high))
    return name, (
        f"Free runs go through parts unlike the fitted ones: their median {name} is {middle}, the middle half of the "
        f"fitted parts lies between {lowest} and {highest}."
    )


def _values(unseen: Unseen, spans: Sequence[Sequence[Span]]) -> Floats:
    """Values (n, quantities) at all grid points of some spans of each track."""
    found = [np.zeros((0, len(QUANTITIES)))]
    for track, course, chosen in zip(unseen.tracks, unseen.courses, spans, strict=True):
        every = regimes_along(track, course)
        found += [every[span.first : span.end] for span in chosen]
    return np.concatenate(found)
