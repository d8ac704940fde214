"""Spread of a fitted number from one part of the recordings to another, beyond what noise makes of it.

A cause of another form than the model's law gives another number at each speed, turn rate, depth or time. An interval
from the information of all readings does not show this: it narrows with every reading, around a mean of these numbers.
The readings are therefore divided in parts. Estimates of each part by itself follow from the fit by one Newton step;
where they differ by more than their noise (Cochran's test), a random-effects model gives the variance between parts.
What no part shows, because each has the same law, is known beforehand only: by how much numbers of other laws of the
kind differ stands in the file of the effect.
Source: Cochran, Biometrics 10 (1954) 101; DerSimonian and Laird, Controlled Clinical Trials 7 (1986) 177; one-step
estimates after Pregibon, Annals of Statistics 9 (1981) 705.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.stats import chi2

from cocorosim_ros.diagnosis.criteria.showing import FORM_WIDTH
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance, information
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Unknown
from cocorosim_ros.diagnosis.tracks.columns import ALL_THRUSTERS, COLUMN, NEUTRAL, OWN_GAINS
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.state.state import HEAVE, SURGE, YAW_RATE, X, Z
from cocorosim_ros.world.terms.effect import Description, Number

DESCRIBED: Mapping[str, Description] = {**EFFECTS, **ERRORS}


class Part(NamedTuple):
    """Score (n,) and information (n, n) of n unknowns from one part of the readings, without priors."""

    score: Floats
    information: Floats
    tracks: frozenset[int]


class Heterogeneity(NamedTuple):
    """Variances (unknowns,) of each q that parts of the recordings show; 0 where they agree as noise lets them.

    between: from part to part, by which a part that was not recorded may differ. of_mean: of the mean of these parts,
    which is what a fit finds: whether it is nothing is asked with that one.
    """

    between: Floats
    of_mean: Floats


def variances_between_parts(fit: Fit) -> Heterogeneity:
    """Variances of each q of a fit that its parts show: the largest over four divisions.

    The divisions are by time, by speed, by turn rate, by depth.
    """
    if not fit.unknowns or not fit.tracks:
        return Heterogeneity(np.zeros(len(fit.unknowns)), np.zeros(len(fit.unknowns)))
    courses = smoothed_tracks(fit)
    spread = covariance(fit)
    found = [_variances(fit, list(_parts(fit, labels)), spread) for labels in _divisions(fit.tracks, courses)]
    return Heterogeneity(*np.max(found, axis=0))


def variances_in_time(fit: Fit) -> Floats:
    """Variances (unknowns,) of each q of a fit between parts of the recordings that follow one another; 0 if alike."""
    parts = list(_parts(fit, _in_time(fit.tracks)))
    return np.asarray(_variances(fit, parts, covariance(fit))[0])


def variances_of_other_forms(fit: Fit) -> Floats:
    """Variances (unknowns,) of q by which numbers differ under other laws of the kind, those of other effects included.

    What an effect of another form leaves over, the numbers take on that are told from the same readings: a platform's
    drag moves with a ratio of drags as far as the fit ties the two. Of numbers that the platform's file declares the
    form is the vehicle's own, and of the gain of one thruster, or of a place, nothing follows for others.
    """
    spread = np.array([spread_of_other_forms(each, q) for each, q in zip(fit.unknowns, fit.q.tolist(), strict=True)])
    places = spreads_of_places(fit)
    tied = covariance(fit)
    own = np.diag(tied)
    followed = np.divide(tied, own, out=np.zeros_like(tied), where=own > 0.0)
    np.fill_diagonal(followed, 1.0)
    alone = [unknown.column in OWN_GAINS or unknown.owner.effect == PLATFORM for unknown in fit.unknowns]
    followed[:, alone] = np.eye(len(alone))[:, alone]
    return np.asarray(np.square(followed * spread).sum(axis=1) + np.square(places))


def spread_of_other_forms(unknown: Unknown, q: float) -> float:
    """Standard deviation of q by which a number differs under other laws of the kind, as the file of its effect says.

    It is that for the effect itself, a share of what the number differs from that of no effect; what one robot has on
    top of others is of the same law. The gain of one thruster is told beside others, which are not quite alike.
    """
    if unknown.column in OWN_GAINS and unknown.column != ALL_THRUSTERS:
        return FORM_WIDTH.thrusters / abs(unknown.scale)  # of a logarithm, as all gains are fitted
    number = _number_of(unknown)
    if number is None or unknown.on_top:
        return 0.0
    return abs(number.other_form * (unknown.value(q) - float(NEUTRAL[COLUMN[unknown.column]])) / unknown.slope(q))


def spreads_of_places(fit: Fit) -> Floats:
    """Standard deviations (unknowns,) of q by which places differ under other laws of the kind; 0 for all else.

    It is a share of the distance to the robots, as the file of the effect says: a direction is what errs.
    """
    numbers = [_number_of(unknown) for unknown in fit.unknowns]
    shares = np.array([0.0 if number is None else number.other_place for number in numbers])
    if not shares.any():
        return np.zeros(len(shares))
    courses, filled = smoothed_tracks(fit), fit.filled
    for number in np.flatnonzero(shares):
        unknown = fit.unknowns[number]
        effect = unknown.column.partition(".")[0]
        columns = [COLUMN[f"{effect}.{axis}"] for axis in ("x", "y", "z")]
        tracks = list(unknown.tracks)
        swum = np.mean([courses[track].mean[:, X : Z + 1].mean(axis=0) for track in tracks], axis=0)
        distance = np.linalg.norm(filled[tracks[0], columns] - swum)
        shares[number] *= abs(distance / unknown.slope(float(fit.q[number])))
    return shares


def _number_of(unknown: Unknown) -> Number | None:
    """Find what the file of an effect says of its number; None if the unknown is of no effect, or not in its file."""
    effect, _, name = unknown.column.partition(".")
    numbers = DESCRIBED[effect].numbers if effect in DESCRIBED else ()
    return next((number for number in numbers if number.name == name), None)


def _divisions(tracks: Sequence[Track], courses: Sequence[Smoothed]) -> Iterator[list[Integers]]:
    """Number of the part of each reading (m,) of each track, in four divisions."""
    count = FORM_WIDTH.parts
    yield _in_time(tracks)
    for quantity in (_speed, _turn_rate, _height):
        values = [quantity(course.mean)[_points(track)] for track, course in zip(tracks, courses, strict=True)]
        edges = np.quantile(np.concatenate(values), np.arange(1, count) / count)
        yield [np.searchsorted(edges, value) for value in values]


def _in_time(tracks: Sequence[Track]) -> list[Integers]:
    count = FORM_WIDTH.parts
    return [number * count + track.timeline.parts(count) for number, track in enumerate(tracks)]


def _speed(course: Floats) -> Floats:
    return np.asarray(np.linalg.norm(course[:, SURGE : HEAVE + 1], axis=1))


def _turn_rate(course: Floats) -> Floats:
    return np.abs(course[:, YAW_RATE])


def _height(course: Floats) -> Floats:
    return course[:, Z]


def _points(track: Track) -> Integers:
    """Grid point next to each reading (m,)."""
    grid = track.timeline.grid
    return np.clip(np.rint((track.timeline.stamp - grid.begin) / grid.step).astype(np.int64), 0, grid.points - 1)


def _parts(fit: Fit, labels: Sequence[Integers]) -> Iterator[Part]:
    """Score and information of each part of a division that has readings."""
    known, size = information(fit), len(fit.unknowns)
    for part in np.unique(np.concatenate(labels)).tolist():
        score, matrix, tracks = np.zeros(size), np.zeros((size, size)), set()
        for number, (passed, felt, label) in enumerate(zip(fit.passes, known.own, labels, strict=True)):
            chosen: Flags = label == part
            if chosen.any():
                slope, variance = felt.slopes[chosen], passed.variance[chosen]
                matrix[felt.block] += weighted_products(slope, slope, variance)
                score[felt.unknowns] -= weighted_products(slope, passed.innovation[chosen, None], variance).ravel()
                tracks.add(number)
        yield Part(score, matrix, frozenset(tracks))


def _variances(fit: Fit, parts: Sequence[Part], spread: Floats) -> Floats:
    """Variances (2, unknowns) between the parts of one division and of their mean; spread: covariance of q."""
    moved = np.array([spread @ part.score for part in parts])
    share = [spread @ part.information for part in parts]
    noise = np.array([np.einsum("ij,ij->i", each, spread) for each in share])
    weight = np.array([np.diag(each) for each in share])
    found = np.zeros((2, len(fit.unknowns)))
    for index, unknown in enumerate(fit.unknowns):
        felt = np.array([bool(part.tracks & set(unknown.tracks)) for part in parts]) & (noise[:, index] > 0.0)
        between = _variance(moved[felt, index], noise[felt, index], weight[felt, index])
        found[:, index] = between, between * float(np.sum(weight[felt, index] ** 2))
    return found


def _variance(moved: Floats, noise: Floats, weight: Floats) -> float:
    """Variance between parts of one unknown; 0 if they agree, or too few of them tell of it.

    moved: (parts,) share of each part in the fitted q; noise: (parts,) variance of that share; weight: (parts,) by how
    much the share grows with the q of the part.
    """
    telling = weight**2 / noise
    if telling.sum() ** 2 < FORM_WIDTH.fewest * (telling**2).sum() or not telling.any():
        return 0.0
    disagreement, freedom = float(np.sum(moved**2 / noise)), len(moved) - 1
    if chi2.sf(disagreement, freedom) > FORM_WIDTH.sure:
        return 0.0
    return float((disagreement - freedom) / (telling.sum() - (telling**2).sum() / telling.sum()))
