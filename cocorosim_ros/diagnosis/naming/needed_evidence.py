"""How much evidence a candidate needs beside what is named already, and which numbers are too small to be believed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import SENSOR_CHANNELS, Amplitude
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit, information
from cocorosim_ros.diagnosis.naming.contest import Refined
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.naming.quiet_pump import quiet_gain


def held_against(candidate: Candidate, without: Fit, fit: Fit) -> float:
    """Nats that count against a candidate: its prior, and what the water may have had a hand in."""
    return candidate.entry.prior_nats + (quiet_gain(without, fit) if candidate.entry.of_pump else 0.0)


def standing(refined: Refined) -> float:
    """Evidence; a law outside the catalogue is believed only if it is clearly better than what is known."""
    return refined.nats - (NAMING.law_margin if refined.candidate.entry.law is not None else 0.0)


def is_tiny(refined: Refined) -> bool:
    """Whether all amplitudes of a candidate are too small to be believed."""
    candidate, fit = refined.candidate, refined.fit
    amplitudes = {amplitude.name: amplitude for amplitude in candidate.entry.amplitudes}
    values = [
        (amplitudes[fit.unknowns[place].owner.parameter], fit.unknowns[place].value(float(fit.q[place])))
        for place in candidate.places_among(fit.unknowns)
        if fit.unknowns[place].owner.parameter in amplitudes
    ]
    return all(is_negligible(candidate, amplitude, value) for amplitude, value in values)


def is_negligible(candidate: Candidate, amplitude: Amplitude, value: float) -> bool:
    """Whether one amplitude of a candidate [SI units] is too small to be believed."""
    least = max(NAMING.least_share * candidate.large(amplitude), amplitude.adds_up / candidate.duration)
    low, high = amplitude.negligible
    return min(low, -least) < value - amplitude.neutral < max(high, least)


def is_like(candidate: Candidate, other: Candidate) -> bool:
    """Whether a candidate may stand for another one: a law on its side, or one of its group in its stream."""
    entry = candidate.entry
    if entry.law is not None:
        return _side(candidate) == _side(other)
    return bool(entry.group) and (entry.group, entry.topic) == (other.entry.group, other.entry.topic)


def needed_nats(named: Sequence[NamedEffect], candidate: Candidate, fit: Fit) -> float:
    """Nats that a candidate in a fit needs beside the named effects: more than a wrong form of one would leave over.

    That is a form of an effect on the same side; a second fault of a sensor is no form of the first, only a law may be.
    An effect that does not look like another one at all is no rest of it either. A law of readings may be the rest of
    any motion.
    """
    others = [each for each in named if each.candidate.key != candidate.key]
    of_sensor, is_law = candidate.entry.channel in SENSOR_CHANNELS, candidate.entry.law is not None
    if of_sensor and not is_law:
        return NAMING.threshold
    shares = [
        (NAMING.law_rest if is_law else min(NAMING.form_share, _likeness(fit, candidate, each.candidate))) * each.nats
        for each in others
        if _side(each.candidate) == _side(candidate)
    ]
    if of_sensor:
        shares += [
            NAMING.law_share * each.nats for each in others if each.candidate.entry.channel not in SENSOR_CHANNELS
        ]
    return max([NAMING.threshold, *shares])


def _likeness(fit: Fit, candidate: Candidate, other: Candidate) -> float:
    """The greatest squared cosine between what numbers of the one and of the other change in the readings."""
    matrix = information(fit).matrix
    size = np.diag(matrix)
    mine, theirs = (each.places_among(fit.unknowns) for each in (candidate, other))
    scale = np.outer(size[mine], size[theirs])
    return float((matrix[np.ix_(mine, theirs)] ** 2 / np.maximum(scale, 1e-300)).max())


def _side(candidate: Candidate) -> str:
    """Which motion an effect acts on first, or which sensor."""
    channel = candidate.entry.channel
    return channel if channel in SENSOR_CHANNELS else "upright" if channel == "heave" else "level"
