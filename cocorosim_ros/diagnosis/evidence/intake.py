"""The last step before physics: robots that can tell something, in the axes and units of the contract."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from cocorosim_ros.diagnosis.evidence.abstention import reasons_to_abstain, without_unusable
from cocorosim_ros.diagnosis.evidence.consistency import speed_sentence
from cocorosim_ros.diagnosis.evidence.frames.suspect import suspect_frames
from cocorosim_ros.diagnosis.evidence.frames.suspicion import FrameSuspicion, corrected
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, Recording, RobotLog, told_apart
from cocorosim_ros.scenario.parts.platform import Platform


@dataclass(frozen=True)
class Mixup:
    """A stream of some robots that was in other axes, signs or units, and was put right."""

    robots: tuple[str, ...]
    suspicion: FrameSuspicion


@dataclass(frozen=True)
class Intake:
    """Evidence that physics may be asked of: usable robots alone, streams put right; what was found on the way.

    reasons: why no diagnosis can be made, in sentences; then `evidence` has no robot.
    """

    evidence: Evidence
    mixups: tuple[Mixup, ...]
    reasons: tuple[str, ...]


def take_in(evidence: Evidence) -> Intake:
    """The evidence without robots that cannot tell anything, with frames and units of the contract.

    Every recording of a robot is judged alone, then all of them together: what one is too short to show. A stream that
    cannot be put right is left out. The recordings' remarks say what was done.
    """
    reasons = reasons_to_abstain(evidence)
    if reasons:
        nobody = tuple(replace(recording, robots=()) for recording in evidence.recordings)
        return Intake(replace(evidence, recordings=nobody), (), reasons)
    recordings = list(without_unusable(evidence).recordings)
    found: list[Mixup] = []
    for name in sorted({robot.name for recording in recordings for robot in recording.robots}):
        places = [number for number, recording in enumerate(recordings) if _robot(recording, name)]
        for number in places:
            found += _put_right(recordings, [number], name, evidence.platform)
        if len(places) > 1:
            found += _put_right(recordings, places, name, evidence.platform)
    recordings = [_with_speeds(recording, evidence.platform) for recording in recordings]
    return Intake(replace(evidence, recordings=told_apart(recordings)), _together(found), ())


def _with_speeds(recording: Recording, platform: Platform) -> Recording:
    sentences = [speed_sentence(robot, platform) for robot in recording.robots]
    return replace(recording, remarks=(*recording.remarks, *(sentence for sentence in sentences if sentence)))


def _robot(recording: Recording, name: str) -> RobotLog | None:
    return next((robot for robot in recording.robots if robot.name == name), None)


def _put_right(recordings: list[Recording], places: Sequence[int], name: str, platform: Platform) -> list[Mixup]:
    """What these recordings of a robot show together; they are replaced by corrected ones."""
    logs = [log for log in (_robot(recordings[number], name) for number in places) if log]
    suspicions = suspect_frames(logs, platform)
    if suspicions:
        for number in places:
            recordings[number] = _corrected(recordings[number], name, suspicions)
    return [Mixup((name,), suspicion) for suspicion in suspicions]


def _corrected(recording: Recording, name: str, suspicions: Sequence[FrameSuspicion]) -> Recording:
    robots = tuple(_without(corrected(robot, suspicions), suspicions) if robot.name == name else robot
                   for robot in recording.robots)  # fmt: skip
    remarks = [
        f"{name}/{suspicion.topic}: {suspicion.correction} ({suspicion.because}); "
        + ("it was put right." if suspicion.matrix is not None else "it is not used.")
        for suspicion in suspicions
    ]
    return replace(recording, robots=robots, remarks=(*recording.remarks, *remarks))


def _without(log: RobotLog, suspicions: Sequence[FrameSuspicion]) -> RobotLog:
    hopeless = {suspicion.topic for suspicion in suspicions if suspicion.matrix is None}
    return replace(log, streams={topic: stream for topic, stream in log.streams.items() if topic not in hopeless})


def _together(found: Sequence[Mixup]) -> tuple[Mixup, ...]:
    """One mix-up for all robots and recordings that have the same, the strongest of its suspicions."""
    merged: dict[tuple[str, str], Mixup] = {}
    for mixup in found:
        key = mixup.suspicion.topic, mixup.suspicion.correction
        known = merged.get(key, mixup)
        strongest = max(known.suspicion, mixup.suspicion, key=lambda suspicion: suspicion.nats)
        robots = tuple(dict.fromkeys([*known.robots, *mixup.robots]))
        merged[key] = Mixup(robots, strongest)
    return tuple(sorted(merged.values(), key=lambda mixup: -mixup.suspicion.nats))
