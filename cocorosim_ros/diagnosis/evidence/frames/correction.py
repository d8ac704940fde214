"""A correction of a stream whose axes, signs or units are not those of the contract."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE, YAW
from cocorosim_ros.foundation.arrays import Floats

COMMAND = "thruster_command"
CERTAIN = float("inf")
"""Nats of a correction of which the readings themselves leave no doubt."""


@dataclass(frozen=True)
class Fault:
    """The fault of the readings of a stream, and the evidence for it, both in words."""

    wrong: str
    because: str


@dataclass(frozen=True)
class FrameCorrection:
    """The correction without which a stream contradicts all others.

    wrong: the fault of the readings, in words. because: the evidence for it, in words. nats: lead of the corrected
    readings over the recorded ones, a cautious figure; infinite where the readings themselves leave no doubt.
    matrix (columns, columns) and offset (columns,): right = matrix @ value + offset; where `into_body`, the first two
    columns are turned from world into body axes before that. The columns of commands are the actuators. matrix is None
    for a stream that no matrix corrects. rival: topic of another stream that may be the faulty one as well; "" if none.
    """

    topic: str
    wrong: str
    because: str
    nats: float
    matrix: Floats | None
    offset: Floats
    into_body: bool = False
    rival: str = ""


def corrected(log: RobotLog, corrections: Sequence[FrameCorrection]) -> RobotLog:
    """Apply corrections to a log, in their order."""
    for correction in corrections:
        matrix = correction.matrix
        if matrix is None:
            continue
        if correction.topic == COMMAND:
            log = _with_commands(log, matrix, correction.offset)
        elif correction.topic in log.streams:
            stream = _corrected_stream(log, correction, matrix)
            log = replace(log, streams={**log.streams, correction.topic: stream})
    return log


def put_right(log: RobotLog, corrections: Sequence[FrameCorrection]) -> RobotLog:
    """Apply corrections to a log, in their order; streams that no matrix corrects are left out."""
    hopeless = {correction.topic for correction in corrections if correction.matrix is None}
    right = corrected(log, corrections)
    return replace(right, streams={name: stream for name, stream in right.streams.items() if name not in hopeless})


def _with_commands(log: RobotLog, matrix: Floats, offset: Floats) -> RobotLog:
    """Correct commands (m, actuators), and what acts in their place."""
    acting = log.acting and replace(log.acting, command=log.acting.command @ matrix.T + offset)
    return replace(log, command=log.command @ matrix.T + offset, acting=acting)


def _corrected_stream(log: RobotLog, correction: FrameCorrection, matrix: Floats) -> Stream:
    stream = log.streams[correction.topic]
    value = stream.value.copy()
    if correction.into_body and "pose" in log.streams:
        value[:, PLANE] = _in_body(stream.time, value[:, PLANE], log.streams["pose"])
    # A missing column must not spoil columns into which the matrix does not mix it.
    given = np.isfinite(value)
    mixed = np.where(given, value, 0.0) @ matrix.T + correction.offset
    lost = (~given).astype(float) @ (matrix.T != 0.0) > 0.0
    noise = np.where(np.isfinite(stream.noise), stream.noise, 0.0)
    spread = np.sqrt(noise**2 @ (matrix.T**2))
    unknown = np.isnan(stream.noise).astype(float) @ (matrix.T != 0.0) > 0.0
    return replace(stream, value=np.where(lost, np.nan, mixed), noise=np.where(unknown, np.nan, spread))


def _in_body(time: Floats, horizontal: Floats, pose: Stream) -> Floats:
    given = np.isfinite(pose.value[:, YAW])
    yaw = np.interp(time, pose.time[given], pose.value[given, YAW])
    cosine, sine = np.cos(yaw), np.sin(yaw)
    x, y = horizontal.T
    return np.column_stack([cosine * x + sine * y, cosine * y - sine * x])


def affine(
    topic: str, fault: Fault, nats: float, matrix: Floats, offset: Floats | None = None
) -> FrameCorrection:  # fmt: skip
    """A correction by matrix (columns, columns) and offset (columns,); None: an offset of zero."""
    summand = np.zeros(len(matrix)) if offset is None else offset
    return FrameCorrection(topic, fault.wrong, fault.because, nats, matrix, summand)


def scaled(topic: str, fault: Fault, nats: float, factors: Sequence[float]) -> FrameCorrection:
    """A correction that multiplies each column by a factor."""
    return affine(topic, fault, nats, np.diag(np.asarray(factors, dtype=np.float64)))
