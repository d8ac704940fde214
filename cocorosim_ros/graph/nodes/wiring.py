"""Publishing, taking and waiting on raw bytes, without an executor.

An executor wakes Python once per message and builds an object from each; in a swarm of eleven that costs ten times
what the messages themselves cost. Here a node takes bytes when it wants them and sleeps in one wait set until one
of a few chosen subscriptions has something.
"""

from __future__ import annotations

import importlib
from collections.abc import Sequence
from typing import Any, cast

from rclpy.callback_groups import CallbackGroup
from rclpy.duration import Duration
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.topics.service_quality import ServiceQuality

LONGEST_WAIT = 0.2  # s; signals are looked at in between


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


class _TakenByHand(CallbackGroup):
    """Keeps an executor (the one of the parameter services) away from subscriptions that the node takes itself."""

    def can_execute(self, entity: Any) -> bool:
        return False

    def beginning_execution(self, entity: Any) -> bool:
        return False

    def ending_execution(self, entity: Any) -> None:
        return None


class Listener:
    """One subscription whose messages are taken as CDR bytes."""

    def __init__(
        self, node: Node, type_name: str, topic: str, quality: ServiceQuality, *, keep_all: bool = False
    ) -> None:
        """`keep_all`: a reliable publisher that waits for acknowledgements can never outrun this subscription."""
        self.topic = topic
        self.type_name = type_name
        self._class = message_class(type_name)
        subscription = node.create_subscription(
            self._class,
            topic,
            lambda message: None,
            quality_profile(quality, keep_all=keep_all),
            callback_group=_TakenByHand(),
            raw=True,
        )
        self.handle = subscription.handle

    def take(self) -> bytes | None:
        """The next message, or None if there is none."""
        taken = self.handle.take_message(self._class, True)
        return None if taken is None else cast(bytes, taken[0])

    @property
    def publishers(self) -> int:
        """How many publishers are matched."""
        return int(self.handle.get_publisher_count())


class Speaker:
    """One publisher of CDR bytes."""

    def __init__(self, node: Node, type_name: str, topic: str, quality: ServiceQuality) -> None:
        self.topic = topic
        self.type_name = type_name
        self._publisher = node.create_publisher(message_class(type_name), topic, quality_profile(quality))
        self.publish = self._publisher.handle.publish_raw

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
        context = node.context.handle
        if context is None:
            raise CocorosimError("rclpy is not initialised, so there is nothing to wait for.")
        with context:
            self._set = rclpy_implementation.WaitSet(most, 0, 0, 0, 0, 0, context)

    def wait(self, listeners: Sequence[Listener], seconds: float) -> None:
        """Return when any of `listeners` has a message, or after `seconds` (at most LONGEST_WAIT)."""
        self._set.clear_entities()
        for listener in listeners:
            self._set.add_subscription(listener.handle)
        self._set.wait(max(0, int(min(seconds, LONGEST_WAIT) * 1e9)))
