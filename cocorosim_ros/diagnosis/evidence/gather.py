"""Evidence made from recordings: streams and commands of every robot, clean, on one clock, with their noise."""

from __future__ import annotations

import itertools
import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from cocorosim_ros.diagnosis.evidence.afloat import with_times_afloat
from cocorosim_ros.diagnosis.evidence.bursts import as_taken
from cocorosim_ros.diagnosis.evidence.cleaning import cleaned, timing_sentence
from cocorosim_ros.diagnosis.evidence.clocks import clock_skews, on_one_clock, skew_sentence
from cocorosim_ros.diagnosis.evidence.following.reported_angles import with_reported_angles
from cocorosim_ros.diagnosis.evidence.holes import hole_sentences
from cocorosim_ros.diagnosis.evidence.identities import with_true_identities
from cocorosim_ros.diagnosis.evidence.reported import Commanded, with_reports
from cocorosim_ros.diagnosis.evidence.robot_logs import ClockedRows, robot_log, seconds
from cocorosim_ros.diagnosis.evidence.streams.log import STREAMS, Evidence, RecordingLog, RobotLog, Stream, told_apart
from cocorosim_ros.diagnosis.evidence.topic_rows import COMMAND, read_topic_rows
from cocorosim_ros.diagnosis.findings import Clock
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag
from cocorosim_ros.wire.bags.bag_summary import METADATA_NAME
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.conversion.conversion import MEASURED_COMMANDS, PRESSURE_FROM_DEPTH
from cocorosim_ros.world.sensors.pressure import PRESSURE


def gather_evidence(bags: Sequence[Path], platform: Platform) -> Evidence:
    """Read the evidence of robots of one platform from recordings.

    Raises CocorosimError for a file that cannot be used: it is no recording, holds no topic of any robot, commands
    actuators that the platform does not have, or holds the same readings as another one. A usable file with too little
    information raises nothing: see `reasons_to_abstain`. Of several recordings, every remark names its own.
    """
    recordings = [gather_recording(Path(bag), platform) for bag in bags]
    for one, other in itertools.combinations(recordings, 2):
        if _is_same(one, other):
            raise CocorosimError(
                f"{other.origin} says the same as {one.origin}, reading by reading; give every recording once, for "
                "what is given twice would count twice as evidence."
            )
    return with_reported_angles(Evidence(platform, told_apart(recordings)))


def _is_same(one: RecordingLog, other: RecordingLog) -> bool:
    """Tell whether two recordings hold the same robots with the same commands and readings."""
    return [robot.name for robot in one.robots] == [robot.name for robot in other.robots] and all(
        np.array_equal(mine.command, theirs.command)
        and mine.streams.keys() == theirs.streams.keys()
        and all(_is_same_stream(mine.streams[topic], theirs.streams[topic]) for topic in mine.streams)
        for mine, theirs in zip(one.robots, other.robots, strict=True)
    )


def _is_same_stream(one: Stream, other: Stream) -> bool:
    return np.array_equal(one.time, other.time) and np.array_equal(one.value, other.value, equal_nan=True)


def gather_recording(path: Path, platform: Platform) -> RecordingLog:
    """Read one recording of robots of a platform. Raises CocorosimError as `gather_evidence` does."""
    bag = read_bag(path)
    try:
        topics, remarks = read_topic_rows(bag, platform)
    except CocorosimError as error:
        raise CocorosimError(f"{path}: {error}") from error
    commands = {rows.robot: rows for rows in topics if rows.topic == COMMAND and len(rows.stamp_ns)}
    topics, clock_remarks = on_one_clock(topics)
    remarks = [*([bag.summary.damage] if bag.summary.damage else []), *remarks, *clock_remarks]
    skews = clock_skews(topics)
    sentences = [skew_sentence(rows.name, skew) for rows, skew in zip(topics, skews, strict=True)]
    remarks += [sentence for sentence in sentences if sentence]
    clean = []
    for rows in topics:
        result = cleaned(rows)
        taken, said = as_taken(result.rows)
        clean.append(taken)
        remarks += [*rows.remarks, *result.remarks, *said]
    if not any(len(rows.stamp_ns) for rows in clean):
        raise _nothing_usable(path, bag)
    start = min(int(rows.stamp_ns[0]) for rows in clean if len(rows.stamp_ns))
    duration = max((int(rows.stamp_ns[-1]) - start) / NANOSECONDS for rows in clean if len(rows.stamp_ns))
    robots = []
    for name in sorted({rows.robot for rows in clean}):
        mine = [ClockedRows(rows, skew) for rows, skew in zip(clean, skews, strict=True) if rows.robot == name]
        log, log_remarks = robot_log(name, mine, start, len(platform.actuators))
        log, said_afloat = with_times_afloat(_as_converted(log, bag), platform)
        robots.append(replace(log, clock=Clock(str(path), start)))
        remarks += [*log_remarks, *hole_sentences(log), *said_afloat, *_on_measured(log)]
    robots, identity_remarks = with_true_identities(robots, platform)
    remarks += identity_remarks
    try:
        robots, report_remarks = with_reports(robots, bag, Commanded(commands, platform.actuator_names, start))
    except CocorosimError as error:
        raise CocorosimError(f"{path}: {error}") from error
    remarks += report_remarks
    remarks += [timing_sentence(rows.name, seconds(rows, start)) for rows in clean]
    made_from = bag.summary.metadata.get(METADATA_NAME, {}).get("scenario", "")
    return RecordingLog(str(path), duration, tuple(robots), tuple(remarks), made_from)


def _as_converted(log: RobotLog, bag: Bag) -> RobotLog:
    """Note in a log, by what the recording says of its conversion, whether its commands were measured.

    And whether its pressures were made of depths.
    """
    said = bag.summary.metadata.get(METADATA_NAME, {})
    log = replace(log, measured=log.name in json.loads(said.get(MEASURED_COMMANDS, "[]")))
    stream = log.streams.get(PRESSURE.topic)
    if stream is None or log.name not in json.loads(said.get(PRESSURE_FROM_DEPTH, "[]")):
        return log
    return replace(log, streams={**log.streams, PRESSURE.topic: replace(stream, from_depth=True)})


def _on_measured(log: RobotLog) -> tuple[str, ...]:
    """Say, where it is so, that commands were measured, and what this leaves out."""
    said = (
        f"{log.name}: its commands are what its actuators were measured to do; that they act late was not looked for."
    )
    return (said,) if log.measured else ()


def _nothing_usable(path: Path, bag: Bag) -> CocorosimError:
    if bag.summary.damage:
        return CocorosimError(
            f"{path} holds no reading and no command of any robot, because {bag.summary.damage.rstrip('.')}; record "
            "again or give another recording."
        )
    found = ", ".join(topic.topic for topic in bag.summary.topics if topic.count) or "none"
    return CocorosimError(
        f"{path} has no message of a robot's {', '.join([*STREAMS, COMMAND])}, and its topics are: {found}; "
        "bring it into the contract with `cocorosim convert`, or give another recording."
    )
