"""Bounds of instruments: an error beyond what such an instrument can be wrong by is no hypothesis."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.sensors.sensor import MostError


def is_beyond_instrument(candidate: Candidate, fit: Fit) -> bool:
    """Tell whether a fit gives a candidate that is an error of readings more than such an instrument can err by.

    The error of a law counts by its root mean square over the readings, that of an entry of the catalogue number by
    number. Errors of stamps have no such bound.
    """
    if candidate.entry.form is not None:
        errors = _errors_of_law(candidate, fit)
    else:
        errors = _errors_of_entry(candidate, fit)
    return any(error > bound for error, bound in errors)


def most_error(kind: str, values: Floats, own: MostError | None = None, hull: float = 0.0) -> float:
    """The most [unit of the kind] that an instrument may err by where its readings are `values` (n,).

    own: of one error, where it is another than that of the kind. hull: length of the vehicle's [m].
    """
    most = own or KINDS[kind].most_error
    spread = 0.0 if KINDS[kind].angle else float(np.std(values))  # a heading has no zero to be in proportion to
    return max(most.amount, most.share * spread, most.hulls * hull)


def _errors_of_law(candidate: Candidate, fit: Fit) -> Iterator[tuple[float, float]]:
    """Error and bound [unit of the reading] of a law of readings, by track."""
    law, filled = candidate.entry.form, fit.filled
    if law is None or law.topic is None:
        return
    for number in candidate.everybody:
        track = fit.tracks[number]
        chosen = track.timeline.kind == KIND_NAMES.index(law.of)
        if chosen.any():
            error = track.filter.law_shift(filled[number])[chosen]
            yield float(np.sqrt(np.mean(error**2))), most_error(law.of, track.timeline.value[chosen])


def _errors_of_entry(candidate: Candidate, fit: Fit) -> Iterator[tuple[float, float]]:
    """Error and bound of every number of an error of the catalogue, by track, both in the unit of its reading.

    A difference on top of what other tracks share is the error by itself.
    """
    if candidate.entry.id not in ERRORS:
        return
    kinds = {name: change.kind for change in ERRORS[candidate.entry.id].changes for name in change.numbers}
    neutral = {amplitude.name: amplitude.neutral for amplitude in candidate.entry.amplitudes}
    for place in candidate.places_among(fit.unknowns):
        unknown = fit.unknowns[place]
        kind = kinds.get(unknown.owner.parameter)
        if kind is None:
            continue
        without = neutral[unknown.owner.parameter]
        off = abs(unknown.alone(float(fit.q[place]), without) - without)
        for number in unknown.tracks:
            yield _error_and_bound(unknown, kind, off, fit.tracks[number])


def _error_and_bound(unknown: Unknown, kind: str, off: float, track: Track) -> tuple[float, float]:
    """Error that a number makes which is `off` its neutral value: itself, a gain, or a rate over the recording."""
    values = track.timeline.value[track.timeline.kind == KIND_NAMES.index(kind)]
    if len(values) == 0:
        return 0.0, 0.0
    own = ERRORS[unknown.owner.effect].most_error
    unit, most = KINDS[kind].unit, most_error(kind, values, own, track.vehicle.hull)
    if unknown.owner.unit in ("1", "rad") and unknown.owner.unit != unit:  # a gain, or a vector that is turned
        return off * float(np.std(values)), most
    times = track.timeline.grid.duration if unknown.owner.unit == f"{unit}/s" else 1.0
    return off * times, most
