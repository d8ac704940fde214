"""The recorded offers of recordings of every age."""

from __future__ import annotations

from pathlib import Path

import pytest
from rosbags.interfaces import Qos, QosDurability, QosHistory, QosLiveliness, QosReliability, QosTime
from rosbags.rosbag2 import StoragePlugin, Writer

from cocorosim_ros.wire.bags.bag_metadata import yaml_text
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.offered_quality import offered_quality
from cocorosim_ros.wire.cdr.type_store import type_store
from cocorosim_ros.wire.topics.service_quality import PROFILES

# As rosbag2 of ROS 2 Foxy to Iron wrote them: numbers of rmw/types.h.
OLD = """- history: 3
  depth: {depth}
  reliability: {reliability}
  durability: {durability}
  deadline:
    sec: 9223372036
    nsec: 854775807
"""


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
def test_own_profiles(profile: object) -> None:
    """What we record is what is offered again."""
    quality = offered_quality(yaml_text([profile.as_rosbag2()]))  # type: ignore[attr-defined]
    for part in ("reliability", "durability", "depth"):
        assert getattr(quality, part) == getattr(profile, part)


@pytest.mark.parametrize(
    ("numbers", "expected"),
    [
        ((0, 1, 2), ("reliable", "volatile", 10)),
        ((5, 2, 2), ("best_effort", "volatile", 5)),
        ((1, 1, 1), ("reliable", "transient_local", 1)),
        ((0, 0, 0), ("reliable", "volatile", 10)),
    ],
)
def test_numbers_of_older_recordings(numbers: tuple[int, int, int], expected: tuple[str, str, int]) -> None:
    """Depth, reliability and durability as numbers; zero is whatever is usual."""
    quality = offered_quality(OLD.format(**dict(zip(("depth", "reliability", "durability"), numbers, strict=True))))
    assert (quality.reliability, quality.durability, quality.depth) == expected


def test_several_publishers() -> None:
    """The strongest of several offers serves all who listened to any of them."""
    text = OLD.format(depth=3, reliability=2, durability=1) + OLD.format(depth=8, reliability=1, durability=2)
    quality = offered_quality(text)
    assert (quality.reliability, quality.durability, quality.depth) == ("reliable", "transient_local", 8)


@pytest.mark.parametrize("text", ["", "[]", "nonsense", "a: [", "- 5", "- depth: many\n  reliability: [1]", "\x00"])
def test_what_says_nothing(text: str) -> None:
    """The usual offer of ROS."""
    quality = offered_quality(text)
    assert (quality.reliability, quality.durability, quality.depth) == ("reliable", "volatile", 10)


def test_recorded_by_the_independent_writer(tmp_path: Path) -> None:
    """Offers in a recording made by `rosbags` are understood."""
    never = QosTime(9223372036, 854775807)
    policies = (QosHistory.KEEP_LAST, 7, QosReliability.BEST_EFFORT, QosDurability.TRANSIENT_LOCAL)
    offer = Qos(*policies, never, never, QosLiveliness.AUTOMATIC, never, False)
    with Writer(tmp_path / "bag", version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        writer.add_connection("/word", "std_msgs/msg/String", typestore=type_store(), offered_qos_profiles=[offer])
    quality = offered_quality(read_bag(tmp_path / "bag").summary.topics[0].offered_qos_profiles)
    assert (quality.reliability, quality.durability, quality.depth) == ("best_effort", "transient_local", 7)
