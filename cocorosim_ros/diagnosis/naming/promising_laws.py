"""Laws of two regressors that what is left of the force resembles: a quick choice among a thousand, by sums alone.

Where a law is missing from the model, the force that the model needs at random goes with the law's regressors: its
products with them have the same sign in most parts of the recordings. Laws whose mean over the parts is many standard
deviations stand out, ordered by the cosine between force and regressors. The base model's own laws need no care: at the
fit their products add up to nothing. The few that stand out are then screened as all candidates are.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.catalogue.laws import law_entry
from cocorosim_ros.diagnosis.catalogue.open_set import free_place
from cocorosim_ros.diagnosis.catalogue.pair_laws import pair_laws
from cocorosim_ros.diagnosis.criteria.naming import PAIR_LAWS
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.screening import Screen, Screened
from cocorosim_ros.diagnosis.naming.residual import forces_by_equation
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.vehicle_size import slowness
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.terms.regressors import values_along


def pair_candidates(screen: Screen, courses: Sequence[Smoothed]) -> list[Candidate]:
    """Make candidates of the laws of two regressors that what is left of the force resembles.

    courses: the smoothed course of each track under the fit of the screen.
    """
    return law_candidates(pair_laws(screen.scene), screen, courses)


def law_candidates(laws: Sequence[Law], screen: Screen, courses: Sequence[Smoothed]) -> list[Candidate]:
    """Make candidates of those of the laws that what is left of the force resembles.

    Each law has the odds against one of so many as its prior; none is made where the laws of the fit leave no place.
    """
    fit, scene = screen.fit, screen.scene
    place = free_place(fit.filled)
    if place is None:
        return []
    against = math.log(max(len(laws), 1))
    entries = [law_entry(place, law, scene) for law in promising_laws(laws, fit, courses)]
    return expand([replace(entry, prior_nats=against) for entry in entries], fit.tracks, fit.rows)


def leading(pairs: Sequence[Screened], tested: Sequence[Screened]) -> list[Screened]:
    """Choose the laws of two regressors that explain far more than the best entry of the catalogue.

    tested: entries of the catalogue, best first.
    """
    best = max((each.nats for each in tested[:1]), default=0.0)
    return [each for each in pairs if each.nats > PAIR_LAWS.lead * max(best, 0.0)]


def promising_laws(laws: Sequence[Law], fit: Fit, courses: Sequence[Smoothed]) -> list[Law]:
    """Choose the laws that the force left over follows, of all robots or of one, those it resembles most first.

    courses: the smoothed course of each track under the fit, in their order.
    """
    part = _part(fit, courses)
    sums = [_sums(laws, fit, number, course, part) for number, course in enumerate(courses)]
    groups = [list(range(len(courses))), *map(list, tracks_by_robot(fit.tracks).values())]
    found = [_Sums(*map(np.concatenate, zip(*(sums[number] for number in group), strict=True))) for group in groups]
    clear = np.max([each.clearness for each in found], axis=0)
    alike = np.max([each.likeness for each in found], axis=0)
    order = [int(place) for place in np.argsort(-alike, kind="stable") if clear[place] > PAIR_LAWS.clear]
    return [laws[place] for place in order[: PAIR_LAWS.most]]


class _Sums(NamedTuple):
    """Sums (parts, laws) over parts of recordings: of force times regressors, and of the square of either."""

    products: Floats
    of_regressors: Floats
    of_force: Floats

    @property
    def clearness(self) -> Floats:
        """Sizes (laws,) of the means of products over the parts, in standard deviations; 0 where parts are few."""
        if len(self.products) < PAIR_LAWS.fewest_parts:
            return np.zeros(self.products.shape[1])
        spread = np.sqrt(np.maximum((self.products**2).sum(axis=0), 1e-300))
        return np.asarray(np.abs(self.products.sum(axis=0)) / spread)

    @property
    def likeness(self) -> Floats:
        """Squares (laws,) of the cosines between force and regressors, from 0 to 1."""
        sizes = self.of_regressors.sum(axis=0) * self.of_force.sum(axis=0)
        return np.asarray(self.products.sum(axis=0) ** 2 / np.maximum(sizes, 1e-300))


def _part(fit: Fit, courses: Sequence[Smoothed]) -> float:
    """Length [s] of the parts: by the slowest vehicle, but short enough for PAIR_LAWS.fewest_parts of them.

    No less than those of a Lily: of short recordings of a slow vehicle parts scatter less than by themselves.
    """
    wanted = PAIR_LAWS.part * max(slowness(track.vehicle) for track in fit.tracks)
    room = sum(float(course.time[-1] - course.time[0]) for course in courses) / PAIR_LAWS.fewest_parts
    return max(PAIR_LAWS.part, min(wanted, room / PAIR_LAWS.spare))


def _sums(laws: Sequence[Law], fit: Fit, number: int, course: Smoothed, part: float) -> _Sums:
    """Sums over the parts [s] of one track; what is left over at its end belongs to the last part."""
    values = values_along(fit.tracks[number].actuation.course_along(course, fit.filled[number]))
    force = forces_by_equation(course.mean)
    size = max(1, round(part / float(course.time[1] - course.time[0])))
    begins = np.arange(0, len(course.time) - size + 1, size)

    def summed(column: Floats) -> Floats:
        return np.asarray(np.nan_to_num(np.add.reduceat(column, begins), posinf=0.0, neginf=0.0))

    if len(begins) == 0:
        return _Sums(*np.zeros((3, 0, len(laws))))
    along = {product: product.along(values) for product in dict.fromkeys(law.product for law in laws)}
    of_regressors = {product: summed(each**2) for product, each in along.items()}
    of_force = {name: summed(each**2) for name, each in force.items()}
    return _Sums(
        np.column_stack([summed(force[law.of] * along[law.product]) for law in laws]),
        np.column_stack([of_regressors[law.product] for law in laws]),
        np.column_stack([of_force[law.of] for law in laws]),
    )
