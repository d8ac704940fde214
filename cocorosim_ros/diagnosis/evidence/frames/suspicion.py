"""A suspicion that a stream's axes, signs or units are not those of the contract, and how to put them right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.foundation.arrays import Floats

COMMAND = "thruster_command"


@dataclass(frozen=True)
class FrameSuspicion:
    """One stream whose readings fit all others only after a correction.

    correction: what is wrong, in words. because: what shows it, a sentence. nats: by how much the corrected readings
    fit the other streams better, a cautious figure; infinite where the readings themselves leave no doubt.
    matrix (columns, columns) and offset (columns,): right = matrix @ value + offset; where `into_body`, the first two
    columns are turned from world into body axes before that. Of the commands the columns are the actuators; matrix is
    None where no exchange of actuators would do.
    """

    topic: str
    correction: str
    because: str
    nats: float
    matrix: Floats | None
    offset: Floats
    into_body: bool = False


def corrected(log: RobotLog, suspicions: Sequence[FrameSuspicion]) -> RobotLog:
    """The log with these suspicions put right, in their order."""
    for suspicion in suspicions:
        matrix = suspicion.matrix
        if matrix is None:
            continue
        if suspicion.topic == COMMAND:
            log = replace(log, command=log.command @ matrix.T + suspicion.offset)
        elif suspicion.topic in log.streams:
            stream = _corrected_stream(log, suspicion, matrix)
            log = replace(log, streams={**log.streams, suspicion.topic: stream})
    return log


def _corrected_stream(log: RobotLog, suspicion: FrameSuspicion, matrix: Floats) -> Stream:
    stream = log.streams[suspicion.topic]
    value = stream.value.copy()
    if suspicion.into_body and "pose" in log.streams:
        value[:, :2] = _in_body(stream.time, value[:, :2], log.streams["pose"])
    # A column that is not given must not spoil those that it is not mixed with.
    given = np.isfinite(value)
    mixed = np.where(given, value, 0.0) @ matrix.T + suspicion.offset
    lost = (~given).astype(float) @ (matrix.T != 0.0) > 0.0
    noise = np.where(np.isfinite(stream.noise), stream.noise, 0.0)
    spread = np.sqrt(noise**2 @ (matrix.T**2))
    unknown = np.isnan(stream.noise).astype(float) @ (matrix.T != 0.0) > 0.0
    return replace(stream, value=np.where(lost, np.nan, mixed), noise=np.where(unknown, np.nan, spread))


def _in_body(time: Floats, horizontal: Floats, pose: Stream) -> Floats:
    given = np.isfinite(pose.value[:, 3])
    yaw = np.interp(time, pose.time[given], pose.value[given, 3])
    cosine, sine = np.cos(yaw), np.sin(yaw)
    x, y = horizontal.T
    return np.column_stack([cosine * x + sine * y, cosine * y - sine * x])


def affine(
    topic: str, words: tuple[str, str], nats: float, matrix: Floats, offset: Floats | None = None
) -> FrameSuspicion:
    """A suspicion with this correction; words are `correction` and `because`."""
    return FrameSuspicion(topic, *words, nats, matrix, np.zeros(len(matrix)) if offset is None else offset)


def scaled(topic: str, words: tuple[str, str], nats: float, factors: Sequence[float]) -> FrameSuspicion:
    """A suspicion whose correction multiplies each column by a factor."""
    return affine(topic, words, nats, np.diag(np.asarray(factors, dtype=np.float64)))
