"""Qualities of service that a user gives as parameters, `qos_overrides.TOPIC.publisher.reliability` and so on.

Sensors of real robots often offer best effort, which no reliable subscription takes.
"""

from __future__ import annotations

from rclpy.node import Node
from rclpy.qos_overriding_options import QoSOverridingOptions

from cocorosim_ros.graph.nodes.rclpy_internals import given_parameters

PREFIX = "qos_overrides."


def overriding_options(node: Node, topic: str) -> QoSOverridingOptions | None:
    """What lets history, depth and reliability of a topic be given; None where nobody does, as declaring takes time."""
    if any(name.startswith(f"{PREFIX}{topic}.") for name in given_parameters(node)):
        return QoSOverridingOptions.with_default_policies()
    return None
