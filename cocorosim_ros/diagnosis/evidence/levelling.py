"""Streams in level axes: velocities and inertial readings of a robot that rolls and pitches, turned by its attitude."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import TILT
from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import (
    FELT,
    OVER_GROUND,
    THROUGH_WATER,
    TURN_RATE,
    VELOCITIES,
    U,
    V,
    W,
    Z,
)
from cocorosim_ros.diagnosis.evidence.streams.velocities import Velocities
from cocorosim_ros.diagnosis.evidence.streams.way_ahead import shows_only_ahead, way_ahead
from cocorosim_ros.diagnosis.evidence.streams.whole_velocity import whole_velocity
from cocorosim_ros.foundation.arrays import Floats

BODY_VECTORS = {**dict.fromkeys(VELOCITIES, slice(U, W + 1)), "imu": FELT}
"""Columns of the vectors along body axes, by stream."""


def levelled(log: RobotLog) -> tuple[RobotLog, tuple[str, ...]]:
    """Turn the streams of a log that stand in body axes into level ones, and say so; as it is without an attitude.

    An attitude that poses and velocities contradict is not used, and that is said.
    """
    if log.attitude is None:
        return log, ()
    contradiction = _upside_down(log, log.attitude) or _contradiction(log, log.attitude)
    if contradiction:
        return replace(log, attitude=None), (contradiction,)
    way = way_ahead(log.streams, log.attitude)
    streams = {topic: _levelled_stream(topic, stream, log.attitude, way) for topic, stream in log.streams.items()}
    if way is not None:
        way = Velocities(way.time, _turned(way.value, log.attitude, way.time))
    steepest = np.degrees(np.quantile(np.abs(np.column_stack([log.attitude.roll, log.attitude.pitch])), 0.95, axis=0))
    said = (
        f"{log.name}: roll and pitch are taken as known (95 % within {steepest[0]:.1f} and {steepest[1]:.1f} deg); "
        "velocities, inertial readings and thrust are turned into level axes."
    )
    return replace(log, streams=streams, way=way), (said, *_of_hull(log, way, float(steepest.max())))


def _of_hull(log: RobotLog, way: Velocities | None, steepest: float) -> tuple[str, ...]:
    """Remark where the hull rolls and pitches, and no velocity tells how the water meets it.

    way: velocity of which a part was recorded. steepest: angle that 95 % of the rolls and pitches are within [deg].
    """
    if steepest < TILT.said or way is not None or whole_velocity(log.streams) is not None:
        return ()
    return (
        f"{log.name}: no velocity was recorded along all three axes, nor one ahead with a pressure beside it, so that "
        "drag, lift and added mass of the hull are those of one that stays level. With a tilt of "
        f"{steepest:.0f} deg their numbers may be far off, or at the end of their range, and a law may stand for the "
        "tilt.",
    )


def _levelled_stream(topic: str, stream: Stream, attitude: Attitude, way: Velocities | None) -> Stream:
    if topic not in BODY_VECTORS:
        return stream
    value, vector = stream.value.copy(), BODY_VECTORS[topic]
    if topic in VELOCITIES and way is not None and shows_only_ahead(stream):
        upwards = np.interp(stream.time, way.time, way.value[:, W])
        whole = np.column_stack([value[:, U], np.zeros(len(value)), upwards])
        value[:, U] = _turned(whole, attitude, stream.time)[:, U]
    else:
        value[:, vector] = _turned(value[:, vector], attitude, stream.time)
    if topic == "imu":
        value[:, TURN_RATE] = _heading_rate(value[:, TURN_RATE], attitude, stream.time)
    return replace(stream, value=value)


def _turned(vector: Floats, attitude: Attitude, time: Floats) -> Floats:
    """Turn vectors (n, 3) into level axes; what is not measured along an axis counts as 0, and stays unknown."""
    turned = np.einsum("nij,nj->ni", attitude.turns(time), np.nan_to_num(vector))
    return np.where(np.isfinite(vector), turned, np.nan)


def _heading_rate(rate: Floats, attitude: Attitude, time: Floats) -> Floats:
    """Rate of the heading (n,) [rad/s] from that about the body's upward axis."""
    roll, pitch = attitude.roll_at(time), attitude.pitch_at(time)
    upright = np.maximum(np.cos(roll) * np.cos(pitch), TILT.least_cosine)
    return np.asarray((rate + attitude.pitch_rate_at(time) * np.sin(roll)) / upright)


def _upside_down(log: RobotLog, attitude: Attitude) -> str:
    """Sentence where the robot lies on its back most of the time; "" where it does not."""
    if float(np.median(np.cos(attitude.roll) * np.cos(attitude.pitch))) > 0.0:
        return ""
    return (
        f"{log.name}: by its roll and pitch the robot is upside down most of the time, so its attitude stands in "
        "other axes (forward-right-down, or a world with z down); roll and pitch are not used. Say `axes: ned_frd` in "
        "the map."
    )


def _contradiction(log: RobotLog, attitude: Attitude) -> str:
    """Sentence where heights agree clearly better with a mirrored roll or pitch; "" where they do not."""
    climbs = _climbs(log.streams, attitude)
    if climbs is None:
        return ""
    measured, parts = climbs
    left = {
        signs: float(np.mean((measured - parts @ [*signs, 1.0]) ** 2))
        for signs in ((1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0))
    }
    best = min(left, key=lambda signs: left[signs])
    if best == (1.0, 1.0) or left[(1.0, 1.0)] < TILT.contradicted * left[best]:
        return ""
    mirrored = " and ".join(name for name, sign in zip(("pitch", "roll"), best, strict=True) if sign < 0.0)
    return (
        f"{log.name}: heights and velocities fit together {left[(1.0, 1.0)] / left[best]:.1f} times better with "
        f"{mirrored} of the opposite sign; roll and pitch are not used. Check the axes of the attitude "
        "(forward-left-up in a world with z up, nose down positive)."
    )


def _climbs(streams: Mapping[str, Stream], attitude: Attitude) -> tuple[Floats, Floats] | None:
    """Climb [m/s] between heights (n,), and (n, 3) its parts: of surge by pitch, of sway by roll, of heave.

    None where either stream is missing, or where there are too few readings of it. The velocity is that over ground
    where there is one.
    """
    pose, velocity = streams.get("pose"), streams.get(OVER_GROUND, streams.get(THROUGH_WATER))
    if pose is None or velocity is None:
        return None
    seen = np.isfinite(pose.value[:, Z])
    known = np.isfinite(velocity.value[:, U : W + 1]).all(axis=1)
    if min(np.count_nonzero(seen), np.count_nonzero(known)) < TILT.fewest:
        return None
    edges = np.arange(pose.time[seen][0], pose.time[seen][-1], TILT.climb_span)
    if len(edges) < TILT.fewest:
        return None
    height = np.interp(edges, pose.time[seen], pose.value[seen, Z])
    middle = 0.5 * (edges[1:] + edges[:-1])
    u, v, w = (np.interp(middle, velocity.time[known], velocity.value[known, place]) for place in (U, V, W))
    roll, pitch = attitude.roll_at(middle), attitude.pitch_at(middle)
    parts = [-u * np.sin(pitch), v * np.cos(pitch) * np.sin(roll), w * np.cos(pitch) * np.cos(roll)]
    return np.diff(height) / TILT.climb_span, np.column_stack(parts)
