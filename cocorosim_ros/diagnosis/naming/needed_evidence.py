"""Evidence that a candidate needs beside the named effects, and amplitudes that are too small to be believed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import SENSOR_CHANNELS, Amplitude
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit, information
from cocorosim_ros.diagnosis.naming.contest import Refined
from cocorosim_ros.diagnosis.naming.declared_errors import products_of_held, share_of_declared_errors
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.naming.quiet_pump import quiet_gain
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.terms.groups import LATE

BY_THE_CLOCK = {"sin_t", "cos_t"}
"""Regressors of the clock alone."""


def held_against(candidate: Candidate, without: Fit, fit: Fit) -> float:
    """Nats that count against a candidate: the odds of its prior, and gains that the water may have caused.

    Of what it gains, the share counts against it that it would gain among recordings that should be alike.
    without, fit: the model without and with the candidate.
    """
    against = candidate.entry.prior_nats + (quiet_gain(without, fit) if candidate.entry.of_pump else 0.0)
    return against + usual_gain(candidate, without, fit)


def usual_gain(candidate: Candidate, without: Fit, fit: Fit) -> float:
    """Nats of a candidate's gain that count against it, because recordings that should be alike differ in it too."""
    if not candidate.spread > 1.0:
        return 0.0
    return max(fit.objective - without.objective, 0.0) * (1.0 - 1.0 / candidate.spread)


def standing(refined: Refined) -> float:
    """Evidence of a candidate by which it may be named [nats]; that of a law outside the catalogue less a margin.

    There are many such laws: one is named only if it is clearly better than all entries of the catalogue.
    """
    return refined.nats - (NAMING.law_margin if refined.candidate.entry.law is not None else 0.0)


def is_tiny(refined: Refined) -> bool:
    """Tell whether all amplitudes of a candidate are too small to be believed."""
    candidate, fit = refined.candidate, refined.fit
    amplitudes = {amplitude.name: amplitude for amplitude in candidate.entry.amplitudes}
    values = [
        (amplitudes[unknown.owner.parameter], unknown, float(fit.q[place]))
        for place, unknown in enumerate(fit.unknowns)
        if candidate.owns(unknown) and unknown.owner.parameter in amplitudes
    ]
    return all(
        is_negligible(candidate, amplitude, unknown.alone(q, amplitude.neutral)) for amplitude, unknown, q in values
    )


def is_negligible(candidate: Candidate, amplitude: Amplitude, value: float) -> bool:
    """Tell whether a value of one amplitude of a candidate [SI units] is too small to be believed."""
    adds_up = candidate.sizes["s"] * amplitude.adds_up
    least = max(NAMING.least_share * candidate.large(amplitude), adds_up / candidate.duration)
    low, high = candidate.negligible(amplitude)
    return min(low, -least) < value - amplitude.neutral < max(high, least)


def is_like(candidate: Candidate, other: Candidate) -> bool:
    """Tell whether a candidate may stand for another one.

    A law outside the catalogue may stand for what acts on the same side of the motion, or on the same sensor; one that
    swings by the clock, whatever the robot does, for no entry of the catalogue. An entry of the catalogue may stand for
    those of its confusable group in the same stream.
    """
    entry = candidate.entry
    if entry.law is not None:
        return _side(candidate) == _side(other) and not (_swings(candidate) and other.entry.law is None)
    return bool(entry.group) and (entry.group, entry.topic) == (other.entry.group, other.entry.topic)


def needed_nats(named: Sequence[NamedEffect], candidate: Candidate, fit: Fit) -> float:
    """Nats that a candidate needs beside the named effects: the threshold, or more where it may be a rest of theirs.

    An effect in the water rarely has exactly the form of the catalogue. A share of its nats is left over, and a further
    candidate may explain that rest without being there. So a candidate needs more than this share

    - of each named effect on the same side of the motion, or the same sensor; for an entry of the catalogue no more
      than the likeness of the two, since an effect that changes other readings than the named one cannot be its rest;
      beside one that was found before more, for what may be another form of it; beside added mass of the platform's
      file, which has one form, what errors of its numbers may explain;
    - of every named effect of motion, if it is a law of readings.

    A second fault of one sensor is not a rest of the first; only a law outside the catalogue may be. But what comes
    late, of a stream or of its clock, may be a rest of anything else that does: pods that turn slowly, told as commands
    that act late, left a skew of a boat's poses over.
    fit: a model that has the candidate and the named effects.
    """
    others = [each for each in named if each.candidate.key != candidate.key]
    of_sensor, is_law = candidate.entry.channel in SENSOR_CHANNELS, candidate.entry.law is not None
    if of_sensor and not is_law:
        late = [each for each in others if candidate.entry.group == each.candidate.entry.group == LATE]
        return max([NAMING.threshold, *(_rest_of(fit, candidate, each) for each in late)])
    rests = [_rest_of(fit, candidate, each) for each in others if _side(each.candidate) == _side(candidate)]
    if of_sensor:
        rests += [
            NAMING.law_share * each.nats for each in others if each.candidate.entry.channel not in SENSOR_CHANNELS
        ]
    return max([NAMING.threshold, *rests])


def _rest_of(fit: Fit, candidate: Candidate, named: NamedEffect) -> float:
    """Nats that a candidate on the same side as a named effect may explain without being there."""
    most = _share_left_over(candidate, named) * named.nats
    if most > NAMING.threshold and _may_be_off_alone(named, fit):
        left = 1.0 - share_of_declared_errors(fit, candidate, named.candidate)
        return min(most, NAMING.threshold / left) if left > 0.0 else most
    law = candidate.entry.law is not None
    if most <= NAMING.threshold or named.found_before or (law and not _swings(candidate)):
        return most
    return min(most, likeness(fit, candidate, named.candidate) * named.nats)


def _may_be_off_alone(named: NamedEffect, fit: Fit) -> bool:
    """Tell whether an effect is of inertia, which has one form, with numbers of the file that the fit holds."""
    effect = EFFECTS.get(named.candidate.entry.id)
    held = not named.found_before and not named.candidate.places_among(fit.unknowns)
    return held and effect is not None and effect.inertia is not None


def _share_left_over(candidate: Candidate, named: NamedEffect) -> float:
    """Share of the nats of a named effect that its law may leave over for a candidate on the same side.

    An entry that is confused with it, as a layer of dense water with a hull that gives way, explains more of that rest
    than others do. Beside an effect that was found before, laws, and entries that are confused with it, count as alike.
    """
    entry, other = candidate.entry, named.candidate
    is_confused = bool(entry.group) and entry.group == other.entry.group
    if named.found_before and (entry.law is not None or is_confused):
        return NAMING.law_form
    if entry.law is not None:
        return NAMING.law_rest
    return NAMING.group_share if is_confused else NAMING.form_share


def _swings(candidate: Candidate) -> bool:
    """Tell whether a candidate is a law that swings by the clock alone, whatever the robot does."""
    form = candidate.entry.form
    return form is not None and {factor.name for factor in form.product.factors} <= BY_THE_CLOCK


def likeness(fit: Fit, candidate: Candidate, other: Candidate) -> float:
    """Likeness of two candidates (0 to 1): the greatest squared cosine between a slope of one and a slope of the other.

    Slopes are those of the innovations by their unknowns; the information matrix of the fit holds their products. Of an
    effect that the model has and does not fit they are those by its amplitudes, as these are.
    """
    matrix = information(fit).matrix
    size = np.diag(matrix)
    mine, theirs = (each.places_among(fit.unknowns) for each in (candidate, other))
    products, its = (matrix[np.ix_(mine, theirs)], size[theirs]) if theirs else _with_fixed(fit, mine, other)
    return float((products**2 / np.maximum(np.outer(size[mine], its), 1e-300)).max())


def _with_fixed(fit: Fit, mine: Sequence[int], other: Candidate) -> tuple[Floats, Floats]:
    """Products (mine, amplitudes) of slopes by unknowns and by amplitudes that are not fitted, and squares of these."""
    shared, own, _ = products_of_held(fit, other.amplitudes())
    return shared[mine], np.diag(own)


def _side(candidate: Candidate) -> str:
    """Side of a candidate: 'upright' for motion in heave, 'level' for other motion, or the channel of its sensor."""
    channel = candidate.entry.channel
    return channel if channel in SENSOR_CHANNELS else "upright" if channel == "heave" else "level"
