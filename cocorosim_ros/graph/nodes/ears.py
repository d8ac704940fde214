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

from cocorosim_ros.graph.nodes.rclpy_internals import given_parameters

READERS_OF_ONE = 120  # subscriptions of one participant


@contextmanager
def ears_of(node: Node, topics: int) -> Iterator[list[Node]]:
    """The nodes among which so many subscriptions are shared: `node` first, and hidden ones that end with the block."""
    contexts = [Context() for _ in range(1, math.ceil(topics / READERS_OF_ONE))]
    try:
        yield [node, *(_ear(node, number, context) for number, context in enumerate(contexts, 1))]
    finally:
        for context in contexts:
            context.try_shutdown()


def _ear(node: Node, number: int, context: Context) -> Node:
    rclpy.init(args=[], context=context)
    return Node(
        f"_{node.get_name()}_ear_{number}",  # the underscore hides it from `ros2 node list`
        context=context,
        use_global_arguments=False,
        parameter_overrides=list(given_parameters(node).values()),
        start_parameter_services=False,
        enable_rosout=False,
    )
