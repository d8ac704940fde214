"""Deviations of streams about which an effect was found: readings less expectations, before and after naming."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.findings import FoundEffect, ResidualReading
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.foretelling.deviation import KIND_OF_TOPIC, RECORDED, deviation, unit_of_kind
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.reading_laws import factor_at
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.laws.law import Factor, Product
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.regressors import HEADING


@dataclass(frozen=True)
class SmoothedFit:
    """A fit, and the smoothed course of each of its tracks under it."""

    fit: Fit
    courses: Sequence[Smoothed]

    def of_track(self, number: int) -> SmoothedTrack:
        """The track of this number under the fit."""
        return SmoothedTrack(self.courses[number], self.fit.filled[number])


@dataclass(frozen=True)
class SmoothedTrack:
    """The smoothed course of a track, and the row of numbers (columns,) under which it was smoothed."""

    course: Smoothed
    row: Floats


def residual_readings(
    base: SmoothedFit, final: SmoothedFit, effects: Sequence[FoundEffect]
) -> tuple[ResidualReading, ...]:
    """Deviations of every stream that one of the effects is about, under the recalibrated and under the final fit."""
    found = []
    for effect in effects:
        topic = effect.topic or (ERRORS[effect.id].sensor if effect.id in ERRORS else None)
        if effect.correction is not None or topic not in KIND_OF_TOPIC or _of_another_reading(effect, topic):
            continue
        product = _product(effect, topic)
        for number, track in enumerate(base.fit.tracks):
            chosen = track.timeline.kind == KIND_OF_TOPIC[topic]
            if track.name not in effect.robots or not chosen.any():
                continue
            last = final.of_track(number)
            before, after = (deviation(track, chosen, each.course, each.row) for each in (base.of_track(number), last))
            stamp = track.timeline.stamp[chosen]
            against = _along(product, stamp, track, last.course, last.row)
            unit = unit_of_kind(KIND_OF_TOPIC[topic])
            found.append(
                ResidualReading(track.name, topic, unit, product.text, stamp, against, before, after, product.unit)
            )
    return tuple(found)


def _of_another_reading(effect: FoundEffect, topic: str) -> bool:
    """Tell whether an effect is a law of a reading that is not drawn for its topic, as accelerations of the imu."""
    return effect.law is not None and effect.law.of != KIND_NAMES[KIND_OF_TOPIC[topic]]


def _product(effect: FoundEffect, topic: str) -> Product:
    """Product of regressors that the deviation of a stream depends on under an effect."""
    if effect.law is not None:
        return effect.law.product
    if effect.id == "sensor_latency":
        # A late stream is off by its rate of change times the delay, a wrong clock ever more as time goes on.
        return Product(Factor(RECORDED[topic].late_with))
    against = ERRORS[effect.id].against if effect.id in ERRORS else "t"
    return Product(Factor(against.strip("|"), signed=not against.startswith("|")))


def _along(product: Product, stamp: Floats, track: Track, course: Smoothed, row: Floats) -> Floats:
    """Values (n,) of a product at stamps (n,) [s] along a smoothed course; headings between -pi and pi.

    row: the numbers of the model, for what actuators deliver.
    """
    seen = track.actuation.course_along(course, row)
    with np.errstate(divide="ignore", invalid="ignore"):
        values = factor_at(seen, stamp, product.first) * factor_at(seen, stamp, product.second)
    return np.mod(values + np.pi, 2.0 * np.pi) - np.pi if product.text == HEADING.name else values
