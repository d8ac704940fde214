"""Groups of equal robots: how many, of which platform, with which controller, and where they start."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any

from cocorosim_ros.scenario.parts.controller_choice import (
    AnyController,
    controller_choice_tree,
    read_controller_choice,
)
from cocorosim_ros.scenario.parts.platform import Platform, platform_tree, read_platform, read_platform_file
from cocorosim_ros.scenario.parts.vehicle_parts import Vector3
from cocorosim_ros.scenario.reading.config_files import referenced_config
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import quantity_text, read_vector
from cocorosim_ros.scenario.reading.records import TEXT, nested, read_record, record_tree, stored, vector

Pose = tuple[float, float, float, float]
MOST_ROBOTS = 100_000
_POSE_DIMENSIONS = ("length", "length", "length", "angle")
_ROS_NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")


@dataclass(frozen=True)
class StartBox:
    """Robots start at random places in a box [m; world] with random headings; centre, full size."""

    centre: Vector3 = field(metadata=vector("length", 3))
    size: Vector3 = field(metadata=vector("length", 3, "not negative"))

    def lower_corner(self) -> Vector3:
        """The corner with the smallest coordinates [m; world]."""
        (x, y, z), (a, b, c) = self.centre, self.size
        return x - a / 2, y - b / 2, z - c / 2

    def upper_corner(self) -> Vector3:
        """The corner with the greatest coordinates [m; world]."""
        (x, y, z), (a, b, c) = self.centre, self.size
        return x + a / 2, y + b / 2, z + c / 2


def _read_poses(entry: Entry) -> tuple[Pose, ...]:
    return tuple(_read_pose(part) for part in entry.items())


def _read_pose(entry: Entry) -> Pose:
    x, y, z, yaw = read_vector(entry, _POSE_DIMENSIONS)
    return x, y, z, yaw


def _poses_tree(poses: tuple[Pose, ...]) -> list[list[str]]:
    return [[quantity_text(*part) for part in zip(pose, _POSE_DIMENSIONS, strict=True)] for pose in poses]


@dataclass(frozen=True)
class Start:
    """Where a group starts: in a box at random, or at given poses (x, y, z [m; world], yaw [rad])."""

    box: StartBox | None = field(default=None, metadata=nested(StartBox))
    poses: tuple[Pose, ...] | None = field(
        default=None, metadata=stored(_read_poses, _poses_tree, form="list of [x, y, z, yaw] in m and rad; world")
    )


def _read_platform_choice(entry: Entry) -> Platform:
    if isinstance(entry.value, dict):
        return read_platform(entry)
    return read_platform_file(referenced_config("platforms", entry))


def _whole_count(entry: Entry) -> int:
    return entry.whole_number(1, MOST_ROBOTS)


_COUNT_FORM = f"whole number from 1 to {MOST_ROBOTS}; that of the poses, where `start` has them, if left out"
_PLATFORM = stored(
    _read_platform_choice, platform_tree, form="name in config/platforms, a file, or the platform's own keys"
)
_CONTROLLER = stored(
    read_controller_choice,
    controller_choice_tree,
    form="name in config/controllers, a file, my_file.py:MyController, or {file, parameters}",
)


@dataclass(frozen=True)
class SwarmGroup:
    """Equal robots: `count` of one platform and controller, called `prefix`_01, `prefix`_02, ..."""

    platform: Platform = field(metadata=_PLATFORM)
    count: int = field(metadata=stored(_whole_count, int, form=_COUNT_FORM))
    prefix: str = field(metadata=TEXT | {"form": "small letters, digits and single underscores"})
    controller: AnyController = field(metadata=_CONTROLLER)
    start: Start = field(metadata=nested(Start))

    def robot_names(self) -> list[str]:
        """The names of the robots, which are their ROS namespaces."""
        width = max(2, len(str(self.count)))
        return [f"{self.prefix}_{number:0{width}d}" for number in range(1, self.count + 1)]


def read_swarm(entry: Entry) -> tuple[SwarmGroup, ...]:
    """The groups that a list describes; at least one."""
    groups = tuple(read_group(part) for part in entry.items())
    if not groups:
        raise entry.problem("has no group of robots; add at least one with its platform, count, controller and start.")
    total = sum(group.count for group in groups)
    if total > MOST_ROBOTS:
        raise entry.problem(
            f"has {total:,} robots in all its groups, more than the {MOST_ROBOTS:,} that one run takes; choose fewer."
        )
    prefixes = [group.prefix for group in groups]
    for part, group in zip(entry.items(), groups, strict=True):
        if prefixes.count(group.prefix) > 1:
            raise part.problem(
                f"shares the prefix '{group.prefix}' with another group; give each group its own 'prefix'."
            )
    return groups


def read_group(entry: Entry) -> SwarmGroup:
    """The group that a mapping describes."""
    section = entry.section(("platform", "controller", "start"), ("count", "prefix", "overrides"))
    platform = _read_platform_choice(section["platform"])
    controller = read_controller_choice(section["controller"])
    if "overrides" in section:
        controller = controller.with_override_entries(section["overrides"].mapping())
    start = _read_start(section["start"])
    prefix = _checked_prefix(section.get("prefix", section["platform"]), section, platform)
    return SwarmGroup(platform, _read_count(entry, section, start), prefix, controller, start)


def swarm_tree(groups: tuple[SwarmGroup, ...]) -> list[dict[str, Any]]:
    """The groups as nested plain values that `read_swarm` reads, platforms and controllers written out."""
    return [record_tree(group) for group in groups]


SWARM = stored(read_swarm, swarm_tree, form="list of mappings") | {
    "inside": SwarmGroup,
    "several": True,
    "also": {"overrides": "mapping of names of the controller's parameters to other values"},
}


def _read_start(entry: Entry) -> Start:
    start = read_record(Start, entry)
    if (start.box is None) == (start.poses is None):
        raise entry.problem("needs either 'box' or 'poses'; write one of the two.")
    return start


def _read_count(entry: Entry, section: dict[str, Entry], start: Start) -> int:
    if "count" not in section and start.poses is None:
        raise entry.problem("lacks 'count'; add the number of robots.")
    if "count" not in section:
        count = Entry(len(start.poses or ()), entry.file, section["start"].line, f"{entry.key}.start.poses")
        return count.whole_number(1, MOST_ROBOTS)
    count = section["count"]
    number = _whole_count(count)
    if start.poses is not None and len(start.poses) != number:
        raise count.problem(f"has '{number}' but 'start.poses' has {len(start.poses)} poses; make them equal.")
    return number


def _checked_prefix(entry: Entry, section: dict[str, Entry], platform: Platform) -> str:
    prefix = entry.text() if "prefix" in section else platform.name
    if not _ROS_NAME.fullmatch(prefix):
        raise entry.problem(
            f"gives robots the name '{prefix}', which is no ROS namespace; write 'prefix' in small letters, "
            "digits and single underscores, beginning with a letter."
        )
    return prefix
