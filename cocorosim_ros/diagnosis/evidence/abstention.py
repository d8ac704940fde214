"""Reasons to leave a robot or a recording out: the file can be read, but it holds too little information."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import EXCITATION, SUFFICIENCY
from cocorosim_ros.diagnosis.evidence.streams.excitation import command_use
from cocorosim_ros.diagnosis.evidence.streams.log import STREAMS, Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import coasting_time
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.sensors import SENSORS


def reasons_to_abstain(evidence: Evidence, beside: Sequence[RecordingLog] = ()) -> tuple[str, ...]:
    """Reasons, as sentences, for which the evidence allows no diagnosis; empty if at least one robot can be used.

    beside: further recordings of the same robots that the evidence is fitted together with.
    """
    reasons, usable, together = [], 0.0, (*evidence.recordings, *beside)
    for recording in evidence.recordings:
        for robot in recording.robots:
            reason = why_unusable(robot, recording, evidence.platform, together)
            if reason:
                reasons.append(reason)
            else:
                usable += common_time(robot)
    least = max(SUFFICIENCY.least_in_all, SUFFICIENCY.time_constants * coasting_time(evidence.platform))
    if usable >= least:
        return ()
    if usable > 0.0:
        reasons.append(
            f"{', '.join(recording.origin for recording in evidence.recordings)}: commands and readings at the same "
            f"time make {usable:.1f} s in all; {least:.0f} s are the least for a {evidence.platform.name}, and ten "
            "minutes are good."
        )
    return tuple(reasons)


def without_unusable(evidence: Evidence, beside: Sequence[RecordingLog] = ()) -> Evidence:
    """Leave out the robots that tell too little; the remarks of their recording say for which reason.

    beside: further recordings of the same robots that the evidence is fitted together with.
    """
    recordings, together = [], (*evidence.recordings, *beside)
    for recording in evidence.recordings:
        reasons = [why_unusable(robot, recording, evidence.platform, together) for robot in recording.robots]
        kept = tuple(robot for robot, reason in zip(recording.robots, reasons, strict=True) if not reason)
        remarks = (*recording.remarks, *(reason for reason in reasons if reason))
        recordings.append(replace(recording, robots=kept, remarks=remarks))
    return replace(evidence, recordings=tuple(recordings))


def why_unusable(robot: RobotLog, recording: RecordingLog, platform: Platform, given: Sequence[RecordingLog]) -> str:
    """The reason, as a sentence, for which a robot of a recording cannot be used; empty if it can.

    given: all recordings that are fitted together. Commands that are the same throughout a recording tell enough where
    another recording of the robot has others.
    """
    actuators = platform.actuator_names
    place = f"{recording.origin}: {robot.name}"
    if not len(robot.command_time):
        return f"{place} has no commands; record its thruster_command too, because motion is explained by them."
    streams = {topic: stream for topic, stream in robot.streams.items() if len(stream.time) >= SUFFICIENCY.fewest}
    lacking = _too_sparse(streams, platform) if streams else _too_few(robot, recording.duration)
    if lacking:
        return f"{place} {lacking}"
    common = common_time(robot)
    if common < SUFFICIENCY.shortest:
        return (
            f"{place} has commands and readings at the same time for {common:.1f} s of the recording's "
            f"{recording.duration:.1f} s; {SUFFICIENCY.shortest:.0f} s are the least of one recording, and ten minutes "
            "are good."
        )
    if not any(use.varied for use in command_use(robot, actuators)) and not _driven_otherwise(robot, given):
        commands = ", ".join(f"{name} {value:g}" for name, value in zip(actuators, robot.command[0], strict=True))
        alike = ", as in all other recordings of it," if len(_logs(robot.name, given)) > 1 else ","
        return (
            f"{place} has the same commands throughout ({commands}){alike} so that no cause can be told from another; "
            "vary every actuator, also backwards and through zero, or give recordings with other commands too."
        )
    if not any(_moves(topic, stream) for topic, stream in streams.items()):
        shown = ", ".join(sorted(streams))
        return f"{place} never moves: there is nothing but noise in {shown}; check that these are its readings."
    return ""


def _too_few(robot: RobotLog, duration: float) -> str:
    """The rest of a sentence about streams none of which has enough readings in so many seconds."""
    *others, last = STREAMS
    usable = f"{', '.join(others)} or {last}"
    found = ", ".join(f"{len(stream.time)} of {topic}" for topic, stream in robot.streams.items()) or "none"
    return (
        f"has too few readings in {duration:.1f} s ({found}) of {usable}; {SUFFICIENCY.fewest} of one of them are the "
        "least that shows how it moves."
    )


def _too_sparse(streams: Mapping[str, Stream], platform: Platform) -> str:
    """The rest of a sentence if all streams have readings too far apart to follow a vehicle of that platform."""
    apart = {topic: float(np.median(np.diff(stream.time))) for topic, stream in streams.items()}
    quickest = min(apart, key=lambda topic: apart[topic])
    coasting = coasting_time(platform)
    if apart[quickest] <= max(SUFFICIENCY.sparse * coasting, SUFFICIENCY.sparse_seconds):
        return ""
    return (
        f"has readings {apart[quickest]:.3g} s apart in the median ({quickest}), and a {platform.name} coasts for "
        f"{coasting:.1f} s, so that nothing shows how it moves between them; record more often, or correct the unit of "
        "'time' in the map by which it was converted."
    )


def _logs(name: str, recordings: Sequence[RecordingLog]) -> list[RobotLog]:
    """Logs with commands of the robot of this name."""
    return [log for recording in recordings for log in recording.robots if log.name == name and len(log.command_time)]


def _driven_otherwise(robot: RobotLog, recordings: Sequence[RecordingLog]) -> bool:
    """Tell whether any recording of a robot has commands that differ noticeably from its own first ones."""
    own = robot.command[0]
    return any(bool((np.abs(log.command - own) > EXCITATION.tiny).any()) for log in _logs(robot.name, recordings))


def common_time(robot: RobotLog) -> float:
    """The longest time [s] over which the robot has commands and readings of one stream at once."""
    streams = [stream for stream in robot.streams.values() if len(stream.time)]
    if not streams or not len(robot.command_time):
        return 0.0
    first = float(robot.command_time[0])
    return max(float(stream.time[-1]) - max(first, float(stream.time[0])) for stream in streams)


def _moves(topic: str, stream: Stream) -> bool:
    """Tell whether the means over a second of any column spread farther than noise alone makes them."""
    columns = zip(SENSORS[topic].kinds, stream.value.T, stream.noise, strict=True)
    return any(
        _spread(stream.time, column, noise, kind.least_motion)
        for kind, column, noise in columns
        if kind.least_motion is not None
    )


def _spread(time: Floats, column: Floats, noise: float, least: float) -> bool:
    given = np.isfinite(column)
    if np.count_nonzero(given) < SUFFICIENCY.fewest:
        return False
    bins = ((time[given] - time[0]) / SUFFICIENCY.over).astype(int)
    size = np.bincount(bins)
    mean = np.bincount(bins, column[given])[size > 0] / size[size > 0]
    expected = (noise if np.isfinite(noise) else 0.0) / np.sqrt(size[size > 0].mean())
    low, high = np.quantile(mean, SUFFICIENCY.range_quantiles)
    return bool(high - low > max(SUFFICIENCY.still * expected, least))
