"""Sizes from which a difference would be named, by stream, by thruster and by number: what silence does not tell.

The evidence for an entry of which one number alone is off by q times its `large` is expected to be, with information
I on all of its numbers and the spread s of recordings that should be alike (`control`),

    (K q^2 - log det(1 + I)) / (2 s), K the number's own element of I (1 + I)^-1 I,

which is the evidence of the screening, where it estimates a number of the size that is there. A difference is named
from the threshold of evidence on. The estimate of q scatters by sqrt(s / K): the size that is told is so much larger
that few are missed, as a detection limit is. Where there is little information, the prior draws the estimate to
nothing, and K is much less than the information.
Source: Currie, Analytical Chemistry 40 (1968) 586.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.stats import norm

from cocorosim_ros.diagnosis.criteria.against import COMPARISON
from cocorosim_ros.diagnosis.criteria.naming import DETECTABILITY, NAMING
from cocorosim_ros.diagnosis.fitting.screening import Screened
from cocorosim_ros.diagnosis.naming.detectability import felt_share, own_name


class Size(NamedTuple):
    """A size of a number: as a share of `large`, and in the number's unit, or as a share for a factor."""

    share: float
    size: float


def sizes_seen(screened: Sequence[Screened]) -> dict[str, dict[str, float]]:
    """Sizes from which single numbers would be seen [unit of the number; share of a factor], by entry and number.

    Entries that each stream may have by itself are called effect:topic. Numbers that would be seen at no size are left
    out.
    """
    return {
        name: {number: seen.size for number, seen in numbers.items() if math.isfinite(seen.size)}
        for name, numbers in _smallest(screened).items()
    }


def numbers_not_shown(screened: Sequence[Screened]) -> tuple[str, ...]:
    """Names, as effect:number, of numbers that would stay unseen at medium size, of entries with others that would not.

    So the offset of a compass stays unseen where nothing else shows the heading, although its distortion does not.
    """
    found = []
    for name, numbers in _smallest(screened).items():
        unseen = [number for number, seen in numbers.items() if not seen.share <= DETECTABILITY.medium]
        if 0 < len(unseen) < len(numbers):
            found += [f"{name}:{number}" for number in unseen]
    return tuple(found)


def _smallest(screened: Sequence[Screened]) -> Mapping[str, Mapping[str, Size]]:
    """Smallest sizes that would be seen, by entry and number; of several robots that of the one that shows most."""
    found: dict[str, dict[str, Size]] = {}
    for each in screened:
        if each.candidate.entry.law is None:
            numbers = found.setdefault(own_name(each), {})
            for number, seen in _sizes(each):
                if number not in numbers or seen.share < numbers[number].share:
                    numbers[number] = seen
    return found


def _sizes(screened: Screened) -> Iterator[tuple[str, Size]]:
    """Name and smallest size of each number; none of a model that runs away along its slopes."""
    if not np.isfinite(screened.information).all():
        return
    matrix = felt_share(screened) * screened.information
    whole = matrix + np.eye(len(matrix))
    odds = float(np.linalg.slogdet(whole)[1])
    needed = 2.0 * NAMING.threshold * screened.candidate.spread + odds
    least = math.sqrt(needed) + float(norm.isf(COMPARISON.missed)) * math.sqrt(screened.candidate.spread)
    own = np.diag(matrix @ np.linalg.solve(whole, matrix))
    for unknown, known in zip(screened.candidate.amplitudes(), own.tolist(), strict=True):
        share = least / math.sqrt(known) if known > 0.0 else math.inf
        reach = max(unknown.bounds[1], -unknown.bounds[0])
        size = unknown.scale * min(share, reach)
        yield (
            unknown.owner.parameter,
            Size(share, (math.expm1(size) if unknown.logarithmic else size) if share <= reach else math.inf),
        )
