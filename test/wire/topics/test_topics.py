"""The table of topics is the contract."""

from __future__ import annotations

import pytest

from cocorosim_ros.wire.cdr.type_store import is_known
from cocorosim_ros.wire.topics.service_quality import PROFILES
from cocorosim_ros.wire.topics.topics import GLOBAL_TOPICS, ROBOT_TOPICS, TOPICS, Topic, robot_topic, split_topic

CONTRACT = {
    "pose": "geometry_msgs/msg/PoseStamped",
    "compass": "cocorosim_msgs/msg/Compass",
    "pressure": "sensor_msgs/msg/FluidPressure",
    "imu": "sensor_msgs/msg/Imu",
    "blss": "cocorosim_msgs/msg/BlssScan",
    "velocity": "geometry_msgs/msg/TwistStamped",
    "thruster_command": "cocorosim_msgs/msg/ThrusterCommand",
}


def test_contract_topics_have_the_contract_types() -> None:
    """Every topic that the contract fixes is in the table under its type."""
    assert {name: ROBOT_TOPICS[name].type_name for name in CONTRACT} == CONTRACT


@pytest.mark.parametrize("topic", TOPICS.values(), ids=lambda topic: topic.name)
def test_every_topic_is_usable(topic: Topic) -> None:
    """Its type is known, its quality of service is a named profile, and its place is said right."""
    assert is_known(topic.type_name)
    assert topic.quality is PROFILES[topic.quality.name]
    assert topic.per_robot == (topic.name in ROBOT_TOPICS) == (topic.name not in GLOBAL_TOPICS)


@pytest.mark.parametrize(
    ("namespace", "name", "topic"),
    [
        ("lily_01", "pose", "/lily_01/pose"),
        ("/tank/lily_01/", "imu", "/tank/lily_01/imu"),
        ("", "pose", "/pose"),
    ],
)
def test_topic_names_and_back(namespace: str, name: str, topic: str) -> None:
    """A robot's topic is made of namespace and name, and taken apart again."""
    assert robot_topic(namespace, name) == topic
    assert split_topic(topic) == (namespace.strip("/"), name)


def test_quality_as_rosbag2_has_its_keys() -> None:
    """The keys are those of rosbag2 metadata version 9; unlimited is RMW_DURATION_INFINITE, 2^63 - 1 ns."""
    quality = PROFILES["stream"].as_rosbag2()
    assert list(quality) == [
        "history", "depth", "reliability", "durability", "deadline", "lifespan", "liveliness",
        "liveliness_lease_duration", "avoid_ros_namespace_conventions",
    ]  # fmt: skip
    assert quality["deadline"]["sec"] * 10**9 + quality["deadline"]["nsec"] == 2**63 - 1
