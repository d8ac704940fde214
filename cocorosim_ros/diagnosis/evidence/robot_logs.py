"""Logs made from clean rows: angles unwrapped, faulty readings left out, the noise of each channel estimated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.cleaning import gaps_of
from cocorosim_ros.diagnosis.evidence.clocks import Skew
from cocorosim_ros.diagnosis.evidence.levelling import levelled
from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude, attitude_of
from cocorosim_ros.diagnosis.evidence.streams.filled_in import filled_in
from cocorosim_ros.diagnosis.evidence.streams.log import STREAMS, RobotLog, Stream
from cocorosim_ros.diagnosis.evidence.streams.noise import hides_motion, noise_of
from cocorosim_ros.diagnosis.evidence.streams.outliers import away, outliers
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import FELT, PLANE
from cocorosim_ros.diagnosis.evidence.streams.turning import period_of, turned_by_gyro, unwrapped
from cocorosim_ros.diagnosis.evidence.topic_rows import COMMAND, TopicRows
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.counted import either
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.world.sensors import SENSORS

HEADINGS = {
    topic: column for topic, sensor in SENSORS.items() for column, kind in enumerate(sensor.kinds) if kind.angle
}
"""Column of the angle of each stream that has one."""


@dataclass(frozen=True)
class ClockedRows:
    """Clean rows of a topic, and the rate of the clock that stamped them."""

    rows: TopicRows
    skew: Skew


def robot_log(name: str, topics: Sequence[ClockedRows], start_ns: int, actuators: int) -> tuple[RobotLog, list[str]]:
    """Make the log of a robot from its topics, time counting from `start_ns`; give remarks on what was left out."""
    commands = next((each.rows for each in topics if each.rows.topic == COMMAND and len(each.rows.stamp_ns)), None)
    streams = {
        each.rows.topic: Stream(
            seconds(each.rows, start_ns),
            each.rows.values,
            np.empty(0),
            each.skew.rate,
            each.skew.error,
            shifted=each.rows.shifted,
        )
        for each in topics
        if each.rows.topic != COMMAND and len(each.rows.stamp_ns)
    }
    remarks: list[str] = []
    every = {topic: _finished(f"{name}/{topic}", topic, streams, remarks) for topic in streams}
    # An IMU that tells the attitude alone has no reading of its own.
    finished = {topic: stream for topic, stream in every.items() if len(stream.time)}
    log = RobotLog(
        name,
        seconds(commands, start_ns) if commands else np.empty(0),
        commands.values if commands else np.empty((0, actuators)),
        finished,
        gaps_of(finished["pose"].time) if "pose" in finished else (),
        _attitude([topic.rows for topic in topics], start_ns),
        command_shifted=commands.shifted if commands else 0.0,
        commanded=commands.commanded if commands else (),
    )
    level, said = levelled(log)
    return level, [*remarks, *said]


def _attitude(topics: Sequence[TopicRows], start_ns: int) -> Attitude | None:
    """Attitude of the topic that has most readings of it; None where none tells any."""
    found = [attitude_of(seconds(rows, start_ns), rows.attitude) for rows in topics]
    known = [attitude for attitude in found if attitude is not None]
    return max(known, key=lambda attitude: len(attitude.time)) if known else None


def seconds(rows: TopicRows, start_ns: int) -> Floats:
    """Stamps (n,) [s] since `start_ns`."""
    return np.asarray((rows.stamp_ns - start_ns) / NANOSECONDS)


def _finished(name: str, topic: str, streams: Mapping[str, Stream], remarks: list[str]) -> Stream:
    stream = streams[topic]
    value, period = stream.value.copy(), stream.full_turn
    if topic in HEADINGS:
        column = HEADINGS[topic]
        period = period_of(value[:, column])
        angle = unwrapped(stream.time, value[:, column], period)
        turned = turned_by_gyro(stream.time, angle, streams.get("imu"))
        value[:, column] = angle if turned is None else unwrapped(stream.time, angle, period, turned)
    if topic == "imu":
        _leave_out_coarse(name, value, remarks)
    turns = [period if HEADINGS.get(topic) == column else 0.0 for column in range(value.shape[1])]
    filled = _leave_out_filled_in(name, topic, stream.time, value, turns, remarks)
    noise = np.array([noise_of(stream.time, column, turn) for column, turn in zip(value.T, turns, strict=True)])
    _leave_out(name, topic, stream.time, value, noise, remarks)
    if topic in HEADINGS:
        _leave_out_leaps(name, stream.time, value[:, HEADINGS[topic]], float(noise[HEADINGS[topic]]), remarks)
    kept = np.isfinite(value).any(axis=1)
    return replace(stream, time=stream.time[kept], value=value[kept], noise=noise, full_turn=period, filled_in=filled)


def _leave_out_coarse(name: str, value: Floats, remarks: list[str]) -> None:
    """Write NaN over the accelerations (readings, columns) of an IMU in steps so coarse that they hide the motion.

    Accelerometers measure some g, of which a slow vehicle needs thousandths. Other readings in such steps stay, since
    they still keep a course where it is.
    """
    coarse = [number for number in range(FELT.start, FELT.stop) if hides_motion(value[:, number])]
    if coarse:
        columns = ", ".join(STREAMS["imu"][number] for number in coarse)
        remarks.append(
            f"{name}: {columns} hardly {either(len(coarse), 'leaves', 'leave')} one step of the instrument's digits, "
            f"which hide the motion; {either(len(coarse), 'it was', 'they were')} left out."
        )
        value[:, coarse] = np.nan


def _leave_out_filled_in(
    name: str, topic: str, time: Floats, value: Floats, turns: Sequence[float], remarks: list[str]
) -> tuple[str, ...]:
    """Write NaN over readings that nothing measured; return the columns that had them.

    turns: a full turn [unit of the column] of each column that is an angle, 0 of the others.
    """
    found = []
    for column, shown, turn in zip(STREAMS[topic], value.T, turns, strict=True):
        made_up = filled_in(time, shown, turn)
        if made_up.any():
            shown[made_up] = np.nan
            found.append(column)
            remarks.append(
                f"{name}: {np.count_nonzero(made_up)} of {len(made_up)} readings of {column} were interpolated between "
                "others, or repeat the last one; they were left out, and the noise is judged from the others alone."
            )
    return tuple(found)


def _leave_out_leaps(name: str, time: Floats, heading: Floats, noise: float, remarks: list[str]) -> None:
    """Write NaN over the readings between a leap of a heading and the leap back soon after it.

    heading (n,) [rad], not wrapped: what follows a leap that went on around is turned back by a full turn.
    """
    wrong = away(time, heading, noise)
    if wrong.any():
        heading[wrong] = np.nan
        left = np.isfinite(heading)
        heading[left] = np.unwrap(heading[left])
        remarks.append(
            f"{name}: the heading leaps away and back within half a second, first at {time[wrong][0]:.1f} s; the "
            f"{np.count_nonzero(wrong)} readings in between were left out."
        )


def _leave_out(name: str, topic: str, time: Floats, value: Floats, noise: Floats, remarks: list[str]) -> None:
    """Write NaN over faulty readings; leaps of a pose in the plane are found by speed, not reading by reading."""
    for column in range(PLANE.stop if topic == "pose" else 0, value.shape[1]):
        wrong = outliers(value[:, column], float(noise[column]))
        if wrong.any():
            value[wrong, column] = np.nan
            remarks.append(
                f"{name}: {np.count_nonzero(wrong)} single readings of {STREAMS[topic][column]} are far off those "
                f"before and after them, first at {time[wrong][0]:.1f} s; they were left out."
            )
