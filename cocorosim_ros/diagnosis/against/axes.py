"""Axes of poses to be judged, told by the learned vehicle: those in which it moves as it did when it was well.

Streams are compared with rough motion under the commands, of which a ship that coasts for a minute gives few
independent readings, and poses may be the only stream. The learned vehicle foretells far more: of a ship whose
positions are mirrored nothing follows but a random force that is as strong as its propeller.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.against.joint import judged_alone
from cocorosim_ros.diagnosis.criteria.against import AXES_OF_VEHICLE
from cocorosim_ros.diagnosis.evidence.frames.correction import FrameCorrection, put_right
from cocorosim_ros.diagnosis.evidence.frames.needed_corrections import pose_correction
from cocorosim_ros.diagnosis.evidence.frames.orientation import Orientation
from cocorosim_ros.diagnosis.evidence.frames.turned import ALL_TURNED, SAME, SWAPPED
from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.climbing import with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.tracks.columns import WATER
from cocorosim_ros.foundation.arrays import Floats

ONLY_SO = "only so the vehicle moves as in the recordings of --against"


def in_its_axes(learned: Fit, joint: Fit, intake: Intake) -> Intake:
    """Turn the poses of recordings to be judged, if only so they are of the learned vehicle; else as they are.

    joint: fit of both, with the water that the judged recordings need as they are. Only axes in which they are likelier
    in this very water are looked at further: then all are given the water that they need, and the best has to lead.
    """
    count = len(learned.tracks)
    if not any("pose" in track.log.streams for track in joint.tracks[count:]):
        return intake
    rows = joint.filled[count:]
    as_recorded = sum(passed.log_likelihood for passed in joint.passes[count:])
    promising = [
        trial
        for trial in (_trial(intake.evidence, turned) for turned in _turns())
        if _at(learned, trial.evidence, rows).objective > as_recorded
    ]
    if not promising:
        return intake
    waters = (learned.filled[:, WATER].mean(axis=0), rows[:, WATER].mean(axis=0))
    told = [_told(learned, trial.evidence, waters) for trial in promising]
    best = int(np.argmax(told))
    others = [_told(learned, intake.evidence, waters), *told[:best], *told[best + 1 :]]
    lead = told[best] - max(others)
    if not lead > AXES_OF_VEHICLE.lead:
        return intake
    correction = replace(promising[best].correction, nats=lead)
    robots = tuple(dict.fromkeys(track.name for track in joint.tracks[count:]))
    return Intake(promising[best].evidence, (*intake.mixups, Mixup(robots, correction)), intake.reasons)


class _Trial(NamedTuple):
    """Recordings in other axes, and the correction that brings them there."""

    evidence: Evidence
    correction: FrameCorrection


def _trial(evidence: Evidence, turned: Orientation) -> _Trial:
    correction = pose_correction(turned, ONLY_SO)
    recordings = tuple(
        replace(each, robots=tuple(put_right(log, [correction]) for log in each.robots)) for each in evidence.recordings
    )
    return _Trial(replace(evidence, recordings=recordings), correction)


def _at(learned: Fit, evidence: Evidence, rows: Floats) -> Fit:
    """Run the filter over recordings with numbers in rows (tracks, columns)."""
    alone = judged_alone(learned, evidence, learned.filled)
    return evaluated(replace(alone, rows=rows, noise=(), q_noise=np.zeros(0)))


def _told(learned: Fit, evidence: Evidence, waters: Sequence[Floats]) -> float:
    """Objective [nats] of recordings alone, noise fitted from each of some waters on, of the best of these fits.

    All other numbers are those of the learned vehicle.
    """
    known = learned.filled

    def beginning(water: Floats) -> float:
        known[:, WATER] = water
        return with_noise(evaluated(judged_alone(learned, evidence, known)), AXES_OF_VEHICLE.rounds).objective

    return max(map(beginning, waters))


def _turns() -> Iterator[Orientation]:
    """Changes of the axes of poses: of positions, of the yaw, and of both alike.

    Turned positions are left out beside a yaw that is turned the other way: one is the other in a turned world.
    """
    for turned in ALL_TURNED:
        if turned.mirrored:
            yield Orientation(position=turned)
        if turned != SAME:
            yield Orientation(yaw=turned)
    yield Orientation(position=SWAPPED, yaw=SWAPPED)
