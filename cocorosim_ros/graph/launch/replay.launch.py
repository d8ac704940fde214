"""A recording played back on a full ROS installation, measured and recorded anew by the metrics node.

ros2 launch cocorosim_ros replay.launch.py bag:=runs/demo/bag out:=again
"""

from __future__ import annotations

from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, OpaqueFunction, SetEnvironmentVariable, Shutdown
from launch.substitutions import EnvironmentVariable, LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import ExecutableInPackage

from cocorosim_ros.graph.runs.run_record import STATISTICS_TOPIC, run_topics
from cocorosim_ros.scenario.parts.controller_file import load_controller
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.topics import split_topic

PACKAGE = "cocorosim_ros"
ARGUMENTS = {
    "bag": ("", "recording to play"),
    "rate": ("1.0", "speed of the replay, 1.0: as recorded"),
    "platform": ("lily", "platform of its robots"),
    "out": ("bag", "folder of the new recording; must not exist"),
    "force": ("false", "replace a recording that is there"),
}


def robots_in(bag: Bag) -> list[str]:
    """The robots whose poses a recording holds."""
    topics = [split_topic(topic.topic) for topic in bag.summary.topics]
    return sorted(namespace for namespace, name in topics if name == "pose")


def subscriptions(bag: Bag, platform: str) -> int:
    """To how many topics of the recording the metrics node will subscribe."""
    hull, idle = load_platform(platform), load_controller("idle")
    bodies = [describe_body(RobotDescription(name, hull, idle, external=True)) for name in robots_in(bag)]
    return len((run_topics(bodies).keys() - {STATISTICS_TOPIC}) & {topic.topic for topic in bag.summary.topics})


def nodes(context: LaunchContext) -> list[Node | ExecuteProcess]:
    """The metrics node and the player, which waits for it."""
    given = {name: LaunchConfiguration(name).perform(context) for name in ARGUMENTS}
    bag = read_bag(given["bag"])
    texts = {"robots": " ".join(robots_in(bag)), "platform": given["platform"], "out": given["out"]}
    metrics = {name: ParameterValue(value, value_type=str) for name, value in texts.items()}
    metrics |= {"force": given["force"].lower() == "true", "lock_step": False}
    player = [ExecutableInPackage("cocorosim", PACKAGE), "replay", given["bag"], "--rate", given["rate"]]
    player += ["--wait", str(subscriptions(bag, given["platform"]))]
    return [
        Node(package=PACKAGE, executable="metrics_node", parameters=[metrics], output="screen"),
        ExecuteProcess(cmd=player, output="screen", on_exit=Shutdown(reason="the recording has been played")),
    ]


def generate_launch_description() -> LaunchDescription:
    """What `ros2 launch` asks for."""
    arguments = [
        DeclareLaunchArgument(name, default_value=default, description=words)
        for name, (default, words) in ARGUMENTS.items()
    ]
    # The player takes a domain of its own where none is given, and stays on this machine.
    domain = SetEnvironmentVariable("ROS_DOMAIN_ID", EnvironmentVariable("ROS_DOMAIN_ID", default_value="0"))
    reach = SetEnvironmentVariable("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    return LaunchDescription([*arguments, domain, reach, OpaqueFunction(function=nodes)])
