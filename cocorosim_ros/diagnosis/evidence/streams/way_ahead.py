"""The velocity of a hull that pitches, whose log shows the speed ahead alone: its pressure sensor shows the rest.

A hull that goes ahead at u along its own axis, and at w along its upward one, climbs at -u sin(theta) + w cos(theta).
The climb, a difference of depths, is a mean over a time in which the pitch may change; so w is told from that mean and
the mean of u sin(theta) over the same time, and then holds with the pitch of the moment. No way sideways is assumed.
Source: Fossen (2021), section 2.2, with the axes of REP 103: pitch is positive where the nose points down.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from scipy.integrate import cumulative_trapezoid

from cocorosim_ros.diagnosis.criteria.evidence import TILT
from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude
from cocorosim_ros.diagnosis.evidence.streams.log import Stream
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import AMBIENT, OVER_GROUND, THROUGH_WATER, U, V, W
from cocorosim_ros.diagnosis.evidence.streams.velocities import Velocities
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE


def way_ahead(streams: Mapping[str, Stream], attitude: Attitude) -> Velocities | None:
    """Velocities along the hull's axes at the times of the attitude; None where no log shows the speed ahead alone.

    Nor where no pressure was recorded; depths are those of fresh water, in the sea it climbs by a fortieth less.
    """
    logs = [streams[topic] for topic in (THROUGH_WATER, OVER_GROUND) if topic in streams]
    found = next((stream for stream in logs if shows_only_ahead(stream)), None)
    depth = _depths(streams)
    if found is None or depth is None:
        return None
    known = np.isfinite(found.value[:, U])
    time = attitude.time
    ahead = np.interp(time, found.time[known], found.value[known, U])
    sinking = cumulative_trapezoid(ahead * np.sin(attitude.pitch), time, initial=0.0)
    half = 0.5 * max(TILT.climb_span, TILT.climb_readings * float(np.median(np.diff(depth.time))))
    risen = _gained(time, half, Trace(depth.time, -depth.value)) + _gained(time, half, Trace(time, sinking))
    upwards = risen / np.maximum(np.cos(attitude.pitch), TILT.least_cosine)
    return Velocities(time, np.column_stack([ahead, np.zeros(len(time)), upwards]))


def shows_only_ahead(stream: Stream) -> bool:
    """Tell whether a velocity has readings ahead, and none sideways or upwards."""
    known = np.isfinite(stream.value)
    return int(np.count_nonzero(known[:, U])) >= TILT.fewest and not known[:, V : W + 1].any()


class Trace(NamedTuple):
    """Times (n,) [s] and what was there (n,)."""

    time: Floats
    value: Floats


def _depths(streams: Mapping[str, Stream]) -> Trace | None:
    """Depths [m] by the pressure; None where too few were recorded."""
    stream = streams.get("pressure")
    if stream is None:
        return None
    pressure = stream.value[:, AMBIENT]
    known = np.isfinite(pressure)
    if np.count_nonzero(known) < TILT.fewest:
        return None
    return Trace(stream.time[known], pressure[known] / PASCAL_PER_METRE)


def _gained(moments: Floats, half: float, trace: Trace) -> Floats:
    """Mean rate (m,) of a trace over `half` [s] before and behind the moments (m,)."""
    time, value = trace
    early, late = (np.clip(moments + shift, time[0], time[-1]) for shift in (-half, half))
    apart = np.maximum(late - early, half)
    return np.asarray((np.interp(late, time, value) - np.interp(early, time, value)) / apart)
