"""What a run leaves behind: what made it, and facts for pictures of it."""

from __future__ import annotations

import json
import platform
from importlib.metadata import PackageNotFoundError, version

from cocorosim_ros import __version__
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.tank import Box, Sphere
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.pictures.facts import ScenarioFacts
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.topics.topics import robot_topic
from cocorosim_ros.world.checks.loading import parse_scenario

_TOPICS_SHOWN = 5
_LIBRARIES = ("numpy", "numba", "ros-jazzy-rclpy")


def recording_metadata(scenario: Scenario) -> dict[str, str]:
    """What made a recording: scenario text, seed, versions."""
    versions = {"cocorosim_ros": __version__, "python": platform.python_version()}
    for library in _LIBRARIES:
        try:
            versions[library] = version(library)
        except PackageNotFoundError:
            versions[library] = "not installed"
    return {
        "scenario_name": scenario.name,
        "scenario": scenario.to_yaml(),
        "seed": str(scenario.seed),
        "versions": json.dumps(versions, sort_keys=True),
    }


def no_poses(bag: Bag, robots: list[str]) -> str:
    """The sentence for a recording that has no usable poses of `robots`, those that have a topic for them."""
    others = [f"{topic} ({type_name})" for topic, type_name in bag.summary.types.items()]
    if robots:
        there = f"its topics {', '.join(robot_topic(robot, 'pose') for robot in robots)} have no usable message"
    else:
        there = f"it has {', '.join(others[:_TOPICS_SHOWN])}" if others else "it has no topics"
        there += f" and {len(others) - _TOPICS_SHOWN} more" if len(others) > _TOPICS_SHOWN else ""
    damage = f" ({bag.summary.damage.rstrip('.')})" if bag.summary.damage else ""
    return (
        f"{bag.path} holds no poses: {there}{damage}; there must be a topic NAMESPACE/pose of type "
        "geometry_msgs/msg/PoseStamped for each robot, or Odometry, poses of any name, or moving frames in /tf."
    )


def readable_scenario(bag: Bag) -> tuple[Scenario | None, str]:
    """The scenario of a recording, and a sentence if it tells one that cannot be read: the poses are whole even then.

    One flipped bit does that, and a key of a newer version.
    """
    text = bag.summary.metadata.get("cocorosim", {}).get("scenario")
    if text is None:
        return None, ""
    try:
        return parse_scenario(text, str(bag.path)), ""
    except CocorosimError as error:
        why = str(error).rstrip(".")
        return None, f"The scenario that made the recording cannot be read, so its tank is not shown: {why}."


def scenario_facts(bag: Bag) -> ScenarioFacts:
    """Name, seed, tank and obstacles, where the recording knows its scenario."""
    scenario, _ = readable_scenario(bag)
    return ScenarioFacts(bag.path.name) if scenario is None else facts_of(scenario)


def facts_of(scenario: Scenario) -> ScenarioFacts:
    """Name, seed, tank and obstacles of a scenario."""
    tank = scenario.tank
    spheres = tuple((*solid.centre, solid.radius) for solid in tank.obstacles if isinstance(solid, Sphere))
    boxes = tuple(solid.corners() for solid in tank.obstacles if isinstance(solid, Box))
    return ScenarioFacts(
        scenario.name, scenario.seed, tank.lower_corner(), tank.upper_corner(), spheres=spheres, boxes=boxes
    )
