"""A run waits until what an external controller says is heard, which its answer to a question shows."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from functools import partial
from types import SimpleNamespace
from typing import Any

import pytest
import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import Header

from cocorosim_ros.graph.nodes import start_line
from cocorosim_ros.graph.nodes.background import run_callbacks, wait_for_callbacks_to_end
from cocorosim_ros.graph.nodes.greeting import Greeting
from cocorosim_ros.graph.nodes.start_line import SETTLING, UNASKED, StartLine
from cocorosim_ros.graph.nodes.wiring import Listener
from cocorosim_ros.wire.topics.service_quality import STREAM

TOPIC = "/lily_01/thruster_command"
LIMIT = 60.0  # s; only a hang takes so long
QUIET = 0.5  # s in which a node that does not look at its services answers nothing


@pytest.fixture
def participant(free_domain: str) -> Iterator[Callable[..., Any]]:
    """Function of a name and options of rclpy's node: a node in a participant of its own, with an executor."""
    contexts: list[Context] = []

    def begin(name: str, **options: Any) -> Any:
        contexts.append(Context())
        rclpy.init(args=[], context=contexts[-1], domain_id=int(free_domain))
        node = rclpy.create_node(name, context=contexts[-1], **options)
        return SimpleNamespace(node=node, context=contexts[-1])

    yield begin
    for context in contexts:
        context.try_shutdown()
    wait_for_callbacks_to_end(LIMIT)


def until(reached: Callable[[], bool], between: Callable[[], Any] = lambda: time.sleep(0.01)) -> bool:
    """Look again and again; False if it is not reached within the limit."""
    end = time.monotonic() + LIMIT
    while not reached():
        if time.monotonic() > end:
            return False
        between()
    return True


@pytest.fixture
def listener(participant: Callable[..., Any]) -> Any:
    """The node that asks, its ear for commands, and the greeting of whoever commands."""
    asking = participant("physics_node")
    run_callbacks(asking.node)
    ear = Listener(asking.node, "std_msgs/msg/Header", TOPIC, STREAM)
    return SimpleNamespace(node=asking.node, ear=ear, greeting=Greeting(asking.node, ear))


def test_an_answer_shows_that_messages_arrive(listener: Any, participant: Callable[..., Any]) -> None:
    """No answer without a publisher, none while it does not look at its services; after it, the message comes."""
    assert not listener.greeting.is_answered()
    other = participant("controller")
    publisher = other.node.create_publisher(Header, TOPIC, 10)
    executor = SingleThreadedExecutor(context=other.context)
    executor.add_node(other.node)
    assert until(lambda: listener.ear.publishers == 1)
    end = time.monotonic() + QUIET
    assert until(lambda: listener.greeting.is_answered() or time.monotonic() > end)
    assert not listener.greeting.is_answered()
    assert until(listener.greeting.is_answered, lambda: executor.spin_once(timeout_sec=0.01))
    publisher.publish(Header(frame_id="first"))
    assert until(lambda: listener.ear.take() is not None)


def test_each_publisher_answers_for_itself(listener: Any, participant: Callable[..., Any]) -> None:
    """Two at once give no answer, and the answer of one that has gone is not that of its successor."""
    first = participant("controller")
    publisher = first.node.create_publisher(Header, TOPIC, 10)
    executor = SingleThreadedExecutor(context=first.context)
    executor.add_node(first.node)
    spin = partial(executor.spin_once, timeout_sec=0.01)
    assert until(listener.greeting.is_answered, spin)
    successor = first.node.create_publisher(Header, TOPIC, 10)
    assert until(lambda: not listener.greeting.is_answered(), spin)
    first.node.destroy_publisher(publisher)
    assert until(lambda: listener.ear.publishers == 1, spin)
    assert not listener.greeting.is_answered()
    assert until(listener.greeting.is_answered, spin)
    successor.publish(Header(frame_id="successor"))
    assert until(lambda: listener.ear.take() is not None)


@pytest.mark.parametrize(("answered", "seconds"), [(True, SETTLING), (False, UNASKED)])
def test_the_run_waits_longer_for_a_node_that_answers_nothing(
    monkeypatch: pytest.MonkeyPatch, answered: bool, seconds: float
) -> None:
    """The run starts when ears have been the same for so long, and not before."""
    clock = SimpleNamespace(now=100.0)
    monkeypatch.setattr(start_line.time, "monotonic", lambda: clock.now)
    monkeypatch.setattr(start_line, "Greeting", lambda *given: SimpleNamespace(is_answered=lambda: answered))
    body = SimpleNamespace(name="lily_01", topics=("compass",))
    speakers = {f"/lily_01/{name}": SimpleNamespace(subscribers=2) for name in ("compass", "pose")}
    answers = [SimpleNamespace(commands=SimpleNamespace(publishers=1))]
    scenario = SimpleNamespace(robots=[SimpleNamespace(external=True)])
    line = StartLine(*(None, scenario, [body], speakers, answers, None))  # type: ignore[arg-type]
    assert not line.everybody_is_there([])
    clock.now += seconds - 0.01
    assert not line.everybody_is_there([])
    clock.now += 0.02
    assert line.everybody_is_there([])
