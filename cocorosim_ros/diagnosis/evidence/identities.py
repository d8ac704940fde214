"""Tracks that belong to the robot of their name: without spikes, exchanged back, or cut to the part that is sure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import EXCHANGES, JUMPS
from cocorosim_ros.diagnosis.evidence.cleaning import gaps_of
from cocorosim_ros.diagnosis.evidence.pose_jumps import Jump, find_jumps, reach, selected, without_spikes
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE, YAW
from cocorosim_ros.diagnosis.evidence.streams.turning import unwrapped
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import full_speed
from cocorosim_ros.scenario.parts.platform import Platform


def with_true_identities(logs: Sequence[RobotLog], platform: Platform) -> tuple[list[RobotLog], list[str]]:
    """Repair the tracks of the robots of one recording until none leaps; also give a sentence about every repair.

    Poses that are off the track for less than a second are left out. Where two tracks leap to each other's place at the
    same time, they are exchanged back. Of a track that leaps for another reason the longest stretch without a leap is
    kept, because the rest may belong to another robot.
    """
    remarks: list[str] = []
    robots = {log.name: _without_spikes(log, platform, remarks) for log in logs}
    _exchange_back(robots, platform, remarks)
    return [_longest_stretch(robots[log.name], platform, remarks) for log in logs], remarks


def _without_spikes(log: RobotLog, platform: Platform, remarks: list[str]) -> RobotLog:
    jumps = _jumps(log, platform)
    if not jumps:
        return log
    pose = without_spikes(log.streams["pose"], jumps, platform)
    lost = np.setdiff1d(log.streams["pose"].time, pose.time)
    if not lost.size:
        return log
    remarks.append(
        f"{log.name}/pose: {lost.size} poses lie far off the track for less than a second, first at {lost[0]:.1f} s; "
        "they were left out."
    )
    return _with_pose(log, pose)


def _exchange_back(robots: dict[str, RobotLog], platform: Platform, remarks: list[str]) -> None:
    """Exchange tracks that were exchanged, the earliest first, until none is left."""
    for _ in range(sum(len(_jumps(log, platform, EXCHANGES.close)) for log in robots.values())):
        found = _first_exchange(robots, platform)
        if found is None:
            return
        (one, other), (here, there) = found
        remarks.append(
            f"{one}/pose and {other}/pose: the two tracks leap to each other's place at {here.after:.1f} s "
            f"({here.distance:.2f} m; the camera has confused the robots); they were exchanged back from there on."
        )
        first, second = robots[one], robots[other]
        robots[one] = _joined(first, here, second, there)
        robots[other] = _joined(second, there, first, here)


def _first_exchange(
    robots: dict[str, RobotLog], platform: Platform
) -> tuple[tuple[str, str], tuple[Jump, Jump]] | None:
    found = []
    for one, other in combinations(sorted(robots), 2):
        for here in _jumps(robots[one], platform, EXCHANGES.close):
            for there in _jumps(robots[other], platform, EXCHANGES.close):
                if _exchanged(here, there, robots[one].streams["pose"], platform):
                    found.append(((one, other), (here, there)))
    return min(found, key=lambda pair: pair[1][0].after) if found else None


def _exchanged(here: Jump, there: Jump, pose: Stream, platform: Platform) -> bool:
    """Tell whether each of two leaps ends where the other began, at the same time."""
    if max(abs(here.before - there.before), abs(here.after - there.after)) > EXCHANGES.together:
        return False
    duration = max(here.after, there.after) - min(here.before, there.before)
    near = reach(pose, platform, EXCHANGES.close) + EXCHANGES.full_speeds * full_speed(platform) * duration
    closer = EXCHANGES.closer * min(here.distance, there.distance)
    return all(
        np.hypot(*(reached - left)[PLANE]) < min(near, closer)
        for reached, left in ((here.reached, there.left), (there.reached, here.left))
    )


def _joined(log: RobotLog, own: Jump, other: RobotLog, others: Jump) -> RobotLog:
    """Join the poses of `log` before its own jump and the poses of `other` after the jump of `other`."""
    mine, theirs = log.streams["pose"], other.streams["pose"]
    before = selected(mine, mine.time <= own.before)
    after = selected(theirs, theirs.time >= others.after)
    late = after.time > before.time[-1]
    pose = replace(
        mine,
        time=np.concatenate([before.time, after.time[late]]),
        value=np.concatenate([before.value, after.value[late]]),
    )
    return _with_pose(log, pose)


def _longest_stretch(log: RobotLog, platform: Platform, remarks: list[str]) -> RobotLog:
    jumps = _jumps(log, platform)
    if not jumps:
        return log
    pose = log.streams["pose"]
    ends = [
        float(pose.time[0]),
        *(moment for jump in jumps for moment in (jump.before, jump.after)),
        float(pose.time[-1]),
    ]
    stretches = [(first, last) for first, last in list(pairwise(ends))[::2]]
    first, last = max(stretches, key=lambda stretch: stretch[1] - stretch[0])
    times = ", ".join(f"{jump.after:.1f} s ({jump.distance:.2f} m)" for jump in jumps[: JUMPS.most_told])
    untold = len(jumps) - JUMPS.most_told
    more = f" and {untold} times more" if untold > 0 else ""
    remarks.append(
        f"{log.name}/pose: the track leaps farther than the robot can swim, at {times}{more}: lost, or of another "
        f"robot; of the poses only those from {first:.1f} to {last:.1f} s are used."
    )
    return _with_pose(log, selected(pose, (pose.time >= first) & (pose.time <= last)))


def _jumps(log: RobotLog, platform: Platform, hulls: float = 1.0) -> tuple[Jump, ...]:
    return find_jumps(log.streams["pose"], platform, hulls) if "pose" in log.streams else ()


def _with_pose(log: RobotLog, pose: Stream) -> RobotLog:
    value = pose.value.copy()
    value[:, YAW] = unwrapped(pose.time, value[:, YAW], pose.full_turn)
    streams = {**log.streams, "pose": replace(pose, value=value)}
    return replace(log, streams=streams, gaps=gaps_of(pose.time))
