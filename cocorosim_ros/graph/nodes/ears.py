"""Nodes beside a recorder's own, over which it spreads its subscriptions.

Each is a participant of DDS of its own. Fast DDS asks every reader of a participant whether a message is meant for it
that has a second reader elsewhere, as what robots hear has: with fifty robots a third of the recorder's time.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager

import rclpy
from rclpy.context import Context
from rclpy.node import Node

from cocorosim_ros.graph.nodes.node_shell import end_nodes
from cocorosim_ros.graph.nodes.rclpy_internals import given_parameters

READERS_OF_ONE = 120  # subscriptions of one participant


@contextmanager
def ears_of(node: Node, topics: int) -> Iterator[list[Node]]:
    """The nodes among which so many subscriptions are shared: `node` first, and hidden ones that end with the block."""
    ears = [_ear(node, number) for number in range(1, math.ceil(topics / READERS_OF_ONE))]
    try:
        yield [node, *ears]
    finally:
        end_nodes(ears)


def _ear(node: Node, number: int) -> Node:
    context = Context()
    rclpy.init(args=[], context=context)
    return Node(
        f"_{node.get_name()}_ear_{number}",  # the underscore hides it from `ros2 node list`
        context=context,
        use_global_arguments=False,
        parameter_overrides=list(given_parameters(node).values()),
        start_parameter_services=False,
        enable_rosout=False,
    )
