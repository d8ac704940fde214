"""What is published and recorded for viewers alone: robots as URDF, their fixed frames, markers of tank and swarm.

It is drawn from scenario, poses and commands: a recording without it says the same, and a digest leaves it out.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.light import Light
from cocorosim_ros.scenario.parts.tank import Tank
from cocorosim_ros.scenario.scenario import RobotDescription, Scenario
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.command_check import CommandReader
from cocorosim_ros.wire.topics.markers import SwarmMarkers, robot_colour, tank_markers
from cocorosim_ros.wire.topics.robot_description import description_message, static_frames
from cocorosim_ros.wire.topics.topics import robot_topic

DESCRIPTION, FRAMES, TANK, SWARM = "robot_description", "/tf_static", "/markers/tank", "/markers/swarm"
PERIOD = 2  # s between two messages of what moves


def scenery_topics(robots: Sequence[str]) -> dict[str, str]:
    """Every topic of the scenery and the row of the topics table that it belongs to, in the order of recording."""
    descriptions = {robot_topic(name, DESCRIPTION): DESCRIPTION for name in robots}
    return {FRAMES: FRAMES, **descriptions, TANK: TANK, SWARM: SWARM}


def by_name(robots: Iterable[RobotDescription]) -> list[RobotDescription]:
    """The robots in the order in which a run measures them, and which their colours follow."""
    return sorted(robots, key=lambda robot: robot.name)


def standing_messages(
    robots: Iterable[RobotDescription], tank: Tank | None = None, light: Light | None = None
) -> dict[str, bytes]:
    """Topic and bytes of what holds during the whole run; tank and light where they are known."""
    named = {robot.name: robot.platform for robot in by_name(robots)}
    messages = {FRAMES: static_frames(named)}
    for number, (name, platform) in enumerate(named.items()):
        colour = robot_colour(number, len(named))
        messages[robot_topic(name, DESCRIPTION)] = description_message(name, platform, colour)
    return {**messages, TANK: tank_markers(tank, light, list(named))}


class Scenery:
    """The scenery of one run."""

    def __init__(
        self, robots: Sequence[RobotDescription], tank: Tank | None = None, light: Light | None = None
    ) -> None:
        """`tank`, `light`: where they are known."""
        ordered = by_name(robots)
        self.topics = scenery_topics([robot.name for robot in robots])
        self.standing = standing_messages(robots, tank, light)
        self._bodies = [describe_body(robot) for robot in ordered]
        self._readers = [CommandReader(body) for body in self._bodies]
        self._most_actuators = max(len(body.actuators) for body in self._bodies)
        self._swarm = SwarmMarkers([robot.platform for robot in ordered], PERIOD)
        self._period = -1

    @classmethod
    def of(cls, scenario: Scenario) -> Scenery:
        """That of a simulated run."""
        return cls(scenario.robots, scenario.tank, scenario.light)

    def swarm(self, stamp_ns: int, position: Floats, yaw: Floats, messages: Mapping[str, bytes]) -> bytes | None:
        """The bytes of `/markers/swarm`; None within a period that has some already.

        position: (n, 3) [m; world]; yaw: (n,) [rad]; robots by name. messages: the bytes of `thruster_command` are
        looked for in these, by topic.
        """
        period = stamp_ns // (PERIOD * NANOSECONDS)
        if period == self._period:
            return None
        self._period = period
        commands = np.zeros((len(self._bodies), self._most_actuators))
        for number, body in enumerate(self._bodies):
            data = messages.get(robot_topic(body.name, "thruster_command"))
            if data is not None:
                fractions, _ = self._readers[number].read(data)
                commands[number, : len(fractions)] = fractions
        return self._swarm.encode(stamp_ns, position, yaw, commands)
