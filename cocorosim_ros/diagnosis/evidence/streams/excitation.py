"""Use of each actuator by the commands: the first hint at what a recording can show."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.diagnosis.criteria.evidence import EXCITATION
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class CommandUse:
    """Shares of the time (0 to 1) in which an actuator is varied, runs backwards, is off, is near zero but not off.

    steps: sudden changes by a tenth of the maximum or more. lowest, highest: commands.
    """

    actuator: str
    varied: float
    reversed: float
    off: float
    near_zero: float
    steps: int
    lowest: float
    highest: float


def command_use(robot: RobotLog, actuators: tuple[str, ...]) -> tuple[CommandUse, ...]:
    """The use of each actuator by the commands of a robot, in their order; empty without commands."""
    if not len(robot.command_time):
        return ()
    ends = [float(stream.time[-1]) for stream in robot.streams.values() if len(stream.time)]
    last = max([float(robot.command_time[-1]), *ends])
    held = np.diff(np.append(robot.command_time, last))
    if not held.sum() > 0.0:
        held = np.ones(len(robot.command_time))
    share = held / held.sum()
    return tuple(
        _use(name, robot.command_time, column, share) for name, column in zip(actuators, robot.command.T, strict=True)
    )


def _use(name: str, time: Floats, column: Floats, share: Floats) -> CommandUse:
    moved = _changes(column)
    latest = np.searchsorted(time[moved], time, side="right") - 1
    since = np.where(latest >= 0, time - time[moved[np.maximum(latest, 0)]] if moved.size else np.inf, np.inf)
    size = np.abs(column)
    return CommandUse(
        name,
        varied=float(share[since <= EXCITATION.look_back].sum()),
        reversed=float(share[column < -EXCITATION.tiny].sum()),
        off=float(share[size <= EXCITATION.tiny].sum()),
        near_zero=float(share[(size > EXCITATION.tiny) & (size <= EXCITATION.near_zero)].sum()),
        steps=int(np.count_nonzero(np.abs(np.diff(column)) >= EXCITATION.step)),
        lowest=float(column.min()),
        highest=float(column.max()),
    )


def _changes(column: Floats) -> NDArray[np.intp]:
    """Rows at which the command differs noticeably from its last change, so that slow ramps count as changes."""
    rows, anchor = [], float(column[0])
    for row, value in enumerate(column.tolist()):
        if abs(value - anchor) > EXCITATION.tiny:
            rows.append(row)
            anchor = value
    return np.array(rows, dtype=np.intp)
