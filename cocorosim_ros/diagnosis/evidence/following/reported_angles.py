"""Angles that rudders, fins and pods report, in place of those ordered: they push by where they stand.

A platform's file tells no servo: a model that is given the orders turns its rudder at once. One that turns at 8 deg/s
then shows as late commands, as a bias of the gyroscope, as a law without a name. Where the angle itself was recorded, a
model needs no servo. A motor's rotation takes no command's place: what it pushes with is what the model is asked for.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.following import FOLLOWING
from cocorosim_ros.diagnosis.evidence.following.reports import actuator_reports
from cocorosim_ros.diagnosis.evidence.following.stretches import ANGLE, command_scale, stretches_of
from cocorosim_ros.diagnosis.evidence.streams.feedback import Feedback
from cocorosim_ros.diagnosis.evidence.streams.log import Acting, Evidence, RobotLog
from cocorosim_ros.diagnosis.findings import ActuatorReport
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator


class _Servo(NamedTuple):
    """Actuator of a robot that turns by an angle, by the names of both."""

    robot: str
    actuator: str


def with_reported_angles(evidence: Evidence) -> Evidence:
    """Let reported angles act in all logs of a robot whose reports follow the orders, and are as large."""
    reports = actuator_reports(evidence, (ANGLE,))
    trusted = {_Servo(each.robot, each.actuator) for each in reports if _is_trusted(each)}
    if not trusted:
        return evidence
    recordings = tuple(
        replace(recording, robots=tuple(_turned(log, evidence.platform, trusted) for log in recording.robots))
        for recording in evidence.recordings
    )
    return replace(evidence, recordings=recordings)


def _is_trusted(report: ActuatorReport) -> bool:
    """Tell whether an angle is that of its actuator: in another unit or direction it would be of another size."""
    low, high = FOLLOWING.as_large
    return bool(report.numbers) and low <= report.numbers["gain"].value <= high


def _turned(log: RobotLog, platform: Platform, trusted: set[_Servo]) -> RobotLog:
    """Give a log what acts, where any of its actuators is trusted and reports there."""
    given = {each.actuator: each for each in log.feedback if each.quantity == ANGLE}
    pieces = {
        column: list(_pieces(log, column, platform.actuators[column], given[name]))
        for column, name in enumerate(platform.actuator_names)
        if _Servo(log.name, name) in trusted and name in given
    }
    reported = tuple(platform.actuator_names[column] for column, found in pieces.items() if found)
    if not reported:
        return log
    edges = [piece.edges for found in pieces.values() for piece in found]
    time = np.unique(np.concatenate([log.command_time, *edges]))
    command = log.command[np.searchsorted(log.command_time, time, side="right") - 1]
    for column, found in pieces.items():
        for piece in found:
            piece.put(command[:, column], time)
    return replace(log, acting=Acting(time, command, reported))


class _Piece(NamedTuple):
    """Angles (n,) without a long pause, as shares of the largest one, and between which moments (n + 1,) each holds."""

    edges: Floats
    share: Floats

    def put(self, command: Floats, time: Floats) -> None:
        """Write the angles into commands (m,) that hold from `time` (m,) on."""
        place = np.searchsorted(self.edges, time, side="right") - 1
        inside = (place >= 0) & (place < len(self.share))
        command[inside] = self.share[place[inside]]


def _pieces(log: RobotLog, column: int, actuator: Actuator, feedback: Feedback) -> Iterator[_Piece]:
    """Pieces of what an actuator reports; a reading holds from half way since the last one to half way to the next."""
    scale = command_scale(actuator, ANGLE) or 1.0
    for stretch in stretches_of(log, column, actuator, feedback):
        pauses = np.flatnonzero(np.diff(stretch.time) > FOLLOWING.pause) + 1
        for time, angle in zip(np.split(stretch.time, pauses), np.split(stretch.reported, pauses), strict=True):
            if len(time) > 1:
                edges = np.concatenate([time[:1], 0.5 * (time[1:] + time[:-1]), time[-1:]])
                yield _Piece(edges, (np.remainder(angle + math.pi, 2.0 * math.pi) - math.pi) / scale)
