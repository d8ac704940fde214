"""A smooth force without a name: what state, commands and place explain of the force that a model lacks.

The noise floor needs a model that names nothing. This one is the recalibrated model with a sum of general terms
(regressors, their products, late and single forces of actuators) for each axis, chosen one by one, as many as foretell
parts of the recordings that did not teach them (matching pursuit with cross-validation). A law that is missing from the
model is learnt here, whatever its name is; what is left is random force. So a model that is right and one that lacks a
law have nearly the same floor.
Source: Tropp and Gilbert, IEEE Transactions on Information Theory 53 (2007) 4655.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np
from scipy.signal import lfilter

from cocorosim_ros.diagnosis.criteria.foretelling import NAMELESS_FORCE
from cocorosim_ros.diagnosis.tracks.passes import FORCE_X, YAW_MOMENT, Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import coasting_time
from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.world.state.state import YAW, X, Y
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.terms.regressors import REGRESSORS

SINGLE = tuple(each for each in REGRESSORS if each.name not in ("sin_t", "cos_t", "neighbour_distance"))
PAIRED = ("u", "v", "w", "r", "speed", "thrust", "yaw_command", "sin_yaw", "cos_yaw")


def explained_forces(tracks: Sequence[Track], courses: Sequence[Smoothed], rows: Floats) -> list[Floats]:
    """Forces (points, 4) [N, N, N, N m; world] that such terms explain, by track.

    courses: smoothed courses of the tracks under the rows (tracks, columns) of the recalibrated model.
    """
    seen = [track.actuation.course_along(course, row) for track, course, row in zip(tracks, courses, rows, strict=True)]
    ends = np.cumsum([0, *(len(course.time) for course in courses)])
    turned = [course.mean[:, YAW] for course in courses]
    lacking = np.concatenate([turn_back(course.mean[:, FORCE_X : YAW_MOMENT + 1], yaw)
                              for course, yaw in zip(courses, turned, strict=True)])  # fmt: skip
    terms = np.concatenate([_terms(course, _memories(track)) for track, course in zip(tracks, seen, strict=True)])
    size = np.sqrt(np.mean(terms**2, axis=0))
    terms = terms[:, size > NAMELESS_FORCE.rounding * float(size.max())]
    terms = terms / np.sqrt(np.mean(terms**2, axis=0))
    explained = np.column_stack([foretold(terms, axis) for axis in lacking.T])
    return [
        turn_back(explained[begin:end], -yaw)
        for begin, end, yaw in zip(ends[:-1], ends[1:], turned, strict=True)
    ]  # fmt: skip


def turn_back(force: Floats, yaw: Floats) -> Floats:
    """Forces (points, 4) in axes that are turned by `yaw` (points,) [rad] against the ones in which they are given."""
    sine, cosine, turned = np.sin(yaw), np.cos(yaw), force.copy()
    ahead, left = force[:, X], force[:, Y]
    turned[:, X], turned[:, Y] = ahead * cosine + left * sine, left * cosine - ahead * sine
    return turned


def _memories(track: Track) -> list[float]:
    """Memories of late forces [steps of the track's grid], longer where the vehicle is slow beside its steps."""
    steps = coasting_time(track.vehicle, track.vehicle.row) / track.timeline.grid.step
    longer = max(steps / NAMELESS_FORCE.steps_of_coasting, 1.0) if math.isfinite(steps) else 1.0
    return [longer * memory for memory in NAMELESS_FORCE.memories]


def _terms(course: Course, memories: Sequence[float]) -> Floats:
    """Terms (points, n) of the force along any body axis, in their own units.

    memories: over which late forces fade [steps of the grid].
    """
    still = np.zeros(len(course.time))
    value = {each.name: np.asarray(each.along(course, still), dtype=np.float64) for each in SINGLE}
    columns = list(value.values())
    columns += [value[one] * value[other] for one, other in itertools.combinations(PAIRED, 2)]
    columns += [value[name] * np.abs(value[name]) for name in PAIRED]
    columns += [value[name] ** 2 for name in PAIRED]
    columns += [course.state[:, place] * value[turn] for place in (X, Y) for turn in ("sin_yaw", "cos_yaw")]
    columns += [part for force in course.force.T for part in (force, np.abs(force))]
    for wrench in course.thrust.T:
        for memory in memories:
            fading = np.exp(-1.0 / memory)
            columns.append(wrench - lfilter([1.0 - fading], [1.0, -fading], wrench))
    return np.nan_to_num(np.column_stack(columns), posinf=0.0, neginf=0.0)


def foretold(terms: Floats, wanted: Floats) -> Floats:
    """Values (n,) of `wanted` (n,) as a sum of a few of the terms (n, m), each part taught by all others.

    So many terms are taken as foretell the parts best, none at all if none does.
    """
    parts = np.array_split(np.arange(len(wanted)), NAMELESS_FORCE.folds)
    products = [(terms[part].T @ terms[part], terms[part].T @ wanted[part]) for part in parts]
    matrix, score = sum(each for each, _ in products), sum(each for _, each in products)
    found = np.zeros((NAMELESS_FORCE.most_terms + 1, len(wanted)))
    for part, (own, own_score) in zip(parts, products, strict=True):
        others = matrix - own
        taught = np.diag(others) > NAMELESS_FORCE.rounding * np.diag(matrix)  # by other parts, by more than rounding
        for count, (chosen, share) in enumerate(_pursued(others, np.where(taught, score - own_score, 0.0)), start=1):
            found[count:, part] = terms[np.ix_(part, chosen)] @ share
    best = int(np.argmin(np.mean((found - wanted) ** 2, axis=1)))
    return np.asarray(found[best])


def _pursued(matrix: Floats, score: Floats) -> list[tuple[Integers, Floats]]:
    """Terms and their factors, one term more in each, by normal equations: matrix (m, m), score (m,)."""
    size = np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    chosen: list[int] = []
    left = score.copy()
    found: list[tuple[Integers, Floats]] = []
    for _ in range(min(NAMELESS_FORCE.most_terms, len(score))):
        gain = np.where(score != 0.0, np.abs(left) / size, 0.0)
        gain[chosen] = 0.0
        if not gain.any():
            break
        chosen.append(int(np.argmax(gain)))
        own = matrix[np.ix_(chosen, chosen)] + 1e-9 * np.diag(size[chosen] ** 2)
        share = np.asarray(np.linalg.solve(own, score[chosen]), dtype=np.float64)
        left = score - matrix[:, chosen] @ share
        found.append((np.array(chosen, dtype=np.int64), share))
    return found
