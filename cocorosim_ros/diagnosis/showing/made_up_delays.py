"""Short delays among readings whose errors last, which the filter may have made up.

To take off the error that the reading before had, the filter reckons that reading back along the rates of the present
(`filter.coloured`). Where rates changed in between, as thrust that jumps changes them, it errs as a model does whose
readings come late, or whose thrusters lag, by a part of the gap between two readings. So a delay that is shorter than
that gap, or a lag that is shorter than a step of the filter, is no finding there, whatever evidence it has.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.fitting.coloured_readings import memories_of, robots_of
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL

TOO_SHORT = (
    "Errors of these readings last, and the filter follows them from one reading to the next: over so short a time "
    "a change of speed passes for a delay."
)
SHORTER_THAN_A_GAP = "it is shorter than readings whose errors last can tell"


def is_made_up(effect: NamedEffect, fit: Fit) -> bool:
    """Tell whether all numbers of an effect are times that lasting errors of readings may have made up."""
    candidate = effect.candidate
    names = {amplitude.name for amplitude in candidate.entry.amplitudes if amplitude.unit == "s"}
    if not names or robots_of(memories_of(fit)).isdisjoint(candidate.robots):
        return False
    own = [place for place in candidate.places_among(fit.unknowns) if fit.unknowns[place].owner.parameter in names]
    return bool(own) and all(_time(fit, place) < _gap(fit, fit.unknowns[place]) for place in own)


def _time(fit: Fit, place: int) -> float:
    """Time [s] that an unknown of a fit tells."""
    unknown = fit.unknowns[place]
    return abs(unknown.alone(float(fit.q[place]), float(NEUTRAL[COLUMN[unknown.column]])))


def _gap(fit: Fit, unknown: Unknown) -> float:
    """Time [s] between two readings of the unknown's stream, as a rule; a step of the filter without a stream."""
    tracks, topic = [fit.tracks[number] for number in unknown.tracks], unknown.owner.topic
    if topic is None:
        return max(track.timeline.grid.step for track in tracks)
    return max(
        (float(np.median(np.diff(track.log.streams[topic].time))) for track in tracks if topic in track.log.streams),
        default=0.0,
    )
