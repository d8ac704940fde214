"""A question to the node behind a topic; its answer proves that what that node publishes reaches this one.

That a publisher is known here does not say that it knows its listener: the two ends discover each other at different
times, and what is published before is lost. Each participant, however, learns the endpoints of another in the order
in which they were made (a reliable built-in topic, DDSI-RTPS 8.5.3), and the ear that waits for the answer is made
after the listener.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from rcl_interfaces.srv import GetParameters
from rclpy.node import Node

from cocorosim_ros.graph.nodes.wiring import Listener

SERVICE = "get_parameters"  # a node has it unless it was made without parameter services
NAME_UNKNOWN = "_NODE_NAME_UNKNOWN_"  # what rmw says before it has heard of the node (rmw_dds_common)


class Publisher(NamedTuple):
    """A publisher of a topic: the whole name of its node, and the mark by which it differs from all others."""

    node: str
    gid: bytes


class Greeting:
    """Asks the node that publishes a topic for no parameters at all, once, and notes that it has answered.

    The answer is taken by the node's executor (`background.run_callbacks`).
    """

    def __init__(self, node: Node, listener: Listener) -> None:
        self._node, self._topic = node, listener.topic
        self._client: Any = None
        self._answer: Any = None
        self._asked: Publisher | None = None

    def is_answered(self) -> bool:
        """Whether the one publisher has answered; asks as soon as it can be asked, and again if it is another one."""
        publisher = self._publisher()
        if publisher != self._asked:
            self._ask_anew(publisher)
        if self._client is not None and self._answer is None and self._client.service_is_ready():
            self._answer = self._client.call_async(GetParameters.Request())
        return self._answer is not None and bool(self._answer.done())

    def _publisher(self) -> Publisher | None:
        """The one that publishes; None if nobody does, or several do, or the name of the node is not known yet."""
        publishers = self._node.get_publishers_info_by_topic(self._topic)
        if len(publishers) != 1 or publishers[0].node_name == NAME_UNKNOWN:
            return None
        name = f"{publishers[0].node_namespace.rstrip('/')}/{publishers[0].node_name}"
        return Publisher(name, bytes(publishers[0].endpoint_gid))

    def _ask_anew(self, publisher: Publisher | None) -> None:
        self._asked, self._answer, self._client = publisher, None, None
        if publisher is not None:
            self._client = self._node.create_client(GetParameters, f"{publisher.node}/{SERVICE}")
