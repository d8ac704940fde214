"""Numbers of a vehicle that are others in the second half of its recordings than in the first: it changed halfway.

The control compares every second part with the others, and has something of both states on either side. Here each part
tells a number by itself (`control`), beside the platform's numbers alone: effects that a vehicle is given may stand in
for the change. The means of both halves are compared by Student's t, with the scatter of the parts within the halves as
their error, and with no less than the parts' own. Of several numbers that are tried, one differs by chance so many
times as often (Bonferroni).
Source: McCullagh and Nelder, Generalized Linear Models (1989), sections 8.3 and 9.2.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from scipy.stats import t as student

from cocorosim_ros.diagnosis.against.control import Alike
from cocorosim_ros.diagnosis.against.numbers import number_entries
from cocorosim_ros.diagnosis.criteria.against import ALIKE, HALVES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.naming.single_thrusters import number_words
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.foundation.arrays import Floats


class Changed(NamedTuple):
    """A number of a robot, by its name, in the second half of its recordings as a factor of that in the first."""

    robot: str
    name: str
    factor: float


class Difference(NamedTuple):
    """Difference of the means of two halves, and the probability of one as large by chance."""

    size: float
    chance: float


def changed_halfway(base: Fit) -> tuple[Changed, ...]:
    """List the numbers that differ clearly and by much between the halves of each robot's tracks, the clearest first.

    base: fit of the platform's numbers to tracks in the order of time.
    """
    alike = Alike(base)
    entries = [each for each in number_entries(base.tracks, base.rows) if each.amplitudes[0].factor]
    candidates = {each.entry.id: each for each in reversed(expand(entries, base.tracks, base.rows))}
    found = []
    for robot, numbers in tracks_by_robot(base.tracks).items():
        tried = list(_tried(alike, list(candidates.values()), numbers))
        for name, difference in tried:
            chance = difference.chance * len(tried)
            if chance < HALVES.sure and abs(difference.size) > HALVES.large:
                found.append((chance, Changed(robot, name, math.exp(difference.size))))
    return tuple(changed for _, changed in sorted(found))


def _tried(alike: Alike, candidates: Sequence[Candidate], numbers: Sequence[int]) -> Iterator[tuple[str, Difference]]:
    """Difference of each candidate's number between the halves of some tracks, where both tell it."""
    half = len(numbers) // 2
    for candidate in candidates:
        (amplitude, *_) = candidate.amplitudes()
        told = alike.told_by_track(candidate, {})
        sides = []
        for own in (numbers[:half], numbers[half:]):
            mine = [told[number] for number in own if number in told and told[number].matrix.item() > ALIKE.told]
            known = np.array([each.matrix.item() for each in mine]) / amplitude.scale**2
            score = np.array([each.score.item() for each in mine]) / amplitude.scale
            sides.append((score / known, known))
        if min(len(values) for values, _ in sides) >= HALVES.fewest:
            yield number_words(candidate.entry.id), difference_of(*sides[0], *sides[1])


def difference_of(first: Floats, its_known: Floats, second: Floats, known: Floats) -> Difference:
    """Difference of the weighted means of values (n,) and (m,), second less first, and its probability by chance.

    its_known, known: information that each value has, one over its variance.
    """
    means = [float(np.average(values, weights=of)) for values, of in ((first, its_known), (second, known))]
    scatter = its_known @ (first - means[0]) ** 2 + known @ (second - means[1]) ** 2
    freedom = len(first) + len(second) - 2
    variance = max(float(scatter) / freedom, 1.0) * (1.0 / its_known.sum() + 1.0 / known.sum())
    size = means[1] - means[0]
    return Difference(size, 2.0 * float(student.sf(abs(size) / math.sqrt(variance), freedom)))
