"""Everything that is used of rclpy beyond its public interface, and whether it is there.

Taking bytes when they are wanted, and sleeping in one wait set until one of a few chosen subscriptions has something,
makes the graph fast: an executor wakes Python once per message and builds a task from each. rclpy promises none of
it. Where it is missing, `executor_path` takes its place.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import Any, cast

from rclpy.callback_groups import CallbackGroup
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile
from rclpy.subscription import Subscription

MODULE = "rclpy.impl.implementation_singleton"


def what_is_missing(node: Node) -> str:
    """Why the fast path cannot be taken with this rclpy, in its own words; empty if it can."""
    try:
        WaitSet(node, 1).wait([], 0.0)
        for owner, name in (
            (_implementation().Subscription, "take_message"),
            (_implementation().Publisher, "publish_raw"),
            (_implementation().WaitSet, "is_ready"),
            (Subscription, "handle"),
            (Publisher, "handle"),
        ):
            getattr(owner, name)
    except (ImportError, AttributeError, TypeError, RuntimeError) as error:
        return str(error).splitlines()[0]
    return ""


def given_parameters(node: Node) -> Mapping[str, Any]:
    """The parameters with which a node was started, declared or not; none where rclpy does not tell."""
    given: Mapping[str, Any] = getattr(node, "_parameter_overrides", {})
    return given


def parameter_services(node: Node) -> None:
    """Give parameter services to a node that was made without; none where rclpy has another way."""
    with suppress(ImportError, AttributeError):
        importlib.import_module("rclpy.parameter_service").ParameterService(node)


def load_type_support(message_class: Any) -> None:
    """Load now what rclpy would otherwise load when the class is first used; does nothing where that is unknown."""
    with suppress(ImportError, AttributeError):
        importlib.import_module("rclpy.type_support").check_for_type_support(message_class)


def publisher_of_bytes(publisher: Any) -> Callable[[bytes], None]:
    """The function that publishes CDR bytes."""
    return cast(Callable[[bytes], None], publisher.handle.publish_raw)


class TakenEar:
    """One subscription whose messages stay in DDS until they are taken."""

    def __init__(self, node: Node, message_class: Any, topic: str, profile: QoSProfile, **options: Any) -> None:
        """`options`: others of `create_subscription`."""
        self._class = message_class
        self.subscription = node.create_subscription(
            message_class, topic, lambda message: None, profile, callback_group=_TakenByHand(), raw=True, **options
        )
        self.handle = self.subscription.handle

    def take(self) -> bytes | None:
        """The next message, or None if there is none."""
        taken = self.handle.take_message(self._class, True)
        return None if taken is None else cast(bytes, taken[0])


class WaitSet:
    """Sleeps until one of at most `most` ears has a message."""

    def __init__(self, node: Node, most: int) -> None:
        context = node.context.handle
        if context is None:
            raise RuntimeError("rclpy is not initialised, so there is nothing to wait for.")
        with context:
            self._set = _implementation().WaitSet(most, 0, 0, 0, 0, 0, context)

    def wait(self, ears: Sequence[TakenEar], seconds: float) -> list[int]:
        """Return the places of those of `ears` that have a message, when there is any, or none after `seconds`."""
        self._set.clear_entities()
        for ear in ears:
            self._set.add_subscription(ear.handle)
        self._set.wait(int(seconds * 1e9))
        return [place for place in range(len(ears)) if self._set.is_ready("subscription", place)]


class _TakenByHand(CallbackGroup):
    """Keeps an executor (the one of the parameter services) away from subscriptions that the node takes itself."""

    def can_execute(self, entity: Any) -> bool:
        return False

    def beginning_execution(self, entity: Any) -> bool:
        return False

    def ending_execution(self, entity: Any) -> None:
        return None


def _implementation() -> Any:
    """The compiled part of rclpy. Raises ImportError or AttributeError where it is elsewhere."""
    return importlib.import_module(MODULE).rclpy_implementation
