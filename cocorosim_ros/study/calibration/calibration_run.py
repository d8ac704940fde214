"""The recording of a calibration run: what one robot was commanded and where it was."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag
from cocorosim_ros.wire.bags.tracks import RecordedTrack, read_poses
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.command_check import CommandReader
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, robot_topic

FEWEST_POSES = 20
COMMAND = ROBOT_TOPICS["thruster_command"]


@dataclass(frozen=True)
class CalibrationRun:
    """Commands and poses on one time axis that begins with the first pose."""

    robot: str
    moments: Floats  # (n,) [s] of commands and poses, ascending
    commands: Floats  # (n, actuators) that hold from each moment on
    measured: Integers  # (m,) rows of `moments` at which there is a pose
    poses: Floats  # (m, 4) x, y, z [m; world], yaw [rad]


def read_calibration_run(path: Path, platform: Platform, robot: str | None = None) -> CalibrationRun:
    """The run of a robot of a recording; `robot` may be left out if there is one alone.

    Raises CocorosimError: no such robot, several to choose from, no commands, too few poses.
    """
    bag = read_bag(path)
    tracks = read_poses(bag)
    name = _chosen_robot(path, sorted(tracks), robot)
    track = tracks[name]
    stamps, commands = _read_commands(bag, path, name, platform)
    return _on_one_axis(path, name, track, stamps, commands)


def _chosen_robot(path: Path, names: list[str], robot: str | None) -> str:
    if robot is None and len(names) == 1:
        return names[0]
    if robot is None:
        found = f"the robots {', '.join(names)}; choose one with --robot" if names else "no poses; record pose topics"
        raise CocorosimError(f"{path}: the recording has {found}.")
    if robot not in names:
        raise CocorosimError(f"{path}: the recording has no poses of '{robot}'; it has {', '.join(names) or 'none'}.")
    return robot


def _read_commands(bag: Bag, path: Path, robot: str, platform: Platform) -> tuple[Integers, Floats]:
    topic = robot_topic(robot, COMMAND.name)
    body = BodyDescription(robot, (), platform.actuator_names, (), speaks=False, mixing=platform.stick_mixing())
    reader = CommandReader(body)
    found: dict[int, Floats] = {}
    for message in bag.messages([topic]):
        stamp = stamp_ns(message.type_name, message.data)
        found.setdefault(message.log_time_ns if stamp is None else stamp, reader.read(message.data)[0])
    if not found:
        raise CocorosimError(f"{path}: the recording has no commands on {topic}; record them too.")
    stamps = sorted(found)
    return np.array(stamps, dtype=np.int64), np.array([found[stamp] for stamp in stamps])


def _on_one_axis(path: Path, robot: str, track: RecordedTrack, stamps: Integers, commands: Floats) -> CalibrationRun:
    usable = np.isfinite(track.yaw)
    pose_stamps = track.stamp_ns[usable]
    if len(pose_stamps) < FEWEST_POSES:
        raise CocorosimError(
            f"{path}: the recording has {len(pose_stamps)} usable poses of '{robot}'; {FEWEST_POSES} are needed."
        )
    first, last = pose_stamps[0], pose_stamps[-1]
    axis = np.union1d(pose_stamps, stamps[(stamps > first) & (stamps < last)])
    holding = np.searchsorted(stamps, axis, side="right") - 1
    held = np.where(holding[:, None] >= 0, commands[np.maximum(holding, 0)], 0.0)
    poses = np.column_stack([track.position[usable], track.yaw[usable]])
    moments = (axis - first) / NANOSECONDS
    return CalibrationRun(robot, moments, held, np.searchsorted(axis, pose_stamps), poses)
