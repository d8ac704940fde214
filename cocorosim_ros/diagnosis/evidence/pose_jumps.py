"""Leaps of a track farther than a robot can swim: it was lost, taken for another robot, or moved by hand."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import JUMPS
from cocorosim_ros.diagnosis.evidence.streams.log import Stream
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE, POSITION
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import full_speed
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.scenario.parts.platform import Platform


@dataclass(frozen=True)
class Jump:
    """A leap between two neighbouring poses: moments [s] and places (3,) [m; world] before and after."""

    before: float
    after: float
    left: Floats
    reached: Floats

    @property
    def distance(self) -> float:
        """Horizontal distance [m] of the leap."""
        return float(np.hypot(*(self.reached - self.left)[PLANE]))


def find_jumps(pose: Stream, platform: Platform, hulls: float = 1.0) -> tuple[Jump, ...]:
    """All leaps of the track that are longer than noise, `hulls` lengths of the hull and the top speed allow.

    Stamps may lie closer together than the poses were taken, so that no step counts as shorter than two usual ones.
    """
    if len(pose.time) < JUMPS.fewest:
        return ()
    place = pose.value[:, POSITION]
    steps = np.diff(pose.time)
    steps = np.maximum(steps, JUMPS.burst * np.median(steps))
    leap = np.hypot(*np.diff(place[:, PLANE], axis=0).T)
    far = leap > reach(pose, platform, hulls) + _top_speed(pose, platform) * steps
    return tuple(
        Jump(float(pose.time[k]), float(pose.time[k + 1]), place[k], place[k + 1]) for k in np.flatnonzero(far)
    )


def reach(pose: Stream, platform: Platform, hulls: float = 1.0) -> float:
    """Distance [m] that two poses of one moment may lie apart: noise, and `hulls` lengths of the hull."""
    noise = pose.noise[PLANE][np.isfinite(pose.noise[PLANE])]
    return JUMPS.noises * float(noise.max(initial=0.0)) + hulls * platform.hull.length


def _top_speed(pose: Stream, platform: Platform) -> float:
    lag = max(round(JUMPS.over / float(np.median(np.diff(pose.time)))), 1)
    own = 0.0
    if len(pose.time) > lag:
        way = np.hypot(*(pose.value[lag:, PLANE] - pose.value[:-lag, PLANE]).T)
        own = float(np.quantile(way / (pose.time[lag:] - pose.time[:-lag]), JUMPS.usual_top))
    return max(JUMPS.own_speeds * own, JUMPS.platform_speeds * full_speed(platform))


def without_spikes(pose: Stream, jumps: tuple[Jump, ...], platform: Platform) -> Stream:
    """Leave out the poses between a leap and the leap back, where less than a second lies between."""
    kept = np.ones(len(pose.time), dtype=bool)
    for there in jumps:
        for back in jumps:
            if not 0.0 <= back.before - there.after <= JUMPS.spike:
                continue
            way = np.hypot(*(back.reached - there.left)[PLANE])
            if way <= reach(pose, platform) + _top_speed(pose, platform) * (back.after - there.before):
                kept &= (pose.time < there.after) | (pose.time > back.before)
                break
    return selected(pose, kept)


def selected(pose: Stream, kept: Flags) -> Stream:
    """Keep the poses of the chosen moments (n,)."""
    return replace(pose, time=pose.time[kept], value=pose.value[kept])
