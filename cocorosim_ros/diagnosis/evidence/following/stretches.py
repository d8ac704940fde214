"""Stretches of a log in which an actuator's commands and what it reports are both known."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy.ndimage import median_filter

from cocorosim_ros.diagnosis.criteria.following import FOLLOWING
from cocorosim_ros.diagnosis.evidence.holes import holes_of
from cocorosim_ros.diagnosis.evidence.streams.feedback import Feedback
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.noise import noise_of
from cocorosim_ros.diagnosis.evidence.streams.outliers import outliers
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.steering import Azimuth, Rudder
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator
from cocorosim_ros.wire.topics.actuator_feedback import FRACTION

ANGLE = "angle"


@dataclass(frozen=True)
class Stretch:
    """One stretch: command (m,) that holds from command_time (m,) [s] on, reported (n,) at time (n,) [s], ascending.

    settled (n,): reports that hang no more on what was commanded before the stretch.
    """

    command_time: Floats
    command: Floats
    time: Floats
    reported: Floats
    settled: Flags


def command_scale(actuator: Actuator, quantity: str) -> float | None:
    """The command's maximum in the unit of the report: 1, or the largest angle [rad]; None if it has another unit."""
    if quantity == ANGLE and isinstance(actuator, Rudder | Azimuth | Fin):
        return actuator.largest_angle
    return 1.0 if quantity == FRACTION else None


def full_turn(actuator: Actuator, quantity: str) -> float | None:
    """A full turn in the unit of a report, rad or a share of the largest angle; None for a report of no angle."""
    if quantity == FRACTION and isinstance(actuator, Rudder | Azimuth | Fin):
        return 2.0 * math.pi / actuator.largest_angle
    return 2.0 * math.pi if quantity == ANGLE else None


def stretches_of(log: RobotLog, column: int, actuator: Actuator, feedback: Feedback) -> Iterator[Stretch]:
    """The stretches between the holes of a log, commands in the unit of the report where that is an angle.

    column: of the actuator among the log's commands.
    """
    if not len(log.command_time):
        return
    holes = [(begin, end) for begin, end in holes_of(log) if (begin, end) not in log.afloat]
    begins = [-np.inf, *(end for _, end in holes)]
    ends = [*(begin for begin, _ in holes), np.inf]
    scale = command_scale(actuator, feedback.quantity) or 1.0
    for begin, end in zip(begins, ends, strict=True):
        asked = (log.command_time >= begin) & (log.command_time <= end)
        if not asked.any():
            continue
        moments, command = _changes(log.command_time[asked], scale * log.command[asked, column])
        told = (feedback.time >= moments[0]) & (feedback.time <= end)
        stretch = _stretch(moments, command, feedback.time[told], feedback.value[told])
        if len(stretch.time):
            yield _unwrapped(stretch, full_turn(actuator, feedback.quantity))


def _changes(time: Floats, command: Floats) -> tuple[Floats, Floats]:
    """The commands (m,) that differ from those before them, with their times: only these move anything."""
    first = np.append(True, np.diff(command) != 0.0)
    return time[first], command[first]


def _stretch(command_time: Floats, command: Floats, time: Floats, reported: Floats) -> Stretch:
    """Leave faulty reports out, and mark those that have settled."""
    good = np.ones(len(time), bool)
    if len(time):
        held = command[np.clip(np.searchsorted(command_time, time, side="right") - 1, 0, None)]
        good = ~(outliers(reported, noise_of(time, reported)) | _far_beyond(reported, held))
    time, reported = time[good], reported[good]
    if not len(time):
        return Stretch(command_time, command, time, reported, good[good])
    wait = min(FOLLOWING.settling, FOLLOWING.most_settling * float(time[-1] - command_time[0]))
    return Stretch(command_time, command, time, reported, time >= command_time[0] + wait)


def _far_beyond(reported: Floats, command: Floats) -> Flags:
    """Mask (n,) of reports far beyond where nearly all are, as an instrument shows that has lost its line for a second.

    Where commands leave their own usual range far behind for a moment, reports may as well.
    """
    (low, high), (least, most) = (np.quantile(each, FOLLOWING.usual) for each in (reported, command))
    if most - least < FOLLOWING.usual_span * np.ptp(command):
        return np.zeros(len(reported), bool)
    wide = FOLLOWING.beyond * (high - low)
    return np.asarray((reported < low - wide) | (reported > high + wide))


def _unwrapped(stretch: Stretch, turn: float | None) -> Stretch:
    """Take whole turns out of an angle: commands go the shorter way, and the report is that of them which is nearest.

    Where an actuator goes the longer way, it is a turn away from there on, which a median over some seconds shows.
    """
    if turn is None:
        return stretch
    command = np.unwrap(stretch.command, period=turn)
    reported = np.unwrap(stretch.reported, period=turn)
    held = np.clip(np.searchsorted(stretch.command_time, stretch.time, side="right") - 1, 0, None)
    away = np.round((reported - command[held]) / turn)
    usual = float(np.median(np.diff(stretch.time))) if len(stretch.time) > 1 else FOLLOWING.turned_over
    width = 2 * int(0.5 * FOLLOWING.turned_over / max(usual, FOLLOWING.turned_over / len(away))) + 1
    turns = median_filter(away, size=width, mode="nearest")
    return replace(stretch, command=command, reported=reported - turn * turns)
