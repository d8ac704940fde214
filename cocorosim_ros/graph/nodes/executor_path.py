"""Hearing by an executor, with rclpy's public interface alone: slower, and nothing that a new release could take away.

An executor in a thread of its own puts the bytes of every message where the node looks for them when it wants them;
so what a node does, and when, is the same as on the fast path.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from typing import Any

from rclpy.node import Node
from rclpy.qos import QoSProfile

from cocorosim_ros.graph.nodes.background import run_callbacks


def publisher_of_bytes(publisher: Any) -> Callable[[bytes], None]:
    """The function that publishes CDR bytes."""
    publish: Callable[[bytes], None] = publisher.publish
    return publish


class HeardEar:
    """One subscription whose messages are kept as they come in until they are taken."""

    def __init__(self, node: Node, message_class: Any, topic: str, profile: QoSProfile, **options: Any) -> None:
        """`options`: others of `create_subscription`."""
        self.awaited: threading.Event | None = None  # set when a message comes in
        self._heard: deque[bytes] = deque()
        self.subscription = node.create_subscription(message_class, topic, self._hear, profile, raw=True, **options)
        run_callbacks(node)

    @property
    def has_message(self) -> bool:
        """Whether there is something to take."""
        return bool(self._heard)

    def take(self) -> bytes | None:
        """The next message, or None if there is none."""
        return self._heard.popleft() if self._heard else None

    def _hear(self, data: bytes) -> None:
        self._heard.append(data)
        awaited = self.awaited
        if awaited is not None:
            awaited.set()


class Arrival:
    """Sleeps until one of some ears has a message."""

    def __init__(self, node: Node, most: int) -> None:
        self._event = threading.Event()

    def wait(self, ears: Sequence[HeardEar], seconds: float) -> list[int]:
        """Return the places of those of `ears` that have a message, when there is any, or none after `seconds`."""
        self._event.clear()
        for ear in ears:
            ear.awaited = self._event  # before the look, so that nothing comes in unseen between look and sleep
        if not any(ear.has_message for ear in ears):
            self._event.wait(seconds)
        for ear in ears:
            ear.awaited = None
        return [place for place, ear in enumerate(ears) if ear.has_message]
