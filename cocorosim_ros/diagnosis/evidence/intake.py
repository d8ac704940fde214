"""The last step before physics: robots with enough information, in the axes and units of the contract."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

from cocorosim_ros.diagnosis.evidence.abstention import reasons_to_abstain, without_unusable
from cocorosim_ros.diagnosis.evidence.consistency import speed_sentences
from cocorosim_ros.diagnosis.evidence.frames.correction import FrameCorrection, put_right
from cocorosim_ros.diagnosis.evidence.frames.kinematics import contradictions
from cocorosim_ros.diagnosis.evidence.frames.motion import motion_together
from cocorosim_ros.diagnosis.evidence.frames.needed_corrections import needed_corrections
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, told_apart
from cocorosim_ros.scenario.parts.platform import Platform

Sought = Callable[[Sequence[RobotLog], Platform], tuple[FrameCorrection, ...]]
"""Corrections that logs of one robot need, by their platform."""


@dataclass(frozen=True)
class Mixup:
    """The correction of a stream that some robots have in other axes, signs or units."""

    robots: tuple[str, ...]
    correction: FrameCorrection


@dataclass(frozen=True)
class Intake:
    """Evidence with usable robots alone and corrected streams, and the mix-ups that were corrected.

    reasons: sentences if no diagnosis can be made; then `evidence` has no robot.
    """

    evidence: Evidence
    mixups: tuple[Mixup, ...]
    reasons: tuple[str, ...]


def take_in(
    evidence: Evidence,
    beside: Sequence[RecordingLog] = (),
    right: Sequence[RecordingLog] = (),
    *,
    by_commands: bool = True,
) -> Intake:
    """Leave out robots with too little information, and bring streams into the frames and units of the contract.

    Streams are compared in all recordings of a robot together, for mix-ups that one recording is too short to show or
    to tell from others, then in every recording alone. A stream that cannot be corrected, or then still contradicts
    another one, is left out. Remarks report every change.
    beside: further recordings of the same robots that the evidence is fitted together with; they are not changed.
    right: recordings of the same robots that are in axes and units of the contract. by_commands: whether streams are
    compared with the motion that is commanded as well, and not with each other alone.
    """
    reasons = reasons_to_abstain(evidence, beside)
    if reasons:
        without_robots = tuple(replace(recording, robots=()) for recording in evidence.recordings)
        return Intake(replace(evidence, recordings=without_robots), (), reasons)
    recordings = list(without_unusable(evidence, beside).recordings)
    found: list[Mixup] = []
    for name in sorted({robot.name for recording in recordings for robot in recording.robots}):
        places = [number for number, recording in enumerate(recordings) if _robot(recording, name)]
        known = [robot for recording in right if (robot := _robot(recording, name))]
        sought = partial(needed_corrections if by_commands else _needed_among_streams, beside=known)
        if len(places) > 1:
            found += _put_right(recordings, places, name, sought, evidence.platform)
        for number in places:
            found += _put_right(recordings, [number], name, sought, evidence.platform)
        for number in places:
            found += _put_right(recordings, [number], name, _contradictory, evidence.platform)
    recordings = [_with_speeds(recording, evidence.platform) for recording in recordings]
    return Intake(replace(evidence, recordings=told_apart(recordings)), _together(found), ())


def _with_speeds(recording: RecordingLog, platform: Platform) -> RecordingLog:
    sentences = [sentence for robot in recording.robots for sentence in speed_sentences(robot, platform)]
    return replace(recording, remarks=(*recording.remarks, *sentences))


def _robot(recording: RecordingLog, name: str) -> RobotLog | None:
    return next((robot for robot in recording.robots if robot.name == name), None)


def _contradictory(logs: Sequence[RobotLog], platform: Platform) -> tuple[FrameCorrection, ...]:
    return tuple(contradictions(motion_together(logs, platform)))


def _needed_among_streams(
    logs: Sequence[RobotLog], platform: Platform, beside: Sequence[RobotLog]
) -> tuple[FrameCorrection, ...]:
    """Corrections that streams need to agree with each other, whatever was commanded."""
    return needed_corrections(_without_commands(logs), platform, _without_commands(beside))


def _without_commands(logs: Sequence[RobotLog]) -> list[RobotLog]:
    return [replace(log, command_time=log.command_time[:0], command=log.command[:0], acting=None) for log in logs]


def _put_right(
    recordings: list[RecordingLog], places: Sequence[int], name: str, sought: Sought, platform: Platform
) -> list[Mixup]:
    """Correct some recordings of a robot by what they show together, in place, and give the mix-ups."""
    logs = [log for log in (_robot(recordings[number], name) for number in places) if log]
    corrections = sought(logs, platform)
    if corrections:
        for number in places:
            recordings[number] = _corrected(recordings[number], name, corrections)
    return [Mixup((name,), correction) for correction in corrections]


def _corrected(recording: RecordingLog, name: str, corrections: Sequence[FrameCorrection]) -> RecordingLog:
    robots = tuple(put_right(robot, corrections) if robot.name == name else robot for robot in recording.robots)
    remarks = [
        f"{name}/{correction.topic}: {correction.wrong} ({correction.because}); "
        + ("it was put right." if correction.matrix is not None else "it is not used.")
        for correction in corrections
    ]
    return replace(recording, robots=robots, remarks=(*recording.remarks, *remarks))


def _together(found: Sequence[Mixup]) -> tuple[Mixup, ...]:
    """Merge mix-ups that several robots or recordings share into one, with the strongest of their corrections."""
    merged: dict[tuple[str, str], Mixup] = {}
    for mixup in found:
        key = mixup.correction.topic, mixup.correction.wrong
        known = merged.get(key, mixup)
        strongest = max(known.correction, mixup.correction, key=lambda correction: correction.nats)
        robots = tuple(dict.fromkeys([*known.robots, *mixup.robots]))
        merged[key] = Mixup(robots, strongest)
    return tuple(sorted(merged.values(), key=lambda mixup: -mixup.correction.nats))
