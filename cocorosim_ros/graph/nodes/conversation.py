"""Two processes that talk over the middleware: whether they find each other, and how long a question takes.

Run as a program this file is the process that answers; `round_trips` starts it, asks and ends it.
"""

from __future__ import annotations

import inspect
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import rclpy
from rclpy.node import Node
from rclpy.utilities import get_rmw_implementation_identifier
from std_msgs.msg import Header

from cocorosim_ros.graph.nodes.node_shell import end_with_parent, ros_node

_QUESTION, _ANSWER = "/_cocorosim/question", "/_cocorosim/answer"
_MODULE = "cocorosim_ros.graph.nodes.conversation"
_DEPTH = 10
_PROBE = 0.05  # s; how long one look at the middleware lasts
_ENDING = 5.0  # s that the other process gets to say goodbye


def installation() -> tuple[str, str]:
    """Where rclpy lies, and the middleware that it uses."""
    return str(Path(inspect.getfile(rclpy)).parent), get_rmw_implementation_identifier()


def round_trips(count: int, limit: float) -> list[float]:
    """The times [s] from question to answer of so many questions to another process, one after the other.

    limit: seconds of wall clock for all of it. Fewer times, or none, where that was not enough.
    """
    end = time.monotonic() + limit
    line = [sys.executable, "-m", _MODULE, str(os.getpid())]
    other = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        with ros_node("doctor", [], services="never") as node:
            return _asked(node, count, end)
    finally:
        _end(other)


def _asked(node: Node, count: int, end: float) -> list[float]:
    heard: list[str] = []
    question = node.create_publisher(Header, _QUESTION, _DEPTH)

    def hear(message: Header) -> None:
        heard.append(message.frame_id)

    node.create_subscription(Header, _ANSWER, hear, _DEPTH)
    _spin_until(node, lambda: question.get_subscription_count() > 0 and node.count_publishers(_ANSWER) > 0, end)
    times: list[float] = []
    while len(times) < count and time.monotonic() < end:
        name, start = str(len(times)), time.monotonic()
        question.publish(Header(frame_id=name))
        if _spin_until(node, lambda name=name: name in heard, end):  # type: ignore[misc]
            times.append(time.monotonic() - start)
    return times


def _spin_until(node: Node, reached: Callable[[], bool], end: float) -> bool:
    """Look at the middleware until `reached`, or until the time [s] is over; whether it was reached."""
    while not reached() and time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=_PROBE)
    return reached()


def _end(process: subprocess.Popen[bytes]) -> None:
    process.terminate()
    try:
        process.wait(_ENDING)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _answer(parent: int) -> None:
    """Answer every question until this process is ended, by its parent or with it."""
    going = [True]
    signal.signal(signal.SIGTERM, lambda number, frame: going.clear())
    end_with_parent(parent, signal.SIGKILL)
    with ros_node("patient", [], services="never") as node:
        answer = node.create_publisher(Header, _ANSWER, _DEPTH)
        node.create_subscription(Header, _QUESTION, answer.publish, _DEPTH)
        while going:
            rclpy.spin_once(node, timeout_sec=_PROBE)


if __name__ == "__main__":
    _answer(int(sys.argv[1]))
