"""Publishing, taking and waiting on raw bytes, by whichever path this rclpy allows.

The fast one takes bytes by hand (`rclpy_internals`); the plain one has them brought by an executor (`executor_path`).
Both give the same recording.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any
from weakref import WeakKeyDictionary

from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy

from cocorosim_ros.graph.nodes import executor_path, rclpy_internals
from cocorosim_ros.graph.nodes.path_choice import PATH_VARIABLE, plain_path_asked
from cocorosim_ros.graph.nodes.quality_overrides import overriding_options
from cocorosim_ros.wire.topics.service_quality import ServiceQuality

LONGEST_WAIT = 0.2  # s; signals are looked at in between
PLAIN_CHOSEN = f"messages go through an executor, because {PATH_VARIABLE} asks for it"
PLAIN_NEEDED = "messages go through an executor, which is slower: this rclpy has not what the fast path needs ({})"


@dataclass(frozen=True)
class Path:
    """One way of getting bytes through rclpy."""

    ear: Callable[..., Any]  # of (node, message class, topic, profile, options): a subscription
    sleeper: Callable[..., Any]  # of (node, most ears): what waits for some of them
    publisher_of_bytes: Callable[[Any], Callable[[bytes], None]]


FAST = Path(rclpy_internals.TakenEar, rclpy_internals.WaitSet, rclpy_internals.publisher_of_bytes)
PLAIN = Path(executor_path.HeardEar, executor_path.Arrival, executor_path.publisher_of_bytes)
_chosen: WeakKeyDictionary[Context, Path] = WeakKeyDictionary()


def path_of(node: Node) -> Path:
    """The path for all nodes of this node's context; if it is the plain one, the first node's log says so.

    Raises CocorosimError if the environment asks for a path that does not exist.
    """
    if node.context not in _chosen:
        _chosen[node.context] = _choose(node)
    return _chosen[node.context]


def _choose(node: Node) -> Path:
    if plain_path_asked():
        node.get_logger().info(PLAIN_CHOSEN)
        return PLAIN
    missing = rclpy_internals.what_is_missing(node)
    if missing:
        node.get_logger().warning(PLAIN_NEEDED.format(missing))
    return PLAIN if missing else FAST


def message_class(type_name: str) -> Any:
    """The rclpy class of a type such as geometry_msgs/msg/PoseStamped."""
    package, _, name = type_name.split("/")
    return getattr(importlib.import_module(f"{package}.msg"), name)


def quality_profile(quality: ServiceQuality, *, keep_all: bool = False) -> QoSProfile:
    """A quality of service as rclpy wants it; `keep_all`: whatever comes is kept, and a full queue takes no more."""
    return QoSProfile(
        depth=quality.depth,
        history=HistoryPolicy.KEEP_ALL if keep_all else HistoryPolicy.KEEP_LAST,
        reliability=ReliabilityPolicy[quality.reliability.upper()],
        durability=DurabilityPolicy[quality.durability.upper()],
    )


class Listener:
    """One subscription whose messages are taken as CDR bytes."""

    take: Callable[[], bytes | None]  # the next message, or None if there is none

    def __init__(
        self, node: Node, type_name: str, topic: str, quality: ServiceQuality, *, keep_all: bool = False
    ) -> None:
        """`keep_all`: a reliable publisher that waits for acknowledgements can never outrun this subscription."""
        self.topic = topic
        self.type_name = type_name
        profile = quality_profile(quality, keep_all=keep_all)
        options = overriding_options(node, topic)
        self.ear = path_of(node).ear(node, message_class(type_name), topic, profile, qos_overriding_options=options)
        self.take = self.ear.take

    @property
    def publishers(self) -> int:
        """How many publishers are matched."""
        return int(self.ear.subscription.get_publisher_count())


class Speaker:
    """One publisher of CDR bytes."""

    publish: Callable[[bytes], None]

    def __init__(self, node: Node, type_name: str, topic: str, quality: ServiceQuality) -> None:
        self.topic = topic
        self.type_name = type_name
        kind, profile = message_class(type_name), quality_profile(quality)
        options = overriding_options(node, topic)
        self._publisher = node.create_publisher(kind, topic, profile, qos_overriding_options=options)
        self.publish = path_of(node).publisher_of_bytes(self._publisher)

    def all_received(self) -> bool:
        """Whether every matched reliable subscription has acknowledged everything."""
        return bool(self._publisher.wait_for_all_acked(Duration(seconds=0.1)))

    @property
    def subscribers(self) -> int:
        """How many subscriptions are matched."""
        return int(self._publisher.get_subscription_count())


class Waiter:
    """Sleeps until one of some listeners has a message."""

    def __init__(self, node: Node, most: int) -> None:
        self._sleeper = path_of(node).sleeper(node, most)

    def wait(self, listeners: Sequence[Listener], seconds: float) -> list[int]:
        """Return the places of `listeners` that have a message, when there is any.

        After `seconds` (at most LONGEST_WAIT) there may be none.
        """
        ears, limit = [listener.ear for listener in listeners], max(0.0, min(seconds, LONGEST_WAIT))
        places: list[int] = self._sleeper.wait(ears, limit)
        return places
