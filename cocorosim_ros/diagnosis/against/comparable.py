"""Recordings made comparable: the same robots with the same streams on both sides, and parts enough for a control."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.against.same_vehicle import check_same_vehicle
from cocorosim_ros.diagnosis.criteria.against import ALIKE
from cocorosim_ros.diagnosis.evidence.frames.correction import COMMAND, put_right
from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.fitting.borne_out import soundly_taken_in
from cocorosim_ros.diagnosis.tracks.lateness import clocks_of
from cocorosim_ros.foundation.arrays import Flags
from cocorosim_ros.foundation.errors import CocorosimError


def comparable(bad: Evidence, good: Evidence) -> tuple[Evidence, Evidence]:
    """Keep the robots and streams that both sides have; remarks of the recordings to be judged say what is left out.

    A single robot is compared with a single one, whatever their names. Raises CocorosimError where nothing can be
    compared: other robots, no common stream, another vehicle by the scenarios of the recordings, or commands of another
    size.
    """
    pairs = _pairs(bad, good)
    good = _renamed(good, pairs)
    streams = {name: _streams(good, name) for name in _names(good)}
    shared = [name for name in _names(bad) if name in streams]
    if not shared:
        raise CocorosimError(
            f"--against has the robots {_listed(_names(good))}, and the recordings to be judged have "
            f"{_listed(_names(bad))}; give recordings of the same robots, by the same names."
        )
    if not any(_streams(bad, name) & streams[name] for name in shared):
        raise CocorosimError(
            f"--against has the streams {_listed(set().union(*streams.values()))}; the recordings to be judged have "
            f"{_listed(set().union(*(_streams(bad, name) for name in shared)))}; nothing can be compared without a "
            "common stream."
        )
    check_same_vehicle(bad, good, pairs)
    kept = tuple(_with_streams(recording, streams) for recording in bad.recordings)
    return replace(bad, recordings=kept), good


def taken_in(bad: Evidence, good: Evidence) -> tuple[Intake, Intake]:
    """Bring both sides into frames and units of the contract, the judged one first by the corrections of the other.

    So the mix-ups of the judged side are those that the other does not have; remarks say what both have. Which of two
    streams is mirrored may show only beside the other side.
    """
    well = soundly_taken_in(good, bad.recordings)
    recordings = tuple(_put_right_alike(recording, well.mixups) for recording in bad.recordings)
    return soundly_taken_in(replace(bad, recordings=recordings), good.recordings, well.evidence.recordings), well


def _put_right_alike(recording: RecordingLog, mixups: Sequence[Mixup]) -> RecordingLog:
    """Correct a recording by what those of GOOD need, and say so."""
    robots, remarks = [], list(recording.remarks)
    for log in recording.robots:
        needed = [mixup.correction for mixup in mixups if log.name in mixup.robots]
        robots.append(put_right(log, needed))
        remarks += [
            f"{log.name}/{each.topic}: {each.wrong} in the recordings of --against; "
            + ("here it was put right alike." if each.matrix is not None else "here it is not used either.")
            for each in needed
            if each.topic in (COMMAND, *log.streams)
        ]
    return replace(recording, robots=tuple(robots), remarks=tuple(remarks))


def in_parts(good: Evidence) -> Evidence:
    """Cut the recordings, if there are few, into parts of equal length, so that their spread can be told."""
    wanted = -(-ALIKE.parts // max(len(good.recordings), 1))
    return replace(good, recordings=tuple(part for each in good.recordings for part in _parts(each, wanted)))


def _parts(recording: RecordingLog, wanted: int) -> list[RecordingLog]:
    count = max(1, min(wanted, int(recording.duration / ALIKE.shortest)))
    ends = np.linspace(0.0, recording.duration, count + 1)
    ends[-1] = np.inf
    return [
        replace(recording, robots=tuple(_between(log, begin, end) for log in recording.robots))
        for begin, end in zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True)
    ]


def _between(log: RobotLog, begin: float, end: float) -> RobotLog:
    """Take the readings of a log from `begin` to before `end` [s]; commands stay, as earlier ones may hold on."""
    streams = {
        topic: _cut(stream, (stream.time >= begin) & (stream.time < end)) for topic, stream in log.streams.items()
    }
    return replace(log, streams={topic: stream for topic, stream in streams.items() if len(stream.time)})


def _cut(stream: Stream, chosen: Flags) -> Stream:
    return replace(stream, time=stream.time[chosen], value=stream.value[chosen])


def _names(evidence: Evidence) -> list[str]:
    return sorted({robot.name for recording in evidence.recordings for robot in recording.robots})


def _pairs(bad: Evidence, good: Evidence) -> dict[str, str]:
    """Names in GOOD of the robots of BAD, by their names there: the same, or the only one of each side."""
    mine, theirs = _names(bad), _names(good)
    if len(mine) == len(theirs) == 1:
        return {mine[0]: theirs[0]}
    return {name: name for name in mine if name in theirs}


def _renamed(good: Evidence, pairs: Mapping[str, str]) -> Evidence:
    """Give a robot of GOOD the name of the one that is compared with it; a remark says so where it has another."""
    names = {theirs: mine for mine, theirs in pairs.items() if mine != theirs}
    if not names:
        return good
    first, *others = (
        replace(each, robots=tuple(replace(log, name=names.get(log.name, log.name)) for log in each.robots))
        for each in good.recordings
    )
    remarks = (
        f"'{theirs}' is taken for '{mine}' of the recordings to be judged, since each side has one robot."
        for theirs, mine in names.items()
    )
    return replace(good, recordings=(replace(first, remarks=(*first.remarks, *remarks)), *others))


def _streams(evidence: Evidence, name: str) -> set[str]:
    """Topics of a robot that have readings in any of the recordings."""
    logs = [log for recording in evidence.recordings for log in recording.robots if log.name == name]
    return {topic for log in logs for topic in clocks_of(log)}


def _with_streams(recording: RecordingLog, streams: dict[str, set[str]]) -> RecordingLog:
    """Leave out the robots and streams of which GOOD has nothing, and say so."""
    robots, remarks = [], list(recording.remarks)
    for log in recording.robots:
        if log.name not in streams:
            remarks.append(f"{recording.origin}: {log.name} is in no recording of --against; it is left out.")
            continue
        missing = sorted(topic for topic in log.streams if topic not in streams[log.name])
        if missing:
            remarks.append(
                f"{recording.origin}: {log.name} has no {_listed(missing)} in the recordings of --against; nothing is "
                "compared with these readings, and they are left out."
            )
        kept = {topic: stream for topic, stream in log.streams.items() if topic not in missing}
        robots.append(replace(log, streams=kept))
    return replace(recording, robots=tuple(robots), remarks=tuple(remarks))


def _listed(names: Sequence[str] | set[str]) -> str:
    return ", ".join(sorted(names)) or "none"
