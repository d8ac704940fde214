"""Times in which a vehicle lies at the surface while its pumps lift it: no model of a hull under water holds there.

A hull that leaves the water loses the buoyancy that its pumps make, and depth stays where the model would rise on. A
fit through such times takes the lost lift for a fault of the pump, the drag or the pressure.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import AFLOAT
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import AMBIENT, Z
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import AHEAD, pressure_per_metre
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import BuoyancyPump


def with_times_afloat(log: RobotLog, platform: Platform) -> tuple[RobotLog, tuple[str, ...]]:
    """Note in a log when the vehicle lies at the surface, and say so; the log as it is where it never does."""
    spans = _afloat(log, platform)
    if not spans:
        return log, ()
    longest = max(end - begin for begin, end in spans)
    said = (
        f"{log.name}: {len(spans)} times, {longest:.0f} s at the longest and first from {spans[0][0]:.1f} s on, it "
        "lies at the surface while its pumps lift it; a hull that leaves the water is not in the model, and these "
        "times are left out."
    )
    return replace(log, afloat=spans), (said,)


def _afloat(log: RobotLog, platform: Platform) -> tuple[tuple[float, float], ...]:
    """Begin and end [s] of each time afloat, ascending."""
    pumps = np.array([isinstance(actuator, BuoyancyPump) for actuator in platform.actuators])
    course = _depth(log, platform)
    if not pumps.any() or course is None or not len(log.command_time):
        return ()
    moments, depth = course
    full = platform.actuator_limits()[pumps, AHEAD].ravel()
    held = np.clip(np.searchsorted(log.command_time, moments, side="right") - 1, 0, None)
    lifted = log.command[held][:, pumps] @ full > AFLOAT.lift * full.sum()
    shallow = depth < float(np.quantile(depth, AFLOAT.top)) + max(platform.hull.length, platform.hull.height)
    return tuple(
        (float(moments[first]), float(moments[last]))
        for first, last in _runs(lifted & shallow)
        if moments[last] - moments[first] >= AFLOAT.shortest
    )


def _depth(log: RobotLog, platform: Platform) -> tuple[Floats, Floats] | None:
    """Moments (n,) [s] and depths (n,) [m] above a level of its own; None where no stream shows any."""
    for topic, column, metre in (
        ("pressure", AMBIENT, pressure_per_metre(platform, log)),
        ("pose", Z, -1.0),
    ):
        stream = log.streams.get(topic)
        if stream is not None and np.isfinite(stream.value[:, column]).any():
            given = np.isfinite(stream.value[:, column])
            return stream.time[given], stream.value[given, column] / metre
    return None


def _runs(chosen: Flags) -> list[tuple[int, int]]:
    """First and last index of each unbroken run of true values."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], chosen, [False]]).astype(int)))
    return [(int(first), int(end) - 1) for first, end in zip(edges[0::2], edges[1::2], strict=True)]
